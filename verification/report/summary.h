// What the program prints of a case: a line for each run and one for each quantity.
#pragma once

#include <string>

#include <patchgrip/verification/claims/two_solvers.h>
#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

std::string progress_line(const Run& run);
std::string summary(const Study& study);
std::string line_of(const SolverPair& pair, const Agreement& agreement);

}  // namespace patchgrip::verification
