#include <patchgrip/cli/result_json.h>

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include <patchgrip/version.h>

namespace patchgrip::cli {

nlohmann::ordered_json answer_head(std::string_view scene_path, std::string_view title) {
  nlohmann::ordered_json head{{"patchgrip", version}, {"scene", scene_path}};
  if (!title.empty()) head["title"] = title;
  return head;
}

nlohmann::ordered_json to_object(const std::vector<Result>& results) {
  auto object = nlohmann::ordered_json::object();
  for (const Result& q : results) {
    if (!std::isfinite(q.value) || !std::isfinite(q.error)) {
      throw std::range_error(fmt::format("{} = {} +- {} leaves the range of a double", q.name, q.value, q.error));
    }
    object[q.name] = {{"value", q.value}, {"error", q.error}, {"unit", q.unit}};
  }
  return object;
}

}  // namespace patchgrip::cli
