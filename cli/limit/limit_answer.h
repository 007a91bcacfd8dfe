// What `patchgrip limit` says, as JSON and as a table of the loads.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/limit/limit_scene.h>
#include <patchgrip/cli/limit/load_answer.h>
#include <patchgrip/cli/result.h>
#include <patchgrip/cli/table.h>

namespace patchgrip::cli {

constexpr std::size_t most_loads_listed = 1000;  // in JSON

struct LimitAnswer {
  std::vector<Result> contact;  // what holds for all loads
  std::vector<LoadAnswer> loads;
  std::vector<std::string> warnings;
};

// One JSON object with a line break at the end. Throws std::range_error where a number is not finite.
std::string to_json(const LimitAnswer& answer, const LimitScene& scene, std::string_view scene_path);

// One row a load. holds: 1, 0, or an empty cell where the errors leave it open or friction is not given.
Table load_rows(const LimitAnswer& answer);

}  // namespace patchgrip::cli
