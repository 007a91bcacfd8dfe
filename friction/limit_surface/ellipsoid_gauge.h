// Gauge of a limit surface taken for an ellipsoid, with the proven error of that on either side.
//
//     g(t) = sqrt(t . A t)      about the centre of pressure,      D(v) = sqrt(v . A^-1 v)
//
// A load t holds if g(t) <= mu F_N. Every limit surface of a patch is centrally symmetric, so an ellipsoid about the
// centre of pressure can stand for it. Which one:
//
//     axis           F^2 + M^2 / l^2, the soft-finger ellipsoid of Howe and Cutkosky (1996), with l = M_0 / (mu F_N).
//                    Of discs it touches the surface from outside: never too large, so unsafe, by up to 6.1 % (Hertz),
//                    6.6 % (uniform), 7.7 % (flat punch), 10 % (ring). Of slender patches it errs on either side
//                    (rectangle 10 : 1: 13 % too small, 4.1 % too large), and under a heavy centre with a light far
//                    rim it is too large by up to 41 %.
//     least_squares  A fitted to t . A t = 1 over wrenches of the limit surface.
//     even           the least error of all ellipsoids, to 1e-3: as much too large as too small.
//     inner          of the greatest volume inside the limit surface (John): never too small, so safe.
//     enclosing      of the least volume about it (Loewner): never too large.
//
// The best safe ellipsoid is even().safe(): of all ellipsoids inside it asks for the least excess of grip at worst.
//
// Error    (1 - largest_deficit()) g <= gauge <= (1 + largest_excess()) g for every load, proven by bisection over all
//          directions (support_ratio.h) and above the true maxima by <= slack(), 1e-5 as a rule.
//          even: 3.2 % too large, 3.0 % too small (Hertz disc); 7.1 % and 5.9 % (rectangle 4 : 1).
// Cost     made in 2 to 50 ms.
// Domain   every patch whose pressure lies not in one point (PointLoad); every load.
// Units    wrench [N], [N], [N m]; gauge [N]; the gauge is the least mu F_N that holds the load.
// Throws   std::invalid_argument as CentredFrame::of() (support_function.h); std::domain_error, naming the shape, where
//          the fitted quadric is no ellipsoid.
#pragma once

#include <array>

#include <patchgrip/friction/limit_surface/cheap_gauge.h>

namespace patchgrip::friction {

class EllipsoidGauge {
 public:
  template <Patch P>
  static EllipsoidGauge axis(const P& patch) {
    return make(patch, axis_shape);
  }
  template <Patch P>
  static EllipsoidGauge least_squares(const P& patch) {
    return make(patch, least_squares_shape);
  }
  template <Patch P>
  static EllipsoidGauge even(const P& patch) {
    return make(patch, even_shape);
  }
  template <Patch P>
  static EllipsoidGauge inner(const P& patch) {
    return make(patch, inner_shape);
  }
  template <Patch P>
  static EllipsoidGauge enclosing(const P& patch) {
    return make(patch, enclosing_shape);
  }

  double value(const Wrench& t) const noexcept {
    const double q = squared(t);
    if (in_range(q)) [[likely]]
      return std::sqrt(q);
    return of_load_out_of_range(t, frame_, [this](const Wrench& s) { return std::sqrt(squared(s)); });
  }

  // Twist that the patch slips with under t, normal to the ellipsoid: t . twist = g(t). No load: no twist.
  Twist twist(const Wrench& t) const noexcept { return gauge(t).twist; }

  double dissipation(const Twist& v) const noexcept;  // of the model [m/s]
  Wrench gradient(const Twist& v) const noexcept;     // of the model's dissipation

  Gauge gauge(const Wrench& t) const noexcept;

  double largest_excess() const noexcept { return sides_.largest_excess; }
  double largest_deficit() const noexcept { return sides_.largest_deficit; }
  double slack() const noexcept { return sides_.slack; }

  // The same shape, scaled to touch the limit surface from inside (never too small) or from outside (never too large).
  EllipsoidGauge safe() const { return scaled(1 / (1 - sides_.largest_deficit)); }
  EllipsoidGauge outer() const { return scaled(1 / (1 + sides_.largest_excess)); }

 private:
  // Rows of the upper triangular U, A = U^T U, in the frame: xx, xy, xw, yy, yw, ww.
  using Root = std::array<double, 6>;
  using Shape = Root (*)(const SupportFunction& D);

  static Root axis_shape(const SupportFunction&);
  static Root least_squares_shape(const SupportFunction& D);
  static Root even_shape(const SupportFunction& D);
  static Root inner_shape(const SupportFunction& D);
  static Root enclosing_shape(const SupportFunction& D);

  template <Patch P>
  static EllipsoidGauge make(const P& patch, Shape shape) {
    const auto frame = CentredFrame::of(patch);
    return {frame, support_function(patch, frame), shape};
  }

  EllipsoidGauge(const CentredFrame& frame, const SupportFunction& D, Shape shape);
  EllipsoidGauge scaled(double factor) const;

  double squared(const Wrench& t) const noexcept {  // g(t)^2
    const Wrench s = root_times(frame_.local(t));
    return s.fx * s.fx + s.fy * s.fy + s.m * s.m;
  }
  Wrench root_times(const Wrench& t) const noexcept {
    return {U_[0] * t.fx + U_[1] * t.fy + U_[2] * t.m, U_[3] * t.fy + U_[4] * t.m, U_[5] * t.m};
  }
  Twist inverse_root_times(const Twist& v) const noexcept;  // U^-T v
  SupportValue support(const Twist& local) const noexcept;

  CentredFrame frame_;
  Root U_;
  GaugeSides sides_{};
};

static_assert(GaugeModel<EllipsoidGauge>);

}  // namespace patchgrip::friction
