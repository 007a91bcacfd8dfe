#include <patchgrip/bench/gsl_quadrature.h>

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace patchgrip::bench {

GslQuadrature::GslQuadrature(double radius, double tolerance)
    : radius_(radius), tolerance_(tolerance), outer_(gsl_workspace()), inner_(gsl_workspace()) {
  gsl_set_error_handler_off();  // where rounding ends the refinement, the value is kept as it is
}

template <class Integrand>
double GslQuadrature::integral(double x, const Integrand& integrand) const {
  const auto ring = [&](double r) {
    const auto arc = [&](double phi) {
      const double s = std::sin(phi / 2);
      const double d = std::sqrt((r - x) * (r - x) + 4 * r * x * s * s);
      return d > 0 ? integrand(r, std::cos(phi)) / d : 0.0;
    };
    const double around = adaptive(arc, 0, std::numbers::pi, tolerance_ / 10, inner_);
    return 3 / std::numbers::pi * std::sqrt((1 - r) * (1 + r)) * r * around;
  };
  const double split = std::min(x, 1.0);
  double sum = adaptive(ring, 0, split, tolerance_, outer_);
  if (split < 1) sum += adaptive(ring, split, 1, tolerance_, outer_);
  return sum;
}

friction::Wrench GslQuadrature::gradient(const friction::Twist& v) const {
  const double speed = std::hypot(v.vx, v.vy);
  const double x = speed / (radius_ * std::fabs(v.w));
  const double force = integral(x, [x](double r, double c) { return x - r * c; });
  const double moment = integral(x, [x](double r, double c) { return r * r - r * x * c; });
  return {force * v.vx / speed, force * v.vy / speed, std::copysign(radius_ * moment, v.w)};
}

}  // namespace patchgrip::bench
