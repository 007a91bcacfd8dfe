#include <patchgrip/cli/simulate/motion_record.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace patchgrip::cli {
namespace {

void add_error(MotionEvent& event, const MotionEvent& other, double factor) {
  event.time_error += factor * std::fabs(event.time - other.time);
}

}  // namespace

void estimate_errors(MotionRecord& record, const MotionRecord& other, double factor, double tolerance) {
  Vector3 largest = Vector3::Zero();
  for (std::size_t i = 0; i < std::min(record.rows.size(), other.rows.size()); ++i) {
    largest = largest.cwiseMax(factor * (record.rows[i].place - other.rows[i].place).cwiseAbs());
    record.rows[i].error = largest + tolerance * (Vector3::Ones() + record.rows[i].place.cwiseAbs());
  }
  bool alike = true;
  for (std::size_t i = 0; i < record.events.size(); ++i) {
    alike = alike && i < other.events.size() && other.events[i].kind == record.events[i].kind;
    if (alike) {
      add_error(record.events[i], other.events[i], factor);
    } else {
      record.events[i].time_error = not_known;
    }
  }
  if (!alike || other.events.size() != record.events.size()) {
    record.warnings.emplace_back(
        "a second run, by another step, meets other events: the errors of the times of those "
        "that it does not share are not known");
  }
  if (record.rest && other.rest) {
    add_error(*record.rest, *other.rest, factor);
  } else if (record.rest) {
    record.rest->time_error = not_known;
  }
}

double drift_in_stick(const MotionRecord& record, double support_speed) {
  const auto anchor = [&](const MotionRow& r) {
    return Eigen::Vector2d(r.place[0] - r.deflection[0] - support_speed * r.time, r.place[1] - r.deflection[1]);
  };
  double way = 0;
  const auto& rows = record.rows;
  for (std::size_t first = 0, i = 0; i < rows.size(); ++i) {
    if (rows[i].slips) {
      first = i + 1;
    } else if (i + 1 == rows.size() || rows[i + 1].slips) {
      way += (anchor(rows[i]) - anchor(rows[first])).norm();
    }
  }
  return way;
}

Table table_of(const MotionRecord& record, bool point) {
  Table table;
  const double start = record.rows.empty() ? 0 : record.rows.front().kinetic + record.rows.front().stored;
  const double before = record.rows.empty() ? 0 : record.rows.front().work - record.rows.front().dissipated;
  if (point) {
    table.columns = {"t_s", "x_m", "x_error_m", "v_m_per_s", "deflection_m", "friction_N"};
  } else {
    table.columns = {"t_s",
                     "x_m",
                     "x_error_m",
                     "y_m",
                     "y_error_m",
                     "turn_rad",
                     "turn_error_rad",
                     "vx_m_per_s",
                     "vy_m_per_s",
                     "w_rad_per_s",
                     "deflection_x_m",
                     "deflection_y_m",
                     "deflection_turn_rad",
                     "force_x_N",
                     "force_y_N",
                     "moment_Nm"};
  }
  for (const char* name : {"share_of_limit", "slips", "kinetic_J", "stored_J", "work_J", "dissipated_J", "balance_J"})
    table.columns.emplace_back(name);
  for (const MotionRow& r : record.rows) {
    std::vector<double> cells;
    if (point) {
      cells = {r.time, r.place[0], r.error[0], r.twist[0], r.deflection[0], r.friction[0]};
    } else {
      cells = {r.time,          r.place[0],    r.error[0],    r.place[1],   r.error[1],      r.place[2],
               r.error[2],      r.twist[0],    r.twist[1],    r.twist[2],   r.deflection[0], r.deflection[1],
               r.deflection[2], r.friction[0], r.friction[1], r.friction[2]};
    }
    const double balance = r.kinetic + r.stored - start - (r.work - r.dissipated - before);
    cells.insert(cells.end(), {r.share, r.slips ? 1. : 0., r.kinetic, r.stored, r.work, r.dissipated, balance});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace patchgrip::cli
