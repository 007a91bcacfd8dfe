#include <patchgrip/friction/limit_surface/central_moment.h>

#include <cmath>
#include <limits>
#include <sstream>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {

CentralMoment::CentralMoment(const BoundedWrench& spinning, double x, double y) {
  constexpr double unit = 0x1p-53;
  const Wrench& g = spinning.value;
  value = g.m - (x * g.fy - y * g.fx);
  error = spinning.moment_error + (std::fabs(x) + std::fabs(y)) * (spinning.force_error + 4 * unit) +
          2 * unit * std::fabs(g.m);
  if (!(value > error)) {
    std::ostringstream rule;
    rule.precision(std::numeric_limits<double>::digits10);
    rule << "about (" << x << ", " << y
         << ") m it must exceed its error by rounding, or the patch is a point as seen from its origin";
    contact::refuse("moment about the centre of pressure", value, rule.str());
  }
}

}  // namespace patchgrip::friction
