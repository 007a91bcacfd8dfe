#include <patchgrip/friction/limit_surface/hertz_gauge.h>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {

HertzGauge HertzGauge::of_radius(double radius) { return HertzGauge(contact::require_positive("radius", radius)); }

GaugeAndTwist HertzGauge::rescaled_slip(const Wrench& load) const noexcept {
  if (const auto known = trivial_gauge(load)) return {known->value, known->twist};
  const ScaledLoad scaled(load, radius_);
  GaugeAndTwist g = slip(scaled.load);
  g.value = scaled.back(g.value);
  return g;
}

Gauge HertzGauge::gauge(const Wrench& load) const noexcept {
  if (const auto known = trivial_gauge(load)) return *known;
  const ScaledLoad scaled(load, radius_);
  const GaugeAndTwist g = slip(scaled.load);
  return scaled.back(bracketed(g.value, g.twist, largest_excess(), largest_deficit()));
}

}  // namespace patchgrip::friction
