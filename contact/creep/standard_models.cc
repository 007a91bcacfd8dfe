#include <patchgrip/contact/creep/standard_models.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::contact {

RelaxationModulus kelvin_voigt(double E2, double eta) {
  return RelaxationModulus::of(require_positive("E2", E2), {}, require_positive("eta", eta));
}

RelaxationModulus maxwell(double E1, double eta) {
  require_positive("E1", E1);
  require_positive("eta", eta);
  return RelaxationModulus::of(0, {{E1, eta / E1}});
}

PoyntingThomson PoyntingThomson::of(double E1, double E2, double eta) {
  const PoyntingThomson model{require_positive("E1", E1), require_positive("E2", E2), require_positive("eta", eta)};
  require_representable("E1 + E2", E1 + E2);
  require_representable("retardation_rate", model.retardation_rate());
  return model;
}

RelaxationModulus PoyntingThomson::modulus() const { return RelaxationModulus::of(E2, {{E1, eta / E1}}); }

double PoyntingThomson::retardation_rate() const noexcept {
  return std::min(E1, E2) / eta * (std::max(E1, E2) / (E1 + E2));
}

double PoyntingThomson::creep(double t) const noexcept {
  if (!(t >= 0)) return 0;
  return 1 / (E1 + E2) - E1 / (E1 + E2) / E2 * std::expm1(-retardation_rate() * t);
}

double PoyntingThomson::creep_rate(double t) const noexcept {
  if (!(t >= 0)) return 0;
  const double share = E1 / (E1 + E2);
  return share * share / eta * std::exp(-retardation_rate() * t);
}

}  // namespace patchgrip::contact
