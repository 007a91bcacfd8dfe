#include <patchgrip/contact/material.h>
#include <patchgrip/contact/require.h>

#include <limits>
#include <stdexcept>

namespace patchgrip::contact {
Material Material::elastic(double youngs_modulus, double poisson_ratio) {
  return {require_positive("youngs_modulus", youngs_modulus),
          require_in("poisson_ratio", poisson_ratio, -1, 0.5, Ends::left_open)};
}

Material Material::rigid() { return {std::numeric_limits<double>::infinity(), 0}; }

long double plane_compliance(const Material& body) {
  const long double nu = body.poisson_ratio;
  return (1 - nu) * (1 + nu) / body.youngs_modulus;
}

double contact_modulus(const Material& first, const Material& second) {
  const long double compliance = plane_compliance(first) + plane_compliance(second);
  if (compliance == 0) throw std::invalid_argument("both bodies are rigid: to touch in an area one must be elastic");
  const auto modulus = static_cast<double>(1 / compliance);
  return require_representable("contact_modulus", modulus);
}

}  // namespace patchgrip::contact
