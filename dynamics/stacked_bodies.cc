#include <patchgrip/dynamics/stacked_bodies.h>

#include <sstream>
#include <stdexcept>

namespace patchgrip::dynamics {

Matrix6 stack_motion(const Vector6& place) {
  const double c = std::cos(place[2]), s = std::sin(place[2]);
  Matrix3 back;  // R_1^T
  back << c, s, 0, -s, c, 0, 0, 0, 1;
  Matrix3 T = Matrix3::Identity();
  T(0, 2) = -(place[4] - place[1]);
  T(1, 2) = place[3] - place[0];
  Matrix6 G = Matrix6::Identity();
  G.block<3, 3>(3, 0) = -back * T;
  G.block<3, 3>(3, 3) = back;
  return G;
}

void refuse_sweeps(double t) {
  std::ostringstream text;
  text.precision(17);
  text << "the stack cannot be followed to t = " << t << " s: its interfaces do not settle between each other";
  throw std::runtime_error(text.str());
}

}  // namespace patchgrip::dynamics
