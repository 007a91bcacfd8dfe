#include <patchgrip/dynamics/trajectory.h>

#include <sstream>
#include <stdexcept>

namespace patchgrip::dynamics {

void refuse_step(double t) {
  std::ostringstream text;
  text.precision(17);
  text << "the motion cannot be followed beyond t = " << t << " s: steps come to nothing, or the state is not finite";
  throw std::runtime_error(text.str());
}

}  // namespace patchgrip::dynamics
