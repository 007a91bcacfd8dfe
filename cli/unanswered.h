// The scene is well and good, but its question was not answered: something does not converge.
#pragma once

#include <stdexcept>

namespace patchgrip::cli {

struct Unanswered : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace patchgrip::cli
