#include <patchgrip/cli/simulate/simulate_answer.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include <patchgrip/cli/result_json.h>
#include <patchgrip/cli/scene/friction_reader.h>

namespace patchgrip::cli {
namespace {

using nlohmann::ordered_json;

// Of a value whose error may not be known: then it is null.
ordered_json number(double value, double error, std::string_view unit) {
  ordered_json object{{"value", value}};
  object["error"] = std::isfinite(error) ? ordered_json(error) : ordered_json(nullptr);
  object["unit"] = unit;
  return object;
}

ordered_json to_entry(const MotionEvent& e, bool point, bool stack) {
  ordered_json entry{{"event", e.kind}, {"time", number(e.time, e.time_error, "s")}};
  if (stack) entry["contact"] = e.upper ? "upper" : "lower";
  entry["x_m"] = e.place[0];
  if (!point) {
    entry["y_m"] = e.place[1];
    entry["turn_rad"] = e.place[2];
  }
  if (e.slip) {
    const double x = -e.slip->vy / e.slip->w, y = e.slip->vx / e.slip->w;
    if (std::isfinite(x) && std::isfinite(y)) {
      entry["pole_from_centre_m"] = {x + 0., y + 0.};
    } else {
      entry["slip_direction"] = {e.slip->vx, e.slip->vy};
    }
  }
  if (std::isfinite(e.margin)) entry["margin"] = e.margin;
  return entry;
}

// How far a body came from its start until it rested.
void add_stop(ordered_json& all, const std::string& prefix, const std::vector<MotionRow>& rows, const MotionEvent& rest,
              const MovingBody& body, bool turns) {
  const Vector3 way = rest.place - body.place;
  const double error = rows.empty() ? not_known : rows.back().error.head<2>().norm();
  all[prefix + "stop_distance"] = number(way.head<2>().norm(), error, "m");
  if (turns) all[prefix + "stop_turn"] = number(way[2], rows.empty() ? not_known : rows.back().error[2], "rad");
}

ordered_json summary(const MotionRecord& record, const SimulateScene& scene) {
  ordered_json all = ordered_json::object();
  const auto breaks = std::ranges::find(record.events, "break_away", &MotionEvent::kind);
  if (breaks != record.events.end()) all["break_away"] = number(breaks->time, breaks->time_error, "s");
  if (record.rest) {
    all["stop_time"] = number(record.rest->time, record.rest->time_error, "s");
    add_stop(all, "", record.rows, *record.rest, scene.body, !scene.point);
  }
  if (record.upper_rest) add_stop(all, "upper_", record.upper_rows, *record.upper_rest, scene.upper->body, true);
  if (record.rows.empty()) return all;
  all["drift_in_stick"] = number(drift_in_stick(record.rows, scene.body.support_speed), not_known, "m");
  if (scene.upper) all["upper_drift_in_stick"] = number(drift_in_stick(record.upper_rows, 0), not_known, "m");
  double off = 0, size = 0;
  const MotionRow& first = record.rows.front();
  for (const MotionRow& r : record.rows) {
    const double balance =
        r.kinetic + r.stored - first.kinetic - first.stored - (r.work - first.work) + (r.dissipated - first.dissipated);
    off = std::max(off, std::fabs(balance));
    size = std::max({size, r.kinetic, r.stored, std::fabs(r.work), std::fabs(r.dissipated)});
  }
  all["energy_balance_error"] = {{"value", size > 0 ? off / size : 0}, {"unit", "1"}};
  return all;
}

}  // namespace

std::string to_json(const MotionRecord& record, const SimulateScene& scene, std::string_view scene_path) {
  ordered_json json = answer_head(scene_path, scene.title);
  json["contact"] = scene.contact.notes;
  json["friction"] = in_words(scene.law, false);
  if (scene.upper)
    json["upper"] = {{"contact", scene.upper->contact.notes}, {"friction", in_words(scene.upper->law, false)}};
  json["method"] = name_of(scene.following.method);
  json["summary"] = summary(record, scene);
  json["events"] = ordered_json::array();
  for (std::size_t i = 0; i < std::min(record.events.size(), most_events_listed); ++i)
    json["events"].push_back(to_entry(record.events[i], scene.point, scene.upper.has_value()));
  auto warnings = record.warnings;
  if (record.events.size() > most_events_listed) {
    warnings.push_back(
        fmt::format("the first {} of {} events are listed here", most_events_listed, record.events.size()));
  }
  json["warnings"] = warnings;
  return json.dump(2) + "\n";
}

}  // namespace patchgrip::cli
