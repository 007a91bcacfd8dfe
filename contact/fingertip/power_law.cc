#include <patchgrip/contact/fingertip/power_law.h>
#include <patchgrip/contact/require.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/math/distributions/students_t.hpp>

namespace patchgrip::contact {
namespace {

using Real = long double;

// Student's factor of the two-sided interval.
double student(int points, double confidence) {
  require_in("confidence", confidence, 0, 1, Ends::open);
  if (points < 3)
    refuse("points", points, "must be at least 3 for limits: two points lie on a line whatever their error");
  return boost::math::quantile(boost::math::complement(boost::math::students_t(points - 2), (1 - confidence) / 2));
}

}  // namespace

PowerLaw PowerLaw::of(double c, double gamma) {
  return {require_positive("c", c), require_non_negative("gamma", gamma)};
}

double PowerLaw::contact_radius(double normal_force) const {
  return c * std::pow(require_non_negative("normal_force", normal_force), gamma);
}

double PowerLaw::normal_force(double contact_radius) const {
  require_positive("gamma", gamma);
  return std::pow(require_non_negative("contact_radius", contact_radius) / c, 1 / gamma);
}

PowerLawFit PowerLawFit::to(std::span<const MeasuredRadius> points) {
  const auto n = static_cast<Real>(points.size());
  if (points.size() < 2) refuse("points", static_cast<double>(points.size()), "must be at least 2");
  std::vector<Real> x, y;
  Real mean_x = 0, mean_y = 0, largest = 1;
  for (const auto& point : points) {
    x.push_back(std::log(Real(require_positive("normal_force", point.normal_force))));
    y.push_back(std::log(Real(require_positive("contact_radius", point.contact_radius))));
    largest = std::max({largest, std::fabs(x.back()), std::fabs(y.back())});
    mean_x += x.back() / n;
    mean_y += y.back() / n;
  }
  Real xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (!(std::sqrt(xx / n) > 0x1p-50L * (1 + std::fabs(mean_x)))) {
    refuse("normal_force", points.front().normal_force, "must differ between the points");
  }
  const auto [least, most] = std::ranges::minmax(x);
  const Real gamma = xy / xx;
  if (!(gamma > 0)) refuse("gamma", static_cast<double>(gamma), "must be positive: radii grow with the force");
  const Real log_c = mean_y - gamma * mean_x;
  Real squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Real residual = (y[i] - mean_y) - gamma * (x[i] - mean_x);
    squares += residual * residual;
  }
  const Real variance = points.size() > 2 ? squares / (n - 2) : 0;
  const double c = require_representable("c", static_cast<double>(std::exp(log_c)));
  return {{c, static_cast<double>(gamma)},
          static_cast<double>(std::sqrt(squares / n)),
          static_cast<double>(std::sqrt(variance / xx)),
          static_cast<double>(std::sqrt(variance * (1 / n + mean_x * mean_x / xx))),
          static_cast<double>(mean_x),
          static_cast<double>(std::sqrt(variance / n)),
          static_cast<int>(points.size()),
          static_cast<double>(most - least),
          static_cast<double>(1.6L + 0x1p-7L * largest * largest / (most - least))};
}

Limits PowerLawFit::gamma_limits(double confidence) const {
  const double half = student(points, confidence) * gamma_spread;
  return {law.gamma - half, law.gamma + half};
}

Limits PowerLawFit::c_limits(double confidence) const {
  const double factor = std::exp(student(points, confidence) * log_c_spread);
  return {law.c / factor, law.c * factor};
}

Limits PowerLawFit::radius_limits(double normal_force, double confidence) const {
  const double from_mean = std::log(require_positive("normal_force", normal_force)) - mean_log;
  const double factor = std::exp(student(points, confidence) * std::hypot(mean_spread, from_mean * gamma_spread));
  const double radius = law.contact_radius(normal_force);
  return {radius / factor, radius * factor};
}

}  // namespace patchgrip::contact
