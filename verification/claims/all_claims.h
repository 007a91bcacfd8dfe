// All cases by name, with what the library says about them.
//
// Throws   std::out_of_range for a name that is none of them.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <patchgrip/verification/claims/claim.h>

namespace patchgrip::verification {

struct ClaimSet {
  std::string_view name;  // on the command line and of files
  std::string_view title;
  std::vector<Quantity> (*quantities)();
};

std::span<const ClaimSet> all_claims();
const ClaimSet& claims_of(std::string_view name);

}  // namespace patchgrip::verification
