#include <patchgrip/cli/simulate/motion_record.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace patchgrip::cli {
namespace {

void add_error(MotionEvent& event, const MotionEvent& other, double factor) {
  event.time_error += factor * std::fabs(event.time - other.time);
}

void add_error(std::optional<MotionEvent>& event, const std::optional<MotionEvent>& other, double factor) {
  if (event && other) {
    add_error(*event, *other, factor);
  } else if (event) {
    event->time_error = not_known;
  }
}

void add_errors(std::vector<MotionRow>& rows, const std::vector<MotionRow>& others, double factor, double tolerance) {
  Vector3 largest = Vector3::Zero();
  for (std::size_t i = 0; i < std::min(rows.size(), others.size()); ++i) {
    largest = largest.cwiseMax(factor * (rows[i].place - others[i].place).cwiseAbs());
    rows[i].error = largest + tolerance * (Vector3::Ones() + rows[i].place.cwiseAbs());
  }
}

// Of one body, `prefix` before the names.
void add_names(std::vector<std::string>& columns, const std::string& prefix, std::initializer_list<const char*> names) {
  for (const char* name : names) columns.push_back(prefix + name);
}

void add_planar_cells(std::vector<double>& cells, const MotionRow& r) {
  cells.insert(cells.end(), {r.place[0], r.error[0], r.place[1], r.error[1], r.place[2], r.error[2], r.twist[0],
                             r.twist[1], r.twist[2], r.deflection[0], r.deflection[1], r.deflection[2], r.friction[0],
                             r.friction[1], r.friction[2], r.share, r.slips ? 1. : 0.});
}

}  // namespace

void estimate_errors(MotionRecord& record, const MotionRecord& other, double factor, double tolerance) {
  add_errors(record.rows, other.rows, factor, tolerance);
  add_errors(record.upper_rows, other.upper_rows, factor, tolerance);
  bool alike = true;
  for (std::size_t i = 0; i < record.events.size(); ++i) {
    alike = alike && i < other.events.size() && other.events[i].kind == record.events[i].kind &&
            other.events[i].upper == record.events[i].upper;
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
  add_error(record.rest, other.rest, factor);
  add_error(record.upper_rest, other.upper_rest, factor);
}

double drift_in_stick(const std::vector<MotionRow>& rows, double support_speed) {
  const auto anchor = [&](const MotionRow& r) {
    const Vector3 foot = r.anchor.value_or(r.place - r.deflection);
    return Eigen::Vector2d(foot[0] - support_speed * r.time, foot[1]);
  };
  double way = 0;
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
  const bool stack = !record.upper_rows.empty();
  if (point) {
    table.columns = {"t_s", "x_m", "x_error_m", "v_m_per_s", "deflection_m", "friction_N", "share_of_limit", "slips"};
  } else {
    table.columns = {"t_s"};
    for (const char* prefix : {"", "upper_"}) {
      if (*prefix != 0 && !stack) continue;
      add_names(table.columns, prefix,
                {"x_m", "x_error_m", "y_m", "y_error_m", "turn_rad", "turn_error_rad", "vx_m_per_s", "vy_m_per_s",
                 "w_rad_per_s", "deflection_x_m", "deflection_y_m", "deflection_turn_rad", "force_x_N", "force_y_N",
                 "moment_Nm", "share_of_limit", "slips"});
    }
  }
  add_names(table.columns, "", {"kinetic_J", "stored_J", "work_J", "dissipated_J", "balance_J"});
  for (std::size_t i = 0; i < record.rows.size(); ++i) {
    const MotionRow& r = record.rows[i];
    std::vector<double> cells{r.time};
    if (point) {
      cells.insert(cells.end(),
                   {r.place[0], r.error[0], r.twist[0], r.deflection[0], r.friction[0], r.share, r.slips ? 1. : 0.});
    } else {
      add_planar_cells(cells, r);
      if (stack) add_planar_cells(cells, record.upper_rows[i]);
    }
    const double balance = r.kinetic + r.stored - start - (r.work - r.dissipated - before);
    cells.insert(cells.end(), {r.kinetic, r.stored, r.work, r.dissipated, balance});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace patchgrip::cli
