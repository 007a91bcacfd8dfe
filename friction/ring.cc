#include <patchgrip/friction/ring.h>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/power_table.h>

namespace patchgrip::friction {

Ring Ring::of_radius(double radius) {
  static const auto table = kernels::power_table(-0.5);
  return {contact::require_positive("radius", radius), 1.0, kernels::TableKernel(table)};
}

}  // namespace patchgrip::friction
