#include <patchgrip/contact/dundurs.h>

#include <patchgrip/contact/require.h>

namespace patchgrip::contact {
namespace {

using Real = long double;

Real coupling(const Material& body) {
  const Real nu = body.poisson_ratio;
  return (1 - 2 * nu) * (1 + nu) / body.youngs_modulus;
}

}  // namespace

Dundurs Dundurs::of(const Material& p, const Material& m) {
  const Real first = plane_compliance(p), second = plane_compliance(m);
  if (!(first + second > 0)) {
    refuse("youngs_modulus", p.youngs_modulus, "must be finite for one of the bodies: two rigid ones do not differ");
  }
  return {static_cast<double>((second - first) / (first + second)),
          static_cast<double>((coupling(m) - coupling(p)) / (2 * (first + second)))};
}

}  // namespace patchgrip::contact
