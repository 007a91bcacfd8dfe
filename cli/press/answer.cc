#include <patchgrip/cli/press/answer.h>

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include <patchgrip/version.h>

namespace patchgrip::cli {
namespace {

using Json = nlohmann::ordered_json;

Json to_object(const std::vector<Result>& results) {
  Json object = Json::object();
  for (const Result& q : results) {
    if (!std::isfinite(q.value) || !std::isfinite(q.error)) {
      throw std::range_error(fmt::format("{} = {} +- {} leaves the range of a double", q.name, q.value, q.error));
    }
    object[q.name] = {{"value", q.value}, {"error", q.error}, {"unit", q.unit}};
  }
  return object;
}

}  // namespace

std::string to_json(const Answer& answer, std::string_view scene_path, std::string_view title,
                    const std::vector<std::string>& contact) {
  Json json;
  json["patchgrip"] = version;
  json["scene"] = scene_path;
  if (!title.empty()) json["title"] = title;
  json["contact"] = contact;
  json["law"] = answer.main.law;
  if (!answer.main.remark.empty()) json["remark"] = answer.main.remark;
  json["results"] = to_object(answer.main.results);
  json["beside"] = Json::array();
  for (const LawAnswer& law : answer.beside) {
    Json entry{{"law", law.law}};
    if (!law.remark.empty()) entry["remark"] = law.remark;
    entry["results"] = to_object(law.results);
    json["beside"].push_back(std::move(entry));
  }
  json["warnings"] = answer.warnings;
  return json.dump(2) + "\n";
}

}  // namespace patchgrip::cli
