#include <patchgrip/friction/uniform_disc.h>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/power_table.h>

namespace patchgrip::friction {

UniformDisc UniformDisc::of_radius(double radius) {
  static const auto table = kernels::power_table(0.5);
  return {contact::require_positive("radius", radius), 0.5, kernels::TableKernel(table)};
}

}  // namespace patchgrip::friction
