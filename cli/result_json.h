// Answers as JSON: their head, and results { "name": { "value", "error", "unit" }, ... }.
#pragma once

#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <patchgrip/cli/result.h>

namespace patchgrip::cli {

// What every answer starts with: version, scene, and title unless it is empty.
nlohmann::ordered_json answer_head(std::string_view scene_path, std::string_view title);

// Throws std::range_error, naming the quantity, where a number is not finite.
nlohmann::ordered_json to_object(const std::vector<Result>& results);

}  // namespace patchgrip::cli
