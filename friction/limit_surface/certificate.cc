#include <patchgrip/friction/limit_surface/certificate.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::friction {

Bracket certify(const PressureFrame& frame, const Wrench& load, const Twist& v, const BoundedWrench& bounded) noexcept {
  constexpr double unit = 0x1p-53;
  const Wrench& g = bounded.value;
  const auto terms = [&](const Wrench& t) {
    return std::fabs(t.fx * v.vx) + std::fabs(t.fy * v.vy) + std::fabs(t.m * v.w);
  };
  const auto force_size = [](const Wrench& t) { return std::hypot(t.fx, t.fy); };
  const double D = power(g, v), tv = power(load, v);
  const double D_error =
      bounded.force_error * std::hypot(v.vx, v.vy) + bounded.moment_error * std::fabs(v.w) + 4 * unit * terms(g);
  const double tv_error = 4 * unit * terms(load);
  Bracket b;
  b.lower = (1 - 4 * unit) * std::max(0.0, (tv - tv_error) / (D + D_error));
  const double k = std::max(0.0, tv / D);
  const Wrench r{load.fx - k * g.fx, load.fy - k * g.fy, load.m - k * g.m};
  const double r_moment = r.m - (frame.x * r.fy - frame.y * r.fx);
  const double arm = std::hypot(frame.x, frame.y);
  const double force_error = k * bounded.force_error + 2 * unit * (force_size(load) + 2 * k * force_size(g));
  const double moment_error = k * bounded.moment_error + 2 * unit * (std::fabs(load.m) + 2 * k * std::fabs(g.m)) +
                              arm * (force_error + 4 * unit * force_size(r));
  b.gap = force_size(r) + std::fabs(r_moment) / frame.least_moment;
  b.rounding = force_error + moment_error / frame.least_moment;
  b.upper = (1 + 8 * unit) * (k + b.gap + b.rounding);
  return b;
}

bool Bracket::narrow(double relative_gap) const noexcept {
  const double width = upper - lower;
  return width <= relative_gap * lower || (gap <= rounding && width <= std::sqrt(relative_gap) * lower);
}

}  // namespace patchgrip::friction
