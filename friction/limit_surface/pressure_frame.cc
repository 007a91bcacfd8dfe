#include <patchgrip/friction/limit_surface/pressure_frame.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/limit_surface/central_moment.h>

namespace patchgrip::friction {

PressureFrame::PressureFrame(const PatchView& patch, const PressureMoments& moments, std::vector<PointShare> shares)
    : x(moments.x),
      y(moments.y),
      length(std::sqrt(contact::require_positive("polar", moments.polar))),
      kinks(kinks_of(patch, std::move(shares), length)) {
  constexpr double unit = 0x1p-53;
  // A translation along e has the second moment along e, over its speed, for d2D / dw2 about the centroid.
  const auto spread = [&](double ex, double ey) {
    Hessian h;
    if (!patch.hessian(patch.patch, {ex, ey, 0}, h)) return 0.5;
    return about_centroid(h).ww;
  };
  xx = spread(1, 0);
  yy = spread(0, 1);
  xy = spread(std::sqrt(0.5), std::sqrt(0.5)) - (xx + yy) / 2;
  const BoundedWrench g = patch.gradient(patch.patch, twist_about({x, y}, 1));
  const double arm = std::fabs(x) + std::fabs(y);
  // Of about 1 / 4 at most: d2D / dw2 of three translations, some eight roundings each, as large as their terms are
  // about the origin.
  constexpr double roundings = 64;
  spread_error = roundings * unit * std::pow(1 + arm / length, 2);
  const CentralMoment S(g, x, y);
  const double slope = std::hypot(g.value.fx, g.value.fy) + g.force_error;
  least_moment = (1 - 4 * unit) * (S.value - S.error) * std::max(0.5, 1 - slope);
}

Twist PressureFrame::about_origin(const Vector& u) const noexcept {
  const double w = u[2] / length;
  return {std::fma(w, y, u[0]), std::fma(-w, x, u[1]), w};
}

// v_origin = A v_c, A = [1 0 y; 0 1 -x; 0 0 1], then spins scaled: A^T H A.
Hessian PressureFrame::about_centroid(const Hessian& h) const noexcept {
  const double xw = h.xw + y * h.xx - x * h.xy;
  const double yw = h.yw + y * h.xy - x * h.yy;
  const double ww = h.ww + y * (h.xw + xw) - x * (h.yw + yw);
  return {h.xx, h.xy, xw / length, h.yy, yw / length, ww / (length * length)};
}

}  // namespace patchgrip::friction
