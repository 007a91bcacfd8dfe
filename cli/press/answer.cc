#include <patchgrip/cli/press/answer.h>

#include <utility>

#include <nlohmann/json.hpp>

#include <patchgrip/cli/result_json.h>

namespace patchgrip::cli {

void warn_if_steep(Answer& answer, const Steepness& steepness) {
  if (!steepness.is_small()) answer.warnings.push_back(steepness.warning());
}

std::string to_json(const Answer& answer, std::string_view scene_path, std::string_view title,
                    const std::vector<std::string>& contact) {
  nlohmann::ordered_json json = answer_head(scene_path, title);
  json["contact"] = contact;
  json["law"] = answer.main.law;
  if (!answer.main.remark.empty()) json["remark"] = answer.main.remark;
  json["results"] = to_object(answer.main.results);
  json["beside"] = nlohmann::ordered_json::array();
  for (const LawAnswer& law : answer.beside) {
    nlohmann::ordered_json entry{{"law", law.law}};
    if (!law.remark.empty()) entry["remark"] = law.remark;
    entry["results"] = to_object(law.results);
    json["beside"].push_back(std::move(entry));
  }
  json["warnings"] = answer.warnings;
  return json.dump(2) + "\n";
}

}  // namespace patchgrip::cli
