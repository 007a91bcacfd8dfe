#include <patchgrip/friction/limit_surface/pressure_frame.h>

#include <algorithm>
#include <cmath>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {

PressureFrame::PressureFrame(const PatchView& patch, const PressureMoments& moments)
    : x(moments.x), y(moments.y), length(std::sqrt(contact::require_positive("polar", moments.polar))) {
  constexpr double unit = 0x1p-53;
  // A translation along e has the second moment along e, over its speed, for d2D / dw2 about the centroid.
  const auto spread = [&](double ex, double ey) {
    Hessian h;
    if (!patch.hessian(patch.patch, {ex, ey, 0}, h)) return 0.5;
    const double ww = h.ww + y * (2 * h.xw + y * h.xx - x * h.xy) - x * (2 * h.yw + y * h.xy - x * h.yy);
    return ww / moments.polar;
  };
  xx = spread(1, 0);
  yy = spread(0, 1);
  xy = spread(std::sqrt(0.5), std::sqrt(0.5)) - (xx + yy) / 2;
  const BoundedWrench g = patch.gradient(patch.patch, twist_about({x, y}, 1));
  const double arm = std::fabs(x) + std::fabs(y);
  const double S = g.value.m - (x * g.value.fy - y * g.value.fx);
  const double S_error = g.moment_error + arm * (g.force_error + 4 * unit) + 2 * unit * std::fabs(g.value.m);
  const double slope = std::hypot(g.value.fx, g.value.fy) + g.force_error;
  least_moment = (1 - 4 * unit) * (S - S_error) * std::max(0.5, 1 - slope);
}

}  // namespace patchgrip::friction
