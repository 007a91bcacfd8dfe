#include <patchgrip/contact/adhesion/adhesion_map.h>
#include <patchgrip/contact/adhesion/dmt.h>
#include <patchgrip/contact/adhesion/jkr.h>
#include <patchgrip/contact/hertz_circle.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <limits>

namespace patchgrip::contact {

AdhesionMap AdhesionMap::of(const MaugisDugdale& reference, double normal_force) {
  const double radius = reference.under_force(normal_force).contact_radius;
  const AdhesiveSphere& sphere = reference.sphere();
  const Dmt dmt(sphere);
  const Jkr jkr(sphere);
  AdhesionMap map;
  map.hertz_error = map.dmt_error = map.jkr_error = std::numeric_limits<double>::infinity();
  const auto error = [&](double other) { return std::fabs(other / radius - 1); };
  if (normal_force > 0) {
    map.hertz_error =
        error(HertzCircle::under_force(normal_force, sphere.relative_radius, sphere.contact_modulus).radius);
  }
  if (normal_force >= dmt.pull_off().normal_force) map.dmt_error = error(dmt.under_force(normal_force).contact_radius);
  if (normal_force >= jkr.load_pull_off().normal_force)
    map.jkr_error = error(jkr.under_force(normal_force).contact_radius);
  return map;
}

AdhesionModel AdhesionMap::cheapest_within(double tolerance) const {
  require_positive("tolerance", tolerance);
  if (hertz_error <= tolerance) return AdhesionModel::hertz;
  if (dmt_error <= tolerance) return AdhesionModel::dmt;
  if (jkr_error <= tolerance) return AdhesionModel::jkr;
  return AdhesionModel::maugis_dugdale;
}

}  // namespace patchgrip::contact
