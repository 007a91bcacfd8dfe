#include <patchgrip/contact/round_pressure.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <patchgrip/contact/endpoint_quadrature.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {
namespace {

double checked(double pressure) {
  if (std::isnan(pressure)) throw std::runtime_error("pressure is not a number inside the contact");
  return pressure;
}

}  // namespace

RoundPressure RoundPressure::of(double contact_radius, double contact_modulus,
                                std::function<double(double, double)> pressure) {
  return {require_positive("contact_radius", contact_radius), require_positive("contact_modulus", contact_modulus),
          std::move(pressure)};
}

Estimate RoundPressure::force() const {
  const auto f = [this](double r, double left) { return r * checked(pressure_(r, left)); };
  const auto result = bounded_integral(f, 0., radius_);
  return {2 * std::numbers::pi * result.value, 2 * std::numbers::pi * result.error};
}

// t^2 = x^2 + z^2 removes the root; a - t = (Z - z)(Z + z) / (a + t).
Estimate RoundPressure::density(double x, double before_rim) const {
  const double end = std::sqrt(before_rim) * std::sqrt(radius_ + x);
  const auto f = [&](double z, double left) {
    const double t = std::hypot(x, z);
    return checked(pressure_(t, left * ((end + z) / (radius_ + t))));
  };
  const auto result = bounded_integral(f, 0., end);
  return {result.value, result.error};
}

// x = r sin t.
Estimate RoundPressure::displacement(double r) const {
  require_non_negative("r", r);
  double inner = 0;
  const auto density_at = [&](double x, double before_rim) {
    if (!(before_rim > 0)) return 0.;
    const Estimate G = density(x, before_rim);
    inner = std::max(inner, G.error);
    return G.value;
  };
  const double scale = 4 / (std::numbers::pi * modulus_);
  double last = std::numbers::pi / 2;
  Estimate result{};
  if (r <= radius_) {
    const double before = radius_ - r;
    const auto f = [&](double, double left) {
      return density_at(r * std::cos(left), before + 2 * r * std::pow(std::sin(left / 2), 2));
    };
    result = bounded_integral(f, 0., last);
  } else {
    last = std::atan(radius_ / (std::sqrt(r - radius_) * std::sqrt(r + radius_)));
    const auto f = [&](double t, double left) {
      return density_at(r * std::sin(t), 2 * r * std::sin(left / 2) * std::cos(last - left / 2));
    };
    result = bounded_integral(f, 0., last);
  }
  return {scale * result.value, scale * (result.error + last * inner)};
}

Estimate RoundPressure::height(double r) const {
  require_in("r", r, 0, radius_);
  const Estimate middle = displacement(0);
  const Estimate here = displacement(r);
  return {middle.value - here.value, middle.error + here.error + 0x1p-53 * middle.value};
}

}  // namespace patchgrip::contact
