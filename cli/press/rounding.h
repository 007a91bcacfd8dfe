// Rounding in the errors that press states.
#pragma once

#include <cmath>
#include <string>
#include <utility>

#include <patchgrip/cli/press/answer.h>

namespace patchgrip::cli {

constexpr double unit = 0x1p-53;

// a/R from which on slopes are worth a warning.
constexpr double narrow = 0.1;

// A number that is right to so many units of rounding.
inline Result within(std::string name, double value, double units, std::string of) {
  return {std::move(name), value, units * unit * std::fabs(value), std::move(of)};
}

}  // namespace patchgrip::cli
