// What `patchgrip press` says about a contact: numbers with their errors, other laws beside them, and warnings.
//
// The error of a number bounds its distance from the exact answer of the law that is named, for the contact modulus and
// the relative radii (and 1 - their ratio) that are printed with it, and else for the numbers of the scene as doubles.
// Modulus and radii carry the errors of their own computation from the scene. A quantity that was given has none. How
// far the law is from the scene is not in it: warnings say so, and the laws beside show it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/result.h>
#include <patchgrip/cli/steepness.h>

namespace patchgrip::cli {

struct LawAnswer {
  std::string law;
  std::vector<Result> results;
  std::string remark;  // where the law holds, on which side it errs
};

struct Answer {
  LawAnswer main;
  std::vector<LawAnswer> beside;
  std::vector<std::string> warnings;
};

// Where the half-space theory does not hold any more (steepness.h).
void warn_if_steep(Answer& answer, const Steepness& steepness);

// One JSON object with a line break at the end. Throws std::range_error, naming the quantity, where a number is not
// finite.
std::string to_json(const Answer& answer, std::string_view scene_path, std::string_view title,
                    const std::vector<std::string>& contact);

}  // namespace patchgrip::cli
