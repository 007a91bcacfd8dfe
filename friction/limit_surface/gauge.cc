#include <patchgrip/friction/limit_surface/gauge.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {

void GaugeSettings::check() const {
  contact::require_in("relative_gap", relative_gap, 1e-15, 1, contact::Ends::right_open);
  contact::require_in("max_evaluations", max_evaluations, 1, 1e6);
}

std::optional<Gauge> trivial_gauge(const Wrench& load) noexcept {
  if (!std::isfinite(load.fx) || !std::isfinite(load.fy) || !std::isfinite(load.m)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return Gauge{nan, nan, nan, {nan, nan, nan}, 0, GaugeStatus::not_finite};
  }
  if (load.fx == 0 && load.fy == 0 && load.m == 0) return Gauge{};
  return std::nullopt;
}

int load_exponent(const Wrench& load, double length) noexcept {
  constexpr int none = std::numeric_limits<int>::min();
  const double force = std::max(std::fabs(load.fx), std::fabs(load.fy));
  return std::max(force > 0 ? std::ilogb(force) : none, load.m != 0 ? std::ilogb(load.m) - std::ilogb(length) : none);
}

}  // namespace patchgrip::friction
