#include <patchgrip/contact/smooth_profile.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include <patchgrip/contact/endpoint_quadrature.h>
#include <patchgrip/contact/increasing_root.h>

namespace patchgrip::contact {
namespace {

constexpr double quarter = std::numbers::pi / 2;

double accepted(const char* name, const Estimate& result, double tolerance) {
  // Half of it, since some results are integrals of others.
  if (result.error <= tolerance / 2 * std::fabs(result.value)) return result.value;
  std::ostringstream message;
  message << name << " not integrated: estimated error " << result.error << " of " << result.value << ", wanted "
          << tolerance << " of it";
  throw std::runtime_error(message.str());
}

}  // namespace

SmoothProfile SmoothProfile::of(SmoothShape shape, double max_radius, double tolerance) {
  require_positive("max_radius", max_radius);
  require_in("tolerance", tolerance, 1e-11, 1e-3);
  return {std::move(shape), max_radius, tolerance};
}

double SmoothProfile::approach(double a) const {
  const auto f = [&](double t, double) { return shape_.slope(a * std::sin(t)); };
  return a * accepted("approach", bounded_integral(f, 0., quarter), tolerance_);
}

double SmoothProfile::approach_slope(double a) const {
  const auto f = [&](double t, double) {
    const double r = a * std::sin(t);
    return shape_.slope(r) + r * shape_.curvature(r);
  };
  return accepted("slope of approach", bounded_integral(f, 0., quarter), tolerance_);
}

double SmoothProfile::force(double a) const {
  const auto f = [&](double t, double) {
    const double s = std::sin(t);
    return s * s * shape_.slope(a * s);
  };
  return 2 * a * a * accepted("force", bounded_integral(f, 0., quarter), tolerance_);
}

double SmoothProfile::pressure(double r, double a) const {
  const double end = std::sqrt(a - r) * std::sqrt(a + r);
  const auto f = [&](double z, double) {
    const double x = std::hypot(r, z);
    return approach_slope(x) / x;
  };
  return accepted("pressure", bounded_integral(f, 0., end), tolerance_) / std::numbers::pi;
}

double SmoothProfile::displacement(double r, double a) const {
  if (r <= a) return approach(a) - height(r);
  const auto f = [&](double x, double left) {
    return approach_slope(x) * std::atan(x / (std::sqrt(r - a + left) * std::sqrt(r + x)));
  };
  return 2 / std::numbers::pi * accepted("displacement", bounded_integral(f, 0., a), tolerance_);
}

double SmoothProfile::radius_of_approach(double approach) const {
  require_in("approach", approach, 0, this->approach(max_radius_));
  return increasing_root([&](double a) { return this->approach(a); }, [&](double a) { return approach_slope(a); },
                         approach, max_radius_ / 2, 0, max_radius_);
}

double SmoothProfile::radius_of_force(double force) const {
  require_in("force / modulus", force, 0, this->force(max_radius_));
  return increasing_root([&](double a) { return this->force(a); }, [&](double a) { return 2 * a * approach_slope(a); },
                         force, max_radius_ / 2, 0, max_radius_);
}

}  // namespace patchgrip::contact
