// A look over the text of a TOML file for what its parser lets pass or dies of.
//
// toml++ 3.3 reads 1e-999 as 0, and its recursion over a key of a million dots overflows the stack.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace patchgrip::cli {

struct TomlProblem {
  std::size_t line;
  std::string message;
};

std::optional<TomlProblem> scan_toml(std::string_view text);

}  // namespace patchgrip::cli
