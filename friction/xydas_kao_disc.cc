#include <patchgrip/friction/xydas_kao_disc.h>

#include <cmath>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/disc_stack.h>
#include <patchgrip/friction/kernels/power_table.h>

namespace patchgrip::friction {
namespace {

// <r^2> / a^2 = (3/5) Gamma(4/alpha) Gamma(3/alpha) / (Gamma(5/alpha) Gamma(2/alpha))
double polar_moment(double alpha) {
  const auto g = [alpha](long double k) { return std::tgamma(k / alpha); };
  return static_cast<double>(3 * g(4) * g(3) / (5 * g(5) * g(2)));
}

}  // namespace

XydasKaoDisc XydasKaoDisc::of_radius(double radius, double alpha) {
  contact::require_positive("radius", radius);
  contact::require_in("alpha", alpha, 0.5, 50);
  static const auto uniform = kernels::power_table(0.5);
  // At the centre f / x and m carry a singular part of order x^(alpha + 1), f' one of the same order.
  const int centre = std::max(4, static_cast<int>(std::ceil(56 / (alpha + 1))));
  const kernels::RoundLevels levels{kernels::rim_levels(1 / alpha), centre};
  auto table = std::make_shared<const kernels::RoundTable>(
      kernels::RoundTable::build<long double>(kernels::XydasKaoStack(alpha, *uniform), levels));
  return {radius, alpha, polar_moment(alpha), kernels::TableKernel(std::move(table))};
}

}  // namespace patchgrip::friction
