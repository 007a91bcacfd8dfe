// A number that the program tells, with its error.
//
// The error bounds the distance of the value from the exact answer to what is named beside it; a number of the scene
// has none.
#pragma once

#include <string>

namespace patchgrip::cli {

struct Result {
  std::string name;
  double value;
  double error;  // >= 0, in the unit of the value
  std::string unit;
};

}  // namespace patchgrip::cli
