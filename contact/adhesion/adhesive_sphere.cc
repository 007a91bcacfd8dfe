#include <patchgrip/contact/adhesion/adhesive_sphere.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <numbers>

namespace patchgrip::contact {
namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr Real pi_rest = -5.0165576126683320236e-20L;  // of pi beyond 64 bits

}  // namespace

AdhesiveSphere AdhesiveSphere::of(double relative_radius, double contact_modulus, double work_of_adhesion) {
  return {require_positive("relative_radius", relative_radius), require_positive("contact_modulus", contact_modulus),
          require_positive("work_of_adhesion", work_of_adhesion)};
}

long double AdhesiveSphere::pi_w_R() const { return pi * work_of_adhesion * relative_radius; }

long double AdhesiveSphere::force_above(int multiple, double force, int parts) const {
  const Real w = static_cast<Real>(parts) * work_of_adhesion;  // exact
  const Real product = w * relative_radius;
  const Real product_rest = std::fma(w, static_cast<Real>(relative_radius), -product);
  const Real high = pi * product;
  const Real low = std::fma(pi, product, -high) + pi * product_rest + pi_rest * product;
  return (static_cast<Real>(multiple) * force + high) + low;
}

}  // namespace patchgrip::contact
