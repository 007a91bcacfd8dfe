// Fresh runs to be stored in data/fe, and held against what is stored there.
#pragma once

#include <string>
#include <string_view>

#include <patchgrip/verification/cases/case.h>
#include <patchgrip/verification/claims/stored_run.h>

namespace patchgrip::verification {

StoredRun stored_run_of(const Case& one, std::string_view level, const Study& study);

struct Reproduction {
  bool is_within_bound;
  std::string report;  // a line for each quantity
};

// The bound is the sum of both errors of FE. Where versions, level and meshes are the same it is 1e-6 of the scale: the
// order of sums in the solver of linear equations is all that may change.
Reproduction reproduces(const StoredRun& fresh, const StoredRun& stored);

}  // namespace patchgrip::verification
