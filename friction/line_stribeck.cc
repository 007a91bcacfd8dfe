// Stribeck's excess of a line load.
//
// Turning by |w| with the speed u = |vx| along it, its points slide at rho = u cosh(t) and across it at s = u sinh(t),
// dt = |w| dx / rho; so nothing is singular in t, wherever the pole is:
//
//     E = (1 / |w| L) int exp(-rho^2) [vx, s, x s] dt
//
// (fx is an incomplete Bessel function, which has no closed form.) From an end, where s_0 and q_0 are s and rho,
//
//     s = (p e^d - r e^-d) / 2,   rho = (p e^d + r e^-d) / 2,   p = q_0 + s_0,   r = q_0 - s_0,   d = t - t_0
//
// and the way from it along the line is (p (e^d - 1) + r (1 - e^-d)) / 2 |w|: all terms of rho and of the way are
// positive. The whole of t is 2 x A (kernels/line_motion.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <patchgrip/friction/kernels/line_motion.h>
#include <patchgrip/friction/kernels/vector_quadrature.h>
#include <patchgrip/friction/line_load.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/stribeck_excess.h>

namespace patchgrip::friction {
namespace {

constexpr double unit = 0x1p-53;

// The line seen from one end: how it slides after d of t.
struct LineEnd {
  // `s` points from the end into the line.
  LineEnd(double u, double s) {
    const double q = std::hypot(u, s), larger = q + std::fabs(s), smaller = u * (u / larger);
    p = s > 0 ? larger : smaller;
    r = s > 0 ? smaller : larger;
  }

  double p, r;
};

struct Sliding {
  double s, rho, way;
};

Sliding after(const LineEnd& end, double d) noexcept {
  const double forth = end.p * std::exp(d), back = end.r * std::exp(-d);
  return {(forth - back) / 2, (forth + back) / 2, (end.p * std::expm1(d) - end.r * std::expm1(-d)) / 2};
}

}  // namespace

BoundedWrench stribeck_excess(const LineLoad& line, const Twist& u) noexcept {
  const double sign = std::copysign(1.0, u.w), L = line.length(), w = std::fabs(u.w), l = w * L;
  const double fastest = std::hypot(u.vx, u.vy) + l / 2;
  if (!std::isfinite(fastest)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {{nan, nan, nan}, nan, nan};
  }
  constexpr double slow = 1e-10;  // exp(-rho^2) is 1, to rounding
  if (fastest < slow) return line.bounded_gradient(u);
  constexpr double spun = 1e-290;  // of `slow`: nothing, where l soon has no full digits
  if (l < spun) {
    BoundedWrench g = stribeck_excess(PointLoad{}, u);  // about the centroid
    g.moment_error += l;
    return g;
  }
  const double vx = sign * u.vx, vy = sign * u.vy;
  const double s0 = std::fma(-w, L / 2, vy), s1 = std::fma(w, L / 2, vy);
  // A pole on the line is as one that is next to it.
  constexpr double next = 1e-25;
  const double along = std::max(std::fabs(vx), next * (std::fabs(s0) + std::fabs(s1)));
  const double whole = [&] {
    const kernels::LineMotion<double> motion(along, vy, w, L);
    return 2 * motion.x * motion.A;
  }();
  const LineEnd first(along, s0), last(along, -s1);
  const auto at = [&](double from_first, double to_last) -> std::array<double, 3> {
    double s, rho, x;  // x in half lengths from the centre
    if (from_first < to_last) {
      const Sliding here = after(first, from_first);
      s = here.s, rho = here.rho, x = 2 * (here.way / l) - 1;
    } else {
      const Sliding here = after(last, to_last);
      s = -here.s, rho = here.rho, x = 1 - 2 * (here.way / l);
    }
    const double k = std::exp(-rho * rho) / l;
    return {k * vx, k * s, k * s * x};
  };
  // Cuts at the foot of the pole and where exp(-rho^2) falls: beyond the last nothing is left.
  constexpr double falls = 1, gone = 6.5;
  const double foot = std::asinh(-s0 / along);
  const auto reach = [&](double rho) { return rho > along ? std::acosh(rho / along) : 0; };
  std::array<double, 7> cuts{
      0, foot - reach(gone), foot - reach(falls), foot, foot + reach(falls), foot + reach(gone), whole};
  for (double& cut : cuts) cut = std::clamp(cut, 0.0, whole);
  BoundedWrench g;
  double across_error = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const auto [value, error] = kernels::integrate<3>(
        [&, lo = cuts[i], rest = whole - cuts[i + 1]](double from, double to) { return at(lo + from, rest + to); },
        cuts[i], cuts[i + 1]);
    g.value.fx += value[0];
    g.value.fy += value[1];
    g.value.m += value[2];
    g.force_error += error[0];
    across_error += error[1];
    g.moment_error += error[2];
  }
  // Speeds, ways and t are rounded.
  constexpr double rounding = 16 * unit;
  g.force_error += across_error + rounding;
  g.moment_error = (L / 2) * (g.moment_error + rounding);
  g.value = {sign * g.value.fx, sign * g.value.fy, sign * (L / 2) * g.value.m};
  return g;
}

}  // namespace patchgrip::friction
