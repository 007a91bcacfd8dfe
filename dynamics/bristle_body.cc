#include <patchgrip/dynamics/bristle_body.h>

namespace patchgrip::dynamics {

void BristleBodyParameters::check() const {
  contact::require_positive("mass", mass);
  contact::require_positive("inertia", inertia);
  const bool rigid = std::isinf(stiffness.k) && stiffness.k > 0 && std::isinf(stiffness.k_r) && stiffness.k_r > 0;
  if (!rigid) {
    contact::require_positive("stiffness k", stiffness.k);
    contact::require_positive("stiffness k_r", stiffness.k_r);
  }
  contact::require_non_negative("damping", damping);
  contact::require_non_negative("turn_damping", turn_damping);
  if (rigid && (damping > 0 || turn_damping > 0))
    contact::refuse("damping", std::max(damping, turn_damping), "must be 0 without bristles");
}

}  // namespace patchgrip::dynamics
