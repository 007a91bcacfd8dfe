#include <patchgrip/cli/limit/limit_answer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include <patchgrip/cli/result_json.h>

namespace patchgrip::cli {
namespace {

using friction::GaugeStatus;
using nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> verdicts{"holds", "slips", "undecided"};

std::vector<Result> results_of(const LoadAnswer& load, const LimitScene& scene) {
  std::vector<Result> results{{"gauge", load.gauge.value, load.gauge_error, "N"}};
  if (!load.loaded()) return results;
  if (!scene.contact.resistance) {
    const double mu = load.gauge.value / scene.contact.normal_force;
    results.push_back({"needed_mu", mu,
                       load.gauge_error / scene.contact.normal_force + (0x1p-53 + scene.contact.sum_error) * mu, "1"});
  }
  if (std::isfinite(load.margin.value)) results.push_back({"margin", load.margin.value, load.margin.error, "1"});
  if (std::isfinite(load.stick_radius.value)) {
    results.push_back({"stick_radius", load.stick_radius.value, load.stick_radius.error, "1"});
  }
  const Slip& slip = load.slip;
  if (load.turns()) {
    results.push_back({"pole_x", slip.pole.x, slip.pole_error, "m"});
    results.push_back({"pole_y", slip.pole.y, slip.pole_error, "m"});
  }
  if (load.starts_one_slip()) {
    results.push_back({"slip_vx", slip.twist.vx, slip.speed_error, "m/s"});
    results.push_back({"slip_vy", slip.twist.vy, slip.speed_error, "m/s"});
    results.push_back({"slip_w", slip.twist.w, slip.spin_error, "rad/s"});
  }
  results.push_back({"certificate_gap", (load.gauge.upper - load.gauge.lower) / load.gauge.value, 0, "1"});
  return results;
}

// Where the slip is one of several, or the same for several loads.
std::string_view remark_of(GaugeStatus status) {
  switch (status) {
    case GaugeStatus::ridge:
      return "other slips are as good: all the pressure lies on one line, and their poles on a part of it";
    case GaugeStatus::facet:
      return "neighbouring loads start the same slip, about a point load";
    case GaugeStatus::stalled:
      return "the gauge is bracketed, but less closely than usual; the slip is not known";
    default:
      return "";
  }
}

std::string_view slip_in_words(const LoadAnswer& load) {
  if (!load.starts_one_slip()) return "not determined";
  return load.turns() ? "rotation" : "translation";
}

ordered_json to_entry(const LoadAnswer& load, const LimitScene& scene) {
  ordered_json entry;
  entry["load"] = to_object(
      {{"force_x", load.load.fx, 0, "N"}, {"force_y", load.load.fy, 0, "N"}, {"moment", load.load.m, 0, "N m"}});
  if (has_friction(scene)) entry["verdict"] = verdicts[static_cast<std::size_t>(load.verdict)];
  if (load.loaded()) entry["slip"] = slip_in_words(load);
  const std::string_view remark = remark_of(load.gauge.status);
  if (!remark.empty()) entry["remark"] = remark;
  entry["results"] = to_object(results_of(load, scene));
  entry["evaluations"] = load.gauge.evaluations;
  return entry;
}

}  // namespace

std::string to_json(const LimitAnswer& answer, const LimitScene& scene, std::string_view scene_path) {
  ordered_json json = answer_head(scene_path, scene.title);
  json["contact"] = scene.contact.notes;
  json["results"] = to_object(answer.contact);
  json["loads"] = ordered_json::array();
  const std::size_t listed = std::min(answer.loads.size(), most_loads_listed);
  for (std::size_t i = 0; i < listed; ++i) json["loads"].push_back(to_entry(answer.loads[i], scene));
  json["warnings"] = answer.warnings;
  return json.dump(2) + "\n";
}

Table load_rows(const LimitAnswer& answer) {
  Table table{
      {"force_x_N", "force_y_N", "moment_Nm", "gauge_N", "gauge_error_N", "margin", "margin_error", "holds",
       "stick_radius", "stick_radius_error", "pole_x_m", "pole_y_m", "pole_error_m", "slip_vx_m_per_s",
       "slip_vy_m_per_s", "slip_w_rad_per_s", "slip_speed_error_m_per_s", "slip_w_error_rad_per_s", "evaluations"},
      {}};
  table.rows.reserve(answer.loads.size());
  for (const LoadAnswer& load : answer.loads) {
    const Slip& slip = load.slip;
    const bool slips = load.starts_one_slip();
    const auto where = [](bool known, double value) { return known ? value : not_known; };
    const bool turns = slips && load.turns();
    table.rows.push_back({load.load.fx, load.load.fy, load.load.m, load.gauge.value, load.gauge_error,
                          load.margin.value, load.margin.error,
                          where(load.verdict != Verdict::undecided, load.verdict == Verdict::holds ? 1 : 0),
                          load.stick_radius.value, load.stick_radius.error, where(turns, slip.pole.x),
                          where(turns, slip.pole.y), where(turns, slip.pole_error), where(slips, slip.twist.vx),
                          where(slips, slip.twist.vy), where(slips, slip.twist.w), where(slips, slip.speed_error),
                          where(slips, slip.spin_error), static_cast<double>(load.gauge.evaluations)});
  }
  return table;
}

}  // namespace patchgrip::cli
