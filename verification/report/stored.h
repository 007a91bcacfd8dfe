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

// The bound is the sum of both errors of FE: another processor may round a mesh into other elements.
Reproduction reproduces(const StoredRun& fresh, const StoredRun& stored);

}  // namespace patchgrip::verification
