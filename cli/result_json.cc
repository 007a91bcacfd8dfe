#include <patchgrip/cli/result_json.h>

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace patchgrip::cli {

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
