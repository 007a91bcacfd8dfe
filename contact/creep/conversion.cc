#include <patchgrip/contact/creep/conversion.h>
#include <patchgrip/contact/creep/wide.h>

namespace patchgrip::contact {

CreepCompliance creep_compliance(const RelaxationModulus& modulus) {
  return compliance_as<double>(reciprocal(modulus_as<Wide>(modulus)));
}

RelaxationModulus relaxation_modulus(const CreepCompliance& compliance) {
  return modulus_as<double>(reciprocal(compliance_as<Wide>(compliance)));
}

}  // namespace patchgrip::contact
