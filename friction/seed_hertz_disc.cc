#include <patchgrip/friction/seed_hertz_disc.h>

#include <algorithm>
#include <cmath>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {

SeedHertzDisc SeedHertzDisc::of_radius(double radius) { return {contact::require_positive("radius", radius), 0.4, {}}; }

BoundedWrench SeedHertzDisc::bounded_gradient(const Twist& v) const noexcept {
  BoundedWrench g = RoundPatch::bounded_gradient(v);
  const RoundTwist t(v, radius());
  if (kernels::SeedKernel::pole_inside(t)) {
    g.force_error += 4.28e-4;
  } else {
    // Of the fit's own moment m the relative error 1.34e-2 is at most 1.34e-2 / (1 - 1.34e-2).
    g.force_error += 4.72e-4;
    g.moment_error += std::min(1.18e-3 * radius(), 1.36e-2 * std::fabs(g.value.m));
  }
  return g;
}

}  // namespace patchgrip::friction
