// Gauge of a limit surface taken for a convex quartic, with the proven error of that on either side.
//
//     g(t)^4 = q(t)      about the centre of pressure,      slip parallel to grad q
//
// (Zhou, Paolini, Bagnell and Mason 2016: the form of least degree that is even and homogeneous, as every limit surface
// is, and not an ellipsoid.) Fitted to q = 1 over wrenches of the limit surface:
//
//     least_squares  to the least mean square of q - 1,
//     even           to the least largest |q - 1|, and so the least error, to 2 %: as much too large as too small.
//
// Both among the quartics that are convex, with a margin: q - e^4 / 100 is convex, e(t) the axis ellipsoid
// (ellipsoid_gauge.h). That is a condition in five hundred directions of the fit (unit_fit.h), and proven for all
// afterwards (quartic_form.h); where the proof fails between two of them, q gives way towards e^4, by as little as
// makes it succeed, and to e^4 itself at the last.
//
// Error    (1 - largest_deficit()) g <= gauge <= (1 + largest_excess()) g for every load, proven by bisection over all
//          directions (support_ratio.h) and above the true maxima by <= slack(), 1e-5 as a rule.
//          even: 0.46 % either way (Hertz disc), 0.45 % (uniform disc), 0.1 % (ring), 0.64 % (square), 2.4 % (rectangle
//          4 : 1), 3.1 % (1000 : 1); two small discs far apart 10 %.
// Cost     made in 0.02 to 0.5 s (even) or 0.005 to 0.2 s (least_squares).
// Domain   every patch whose pressure lies not in one point (PointLoad); every load.
// Units    wrench [N], [N], [N m]; gauge [N]; the gauge is the least mu F_N that holds the load.
// Throws   std::invalid_argument as CentredFrame::of() (support_function.h).
#pragma once

#include <patchgrip/friction/limit_surface/cheap_gauge.h>
#include <patchgrip/friction/limit_surface/quartic_form.h>

namespace patchgrip::friction {

class QuarticGauge {
 public:
  template <Patch P>
  static QuarticGauge least_squares(const P& patch) {
    return make(patch, Fit::least_squares);
  }
  template <Patch P>
  static QuarticGauge even(const P& patch) {
    return make(patch, Fit::even);
  }

  double value(const Wrench& t) const noexcept {
    const double q = q_(frame_.local(t));
    if (in_range(q)) [[likely]]
      return std::sqrt(std::sqrt(q));
    return of_load_out_of_range(t, frame_,
                                [this](const Wrench& s) { return std::sqrt(std::sqrt(q_(frame_.local(s)))); });
  }

  // Twist that the patch slips with under t, normal to the quartic: t . twist = g(t). No load: no twist.
  Twist twist(const Wrench& t) const noexcept { return gauge(t).twist; }

  // Of the model, per unit mu F_N: Newton's method for the wrench whose slip is v.
  double dissipation(const Twist& v) const noexcept;
  Wrench gradient(const Twist& v) const noexcept;

  Gauge gauge(const Wrench& t) const noexcept;

  double largest_excess() const noexcept { return sides_.largest_excess; }
  double largest_deficit() const noexcept { return sides_.largest_deficit; }
  double slack() const noexcept { return sides_.slack; }

  // The same shape, scaled to touch the limit surface from inside (never too small) or from outside (never too large).
  QuarticGauge safe() const { return scaled(1 / (1 - sides_.largest_deficit)); }
  QuarticGauge outer() const { return scaled(1 / (1 + sides_.largest_excess)); }

 private:
  enum class Fit { least_squares, even };

  template <Patch P>
  static QuarticGauge make(const P& patch, Fit fit) {
    const auto frame = CentredFrame::of(patch);
    return {frame, support_function(patch, frame), fit};
  }

  QuarticGauge(const CentredFrame& frame, const SupportFunction& D, Fit fit);
  QuarticGauge scaled(double factor) const;
  SupportValue support(const Twist& local) const noexcept;

  CentredFrame frame_;
  QuarticForm q_{};
  GaugeSides sides_{};
};

static_assert(GaugeModel<QuarticGauge>);

}  // namespace patchgrip::friction
