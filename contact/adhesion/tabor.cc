#include <patchgrip/contact/adhesion/tabor.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <numbers>

namespace patchgrip::contact {
namespace {

using Real = long double;

}  // namespace

double tabor_parameter(const AdhesiveSphere& sphere, double equilibrium_distance) {
  const Real z = require_positive("equilibrium_distance", equilibrium_distance);
  const Real ratio = sphere.work_of_adhesion / Real(sphere.contact_modulus);
  return require_representable("tabor_parameter",
                               static_cast<double>(std::cbrt(sphere.relative_radius * ratio * ratio) / z));
}

long double unrounded_maugis_parameter(const AdhesiveSphere& sphere, double attraction) {
  const Real sigma = require_positive("attraction", attraction);
  const Real K = 4 * Real(sphere.contact_modulus) / 3;
  const Real pi_w = std::numbers::pi_v<Real> * sphere.work_of_adhesion;
  return 2 * sigma * std::cbrt(sphere.relative_radius / (pi_w * K * K));
}

double maugis_parameter(const AdhesiveSphere& sphere, double attraction) {
  return require_representable("maugis_parameter", static_cast<double>(unrounded_maugis_parameter(sphere, attraction)));
}

double lennard_jones_attraction(double work_of_adhesion, double equilibrium_distance) {
  const Real w = require_positive("work_of_adhesion", work_of_adhesion);
  const Real z = require_positive("equilibrium_distance", equilibrium_distance);
  return require_representable("attraction", static_cast<double>(16 * w / (9 * std::numbers::sqrt3_v<Real> * z)));
}

double dugdale_attraction(double work_of_adhesion, double range) {
  const Real w = require_positive("work_of_adhesion", work_of_adhesion);
  return require_representable("attraction", static_cast<double>(w / require_positive("range", range)));
}

}  // namespace patchgrip::contact
