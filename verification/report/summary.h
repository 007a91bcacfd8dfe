// What the program prints of a case: a line for each run and one for each quantity.
#pragma once

#include <string>

#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

std::string progress_line(const Run& run);
std::string summary(const Study& study);

}  // namespace patchgrip::verification
