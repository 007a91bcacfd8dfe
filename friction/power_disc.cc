#include <patchgrip/friction/power_disc.h>

#include <cmath>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/power_table.h>

namespace patchgrip::friction {

PowerDisc PowerDisc::of_radius(double radius, double exponent) {
  contact::require_positive("radius", radius);
  contact::require_in("exponent", exponent, -0.5, 20, contact::Ends::left_open);
  return {radius, exponent, kernels::TableKernel(kernels::power_table(exponent))};
}

}  // namespace patchgrip::friction
