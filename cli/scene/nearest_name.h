// The known name that a misspelt one was probably meant to be.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace patchgrip::cli {

// Fewest insertions, deletions, replacements and swaps of neighbours that turn one name into the other.
std::size_t edit_distance(std::string_view from, std::string_view to);

// The nearest of `known`, unless even that differs in more than a third of its characters (at least 2 may differ).
std::optional<std::string_view> nearest_name(std::string_view name, std::span<const std::string_view> known);

// "; did you mean 'radius'?" or, where nothing is near, "; known are 'radius', 'patch'". Empty without known names.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

}  // namespace patchgrip::cli
