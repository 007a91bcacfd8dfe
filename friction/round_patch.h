// Friction of a round patch about its own centre: everything that does not depend on the pressure.
//
// With V = |(vx, vy)|, W = a |w| and x = V / W = r_M / a, a round pressure has D = V f(x) + W m(x), and
//
//     grad D = (f vx / V, f vy / V, a m sgn w),        m = S - x S',  f = S'            (seed 4.47, 4.54)
//     Hess D from  f' = S'':  along v  f' / W,  across v  f / V,  with w  -x f' / W,  in w  a^2 x^2 f' / W
//
// What the pressure contributes is a Kernel: f / x and m up to the rim, f and m / u beyond (u = 1/x), and f'. It is
// given V^2 and W^2, so the pole is never formed and a pure translation (w = 0) is a twist like any other.
//
// Units    a [m]; twist as in twist.h; D [m/s], force [1], moment [m], per mu F_N = 1 N.
// Error    force and moment each <= 8 units of 2^-53 of their own size at every pole: rim, far field and infinity
//          included. Measured: tests/friction/round_patch_test.cc, and `bounds --cases 100000`.
// Fails    results below 1e-290 of their scale are not relatively exact.
// Throws   hessian(): std::domain_error at rest, for a twist that is not finite, and with the pole on the rim of a
//          pressure that makes it infinite there (a ring).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <patchgrip/friction/patch.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::friction {

// A twist as a round patch of radius a sees it.
struct RoundTwist {
  RoundTwist(const Twist& v, double a) noexcept
      : vx(v.vx), vy(v.vy), w(v.w), radius(a), V2(vx * vx + vy * vy), W(a * std::fabs(w)), W2(W * W) {}

  double vx, vy, w, radius;
  double V2;  // V^2
  double W;   // a |w|
  double W2;
};

// V^2 - W^2 without the rounding of either: near the rim a pressure that is singular there sees nothing else.
double rim_excess(double vx, double vy, double w, double radius) noexcept;

// Force = force_per_speed * (vx, vy); moment = a * moment_per_radius * sgn w.
struct RoundGradient {
  double force_per_speed;
  double moment_per_radius;
};

// What a kernel says of the limit curve of unit radius at a pole: f, m and f' inside, f' / u^3 outside, where `bend` is
// the derivative of that by u if it is known and bounded.
struct CurvePoint {
  double f, m, slope;
  double bend = std::numeric_limits<double>::quiet_NaN();
};

template <class Kernel>
class RoundPatch {
 public:
  double dissipation(const Twist& v) const noexcept {
    const Scaled s = scaled(v);
    const Wrench g = gradient(s.twist);
    return s.scale * power(g, s.twist);  // two terms, both positive
  }

  Wrench gradient(const Twist& v) const noexcept {
    const RoundTwist t(v, radius_);
    const double size = std::max(t.V2, t.W2);
    if (!(size > smallest && size < largest)) [[unlikely]]
      return rescaled_gradient(v);
    const RoundGradient g = kernel_.gradient(t);
    return {g.force_per_speed * v.vx, g.force_per_speed * v.vy, std::copysign(radius_ * g.moment_per_radius, v.w)};
  }

  BoundedWrench bounded_gradient(const Twist& v) const noexcept {
    constexpr double relative = 8 * 0x1p-53;
    const Wrench g = gradient(v);
    return {g, relative * std::hypot(g.fx, g.fy), relative * std::fabs(g.m)};
  }

  Hessian hessian(const Twist& v) const {
    if (std::isnan(finite_or_nan(v).w))
      throw std::domain_error("twist is not finite: the Hessian of D exists only for finite twists");
    const Scaled s = scaled(v);
    const RoundTwist t(s.twist, radius_);
    if (t.V2 == 0 && t.W == 0)
      throw std::domain_error("twist = 0 is not allowed: the Hessian of D exists only in motion");
    const double V = std::sqrt(t.V2);
    const double ex = V > 0 ? t.vx / V : 1;
    const double ey = V > 0 ? t.vy / V : 0;
    const double slope = kernel_.slope(t);  // f' inside, f' / u^3 outside
    const double across = kernel_.gradient(t).force_per_speed;
    double along, mixed, spin;
    if (kernel_.pole_inside(t)) {
      along = slope / t.W;
      mixed = V / t.W * along;
      spin = V / t.W * mixed;
    } else {
      const double u = t.W / V;
      along = u * u * slope / V;
      mixed = u * slope / V;
      spin = slope / V;
    }
    if (!std::isfinite(along))
      throw std::domain_error("twist has its pole on the rim: the Hessian of D is infinite there");
    mixed = -std::copysign(radius_ * mixed, t.w);
    spin *= radius_ * radius_;
    const double k = s.inverse;
    return {k * (along * ex * ex + across * ey * ey),
            k * (along - across) * ex * ey,
            k * mixed * ex,
            k * (along * ey * ey + across * ex * ex),
            k * mixed * ey,
            k * spin};
  }

  PressureMoments moments() const noexcept { return {0, 0, polar_ * radius_ * radius_}; }
  double area_radius() const noexcept { return radius_; }
  double radius() const noexcept { return radius_; }
  const Kernel& kernel() const noexcept { return kernel_; }

 protected:
  RoundPatch(double radius, double polar, Kernel kernel) : radius_(radius), polar_(polar), kernel_(std::move(kernel)) {}

 private:
  // Squares of speeds stay finite and normal in this range.
  static constexpr double smallest = 0x1p-900;
  static constexpr double largest = 0x1p900;

  struct Scaled {
    Twist twist;
    double scale;    // v = scale * twist
    double inverse;  // 1 / scale
  };

  Scaled scaled(const Twist& v) const noexcept {
    const double size = std::max({std::fabs(v.vx), std::fabs(v.vy), radius_ * std::fabs(v.w)});
    if (!(size > 0) || !std::isfinite(size)) return {v, 1, 1};
    const int e = std::ilogb(size);
    return {{std::scalbn(v.vx, -e), std::scalbn(v.vy, -e), std::scalbn(v.w, -e)},
            std::scalbn(1.0, e),
            std::scalbn(1.0, -e)};
  }

  [[gnu::noinline]] Wrench rescaled_gradient(const Twist& v) const noexcept {
    const Twist s = scaled(v).twist;
    if (s.vx == 0 && s.vy == 0 && s.w == 0) return {};
    const RoundTwist t(s, radius_);
    if (!(std::max(t.V2, t.W2) > smallest && std::max(t.V2, t.W2) < largest)) {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      return {nan, nan, nan};
    }
    return gradient(s);
  }

  double radius_;  // a [m]
  double polar_;   // <r^2> / a^2
  Kernel kernel_;
};

}  // namespace patchgrip::friction
