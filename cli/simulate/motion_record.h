// What a simulation has found so far: a row at each of the times that were asked for, and the events between them; of
// two bodies a row of each, the energies of both in that of the lower one.
//
// Errors   estimates: the difference from a second run with a hundred times the tolerance of a step, or twice that from
//          one with half of the step. Of a place the largest until then, and the tolerance of a step.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/table.h>
#include <patchgrip/dynamics/bristle_metric.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::cli {

using dynamics::Vector3;

struct MotionRow {
  double time;
  Vector3 place, twist;
  Vector3 deflection = Vector3::Zero();  // of bristles
  Vector3 friction = Vector3::Zero();    // on the body, in axes of space
  double share = not_known;              // gauge of the friction over mu_s F_N
  bool slips = false;
  double kinetic = 0, stored = 0;   // [J]
  double work = 0, dissipated = 0;  // [J], since the start
  Vector3 error = Vector3::Zero();  // of the place
  std::optional<Vector3> anchor{};  // of the bristles on what they rub on; by default the place less the deflection
};

struct MotionEvent {
  std::string_view kind;  // break_away, stop, turn, extreme, sticks, rest_speed
  double time;
  double time_error;  // [s]
  Vector3 place;
  std::optional<friction::Twist> slip{};  // its direction, in axes of space
  double margin = not_known;              // by how much the load that acts may grow before it slips
  bool upper = false;                     // of the upper body on the lower one
};

struct MotionRecord {
  std::vector<MotionRow> rows;
  std::vector<MotionRow> upper_rows;  // at the same times
  std::vector<MotionEvent> events;
  std::optional<MotionEvent> rest;        // the last stop, or the last time at the rest speed
  std::optional<MotionEvent> upper_rest;  // the same, with the place of the upper body
  std::vector<std::string> warnings;
};

// `factor` times the differences from another record of the same times become errors; events are matched in their
// order, as long as they are of the same kind. What is already there as an error of an event is added to.
void estimate_errors(MotionRecord& record, const MotionRecord& other, double factor, double tolerance);

// How far the anchor moved over the support from the first to the last row of every spell of stick, summed up [m].
double drift_in_stick(const std::vector<MotionRow>& rows, double support_speed);

Table table_of(const MotionRecord& record, bool point);

}  // namespace patchgrip::cli
