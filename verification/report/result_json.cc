#include <patchgrip/verification/report/result_json.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include <patchgrip/cli/output_file.h>
#include <patchgrip/verification/claims/all_claims.h>
#include <patchgrip/verification/fe/calculix.h>
#include <patchgrip/version.h>

namespace patchgrip::verification {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const Run& run) {
  return {{"elements", run.setting.elements},
          {"extent", run.setting.extent},
          {"unknowns", run.unknowns},
          {"iterations", run.iterations},
          {"seconds", run.seconds}};
}

ordered_json json_of(const Comparison& c) {
  ordered_json json{{"name", c.quantity.name},
                    {"unit", c.quantity.unit},
                    {"fe", c.fe},
                    {"fe_error", c.fe_error},
                    {"library", c.quantity.library},
                    {"scale", c.quantity.scale},
                    {"difference", c.difference},
                    {"relative_fe_error", c.relative_error}};
  if (!std::isnan(c.order)) json["order"] = c.order;
  if (c.quantity.claim == Claim::agrees) json["tolerance"] = c.quantity.tolerance;
  json["reason"] = c.quantity.reason;
  json["claim"] = c.quantity.claim == Claim::agrees ? "agrees" : "differs";
  json["verdict"] = name_of(c.verdict);
  return json;
}

}  // namespace

std::map<std::string, std::string> versions() {
  return {{"patchgrip", std::string(version)},
          {"getfem", getfem_version()},
          {"gmsh", gmsh_version()},
          {"ccx", calculix_version()}};
}

void write_result(const std::filesystem::path& file, const Case& one, std::string_view level, const Study& study) {
  ordered_json json{
      {"case", one.name}, {"title", claims_of(one.name).title}, {"level", level}, {"versions", versions()}};
  for (const Run& run : study.runs) json["runs"].push_back(json_of(run));
  if (study.larger_body) json["larger_body"] = json_of(*study.larger_body);
  for (const Comparison& c : study.comparisons) json["quantities"].push_back(json_of(c));
  cli::OutputFile out(file.string());
  out.write(json.dump(2) + "\n");
  out.commit();
}

}  // namespace patchgrip::verification
