// Results as JSON: { "name": { "value", "error", "unit" }, ... }.
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include <patchgrip/cli/result.h>

namespace patchgrip::cli {

// Throws std::range_error, naming the quantity, where a number is not finite.
nlohmann::ordered_json to_object(const std::vector<Result>& results);

}  // namespace patchgrip::cli
