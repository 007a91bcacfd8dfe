// A case of the verification: what the library says and how finite elements find out.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

struct Case {
  std::string_view name;  // on the command line and of files
  std::string_view title;
  std::vector<Setting> ci;    // meshes from coarse to fine
  std::vector<Setting> full;  // what is added
  std::vector<Quantity> (*claims)();
  Solved (*solve)(const Setting&);
};

std::span<const Case> all_cases();

}  // namespace patchgrip::verification
