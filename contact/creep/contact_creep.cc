#include <patchgrip/contact/creep/contact_creep.h>
#include <patchgrip/contact/creep/wide.h>

namespace patchgrip::contact {
namespace {

double require_poisson(double nu) { return require_in("poisson_ratio", nu, -1, 0.5, Ends::left_open); }

BasicCreepCompliance<Wide> scaled(const CreepCompliance& compliance, double poisson_ratio) {
  const Wide nu = poisson_ratio;
  const Wide factor = (1 - nu) * (1 + nu);
  Modes<Wide> modes = modes_as<Wide>(compliance.modes());
  for (auto& mode : modes) mode.strength *= factor;
  return BasicCreepCompliance<Wide>::of(factor * compliance.instantaneous(), std::move(modes),
                                        factor * compliance.fluidity());
}

// Without the modes that nobody can feel: their times in C and in its reciprocal would be one number.
BasicCreepCompliance<Wide> without_weak_modes(const BasicCreepCompliance<Wide>& compliance) {
  const Wide weak = 1e-24;
  Wide steepest = compliance.fluidity();
  for (const auto& mode : compliance.modes()) steepest += mode.strength / mode.time;
  Modes<Wide> modes;
  for (const auto& mode : compliance.modes()) {
    if (mode.strength > weak * compliance.equilibrium() || mode.strength / mode.time > weak * steepest) {
      modes.push_back(mode);
    }
  }
  return BasicCreepCompliance<Wide>::of(compliance.instantaneous(), std::move(modes), compliance.fluidity());
}

// Both series follow from the one that is rounded: C.
ContactCreep contact_creep(const BasicCreepCompliance<Wide>& wide) {
  const CreepCompliance compliance = compliance_as<double>(without_weak_modes(wide));
  const auto exact = compliance_as<Wide>(compliance);
  const auto modulus = reciprocal(exact);
  std::vector<std::vector<double>> coupling;
  for (const auto& relaxing : modulus.modes()) {
    auto& row = coupling.emplace_back();
    for (const auto& creeping : exact.modes()) {
      row.push_back(static_cast<double>(1 / (creeping.time - relaxing.time)));
      require_finite("coupling of two modes", row.back());
    }
  }
  return {compliance, modulus_as<double>(modulus), std::move(coupling)};
}

}  // namespace

ViscoelasticMaterial ViscoelasticMaterial::of(RelaxationModulus modulus, double poisson_ratio) {
  require_poisson(poisson_ratio);
  auto compliance = creep_compliance(modulus);
  return {std::move(modulus), std::move(compliance), poisson_ratio};
}

ViscoelasticMaterial ViscoelasticMaterial::of(const CreepCompliance& compliance, double poisson_ratio) {
  return {relaxation_modulus(compliance), compliance, require_poisson(poisson_ratio)};
}

ViscoelasticMaterial ViscoelasticMaterial::elastic(const Material& material) {
  return of(RelaxationModulus::of(require_positive("youngs_modulus", material.youngs_modulus), {}),
            material.poisson_ratio);
}

ContactCreep ContactCreep::against_rigid(const ViscoelasticMaterial& body) {
  return contact_creep(scaled(body.compliance, body.poisson_ratio));
}

ContactCreep ContactCreep::between(const ViscoelasticMaterial& first, const ViscoelasticMaterial& second) {
  const auto one = scaled(first.compliance, first.poisson_ratio);
  const auto other = scaled(second.compliance, second.poisson_ratio);
  Modes<Wide> modes = one.modes();
  modes.insert(modes.end(), other.modes().begin(), other.modes().end());
  return contact_creep(BasicCreepCompliance<Wide>::of(one.instantaneous() + other.instantaneous(), std::move(modes),
                                                      one.fluidity() + other.fluidity()));
}

}  // namespace patchgrip::contact
