// Pade forms of the friction of a round patch: the cheapest wrench as a function of the twist.
//
// With V = |(vx, vy)|, W = a |w|, the slope s = f'(0) of the force at the centre, M_0 = m(0) and the far moment
// m = a k W / V, k = <r^2> / (2 a^2), all per mu F_N (Zhuravlev 1998; of second order, Zhuravlev and Kireenkov 2005):
//
//     first order    f = V / (V + W / s)
//                    m = M_0 W / (W + (M_0 / a k) V)
//     second order   f = (V^2 + V W / s) / (V^2 + V W / s + W^2 / s^2)
//                    m = M_0 (W^2 + b V W) / (W^2 + b V W + c V^2),   c = a s / (2 M_0),   b = c a k / M_0
//
// First order meets f, f', m, and m far away where either speed vanishes (Hertz: s = 3 pi/8, M_0 = 3 pi a/16, k = 1/5,
// so f = V / (V + 8/(3 pi) W) and m = M_0 W / (W + 15 pi/16 V)). Second order meets f''(0) = 0, m'(0) = 0 and
// m''(0) = -a s too.
//
// No dissipation has these wrenches for its gradient: there is no limit surface of theirs, no Hessian, and no principle
// of maximum dissipation. For a Hertz disc their power is between 0.57 D and D (first order), or between 0.94 D and
// 1.001 D (second order), so that second order may also take more than Coulomb friction can. First order has a kink at
// w = 0 that the exact force has not (1 - f ~ |w|).
//
// Domain   round patches about their own centre; every twist.
// Units    V, W [m/s]; force [1], moment [m], per mu F_N = 1 N.
// Error    |f - f_exact| <= force_error(), |m - m_exact| <= moment_error(), proven where the form is made: f rises and
//          m falls with V / W in either, so their values at the ends of an interval bound the error within it.
//          Hertz, first order: 0.344, and 0.392 M_0; second order: 0.165, and 0.200 M_0.
#pragma once

#include <cmath>
#include <concepts>
#include <functional>

#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

template <class P>
concept RoundPressure = Patch<P> && requires(const P& disc) {
  { disc.radius() } -> std::same_as<double>;
  disc.kernel();
};

class PadeWrench {
 public:
  template <RoundPressure P>
  static PadeWrench first_order(const P& disc) {
    return make(disc, 1);
  }
  template <RoundPressure P>
  static PadeWrench second_order(const P& disc) {
    return make(disc, 2);
  }

  Wrench gradient(const Twist& v) const noexcept {
    const double V = std::sqrt(v.vx * v.vx + v.vy * v.vy), W = radius_ * std::fabs(v.w);
    if (V == 0 && W == 0) return {};
    const RoundValue g = value(V, W);
    return {g.force_per_speed * v.vx, g.force_per_speed * v.vy, std::copysign(g.moment, v.w)};
  }

  BoundedWrench bounded_gradient(const Twist& v) const noexcept { return {gradient(v), force_error_, moment_error_}; }

  // Power of the wrench, not of a potential.
  double dissipation(const Twist& v) const noexcept { return power(gradient(v), v); }

  PressureMoments moments() const noexcept { return {0, 0, 2 * far_ * radius_ * radius_}; }
  double area_radius() const noexcept { return radius_; }

  double force_error() const noexcept { return force_error_; }    // [1]
  double moment_error() const noexcept { return moment_error_; }  // [m]

 private:
  struct RoundValue {
    double force_per_speed;
    double moment;
  };
  using Exact = std::function<Wrench(const Twist&)>;

  template <RoundPressure P>
  static PadeWrench make(const P& disc, int order) {
    const double a = disc.radius();
    const PressureMoments s = disc.moments();
    return {order,
            a,
            a * disc.hessian({0, 0, 1}).xx,
            disc.gradient({0, 0, 1}).m,
            s.polar / (2 * a * a),
            [&disc](const Twist& v) { return disc.gradient(v); }};
  }

  PadeWrench(int order, double radius, double slope, double spin_moment, double far, const Exact& exact);

  RoundValue value(double V, double W) const noexcept {
    if (order_ == 1) return {1 / (V + lag_ * W), spin_moment_ * W / (W + lead_ * V)};
    const double f = V + lag_ * W, m = W * (W + mixed_ * V);
    return {f / (V * f + lag_ * lag_ * W * W), spin_moment_ * m / (m + lead_ * V * V)};
  }

  int order_;
  double radius_;       // a [m]
  double spin_moment_;  // M_0 [m]
  double far_;          // k
  double lag_;          // 1 / s
  double lead_;         // M_0 / (a k) or c
  double mixed_;        // b
  double force_error_ = 0, moment_error_ = 0;
};

}  // namespace patchgrip::friction
