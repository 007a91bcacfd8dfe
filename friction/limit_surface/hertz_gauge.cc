#include <patchgrip/friction/limit_surface/hertz_gauge.h>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {

HertzGauge HertzGauge::of_radius(double radius) { return HertzGauge(contact::require_positive("radius", radius)); }

GaugeAndTwist HertzGauge::rescaled_slip(const Wrench& load) const noexcept {
  if (const auto known = trivial_gauge(load)) return {known->value, known->twist};
  const int e = load_exponent(load, radius_);
  GaugeAndTwist g = slip({std::scalbn(load.fx, -e), std::scalbn(load.fy, -e), std::scalbn(load.m, -e)});
  g.value = std::scalbn(g.value, e);
  return g;
}

Gauge HertzGauge::gauge(const Wrench& load) const noexcept {
  if (const auto known = trivial_gauge(load)) return *known;
  constexpr double relative = 8 * 0x1p-53;
  const GaugeAndTwist g = slip(load);
  return {g.value, (1 - relative) * g.value, (1 + relative) * g.value, g.twist, 0, GaugeStatus::converged};
}

}  // namespace patchgrip::friction
