// A case of the verification: how finite elements find out about what claims/all_claims.h says of the same name.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

struct Case {
  std::string_view name;      // of its claims
  std::vector<Setting> ci;    // meshes from coarse to fine
  std::vector<Setting> full;  // what is added
  Solved (*solve)(const Setting&);
  bool stores_stress = false;  // beside the stored run, for figures
};

std::span<const Case> all_cases();

}  // namespace patchgrip::verification
