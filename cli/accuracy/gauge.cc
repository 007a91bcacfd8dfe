// Sections gauge (the least mu F_N that holds a load, and the pole that the load starts a slip about) and stick_radius.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/limit_surface/stick_radius.h>

namespace patchgrip::cli {
namespace {

using friction::Gauge;
using friction::GaugeSettings;
using friction::LimitSurface;
using friction::Wrench;

// As far as rounding goes: the pole is only as good as the root of the error of the gauge.
constexpr GaugeSettings to_rounding{.relative_gap = 1e-15};

AccuracyReport::Kind kind(std::string_view section, const TableContact& contact, std::string_view quantity) {
  return {std::string(section), contact.type(), std::string(quantity)};
}

void compare_direction(const TableContact& contact, TableObject& row, AccuracyReport& report) {
  const Exact phi = row["phi"].number(), theta = row["theta"].number();
  const Exact rho = row["rho_H"].positive();
  const auto q = measure([&](Inputs inputs) {
    return contact.visit(inputs, [&](const auto& patch) {
      const LimitSurface surface(patch, to_rounding);
      return std::array{friction::stick_radius(surface, as_double(phi, inputs), as_double(theta, inputs)).value};
    });
  });
  report.add(kind("stick_radius", contact, "rho_H"), deviation(q, 0, rho, rho), row.node().place());
}

template <class CompareRow>
void compare_rows(const TableNode& node, const char* section, AccuracyReport& report, const CompareRow& compare_row) {
  for (const TableNode& entry_node : node.filled()) {
    auto entry = read_contact_entry(entry_node, section, report);
    if (!entry) continue;
    if (const auto a_K = entry->fields.find_length("a_K")) compare_area_radius(entry->contact, *a_K, section, report);
    for (const TableNode& row_node : entry->fields["rows"].filled()) {
      TableObject row(row_node);
      compare_row(entry->contact, row, report);
      name_unread(row, section, report);
    }
    name_unread(entry->fields, section, report);
  }
}

}  // namespace

void compare_gauge_load(std::string_view section, const TableContact& contact, TableObject& row,
                        AccuracyReport& report) {
  const auto t = row["t"].numbers(3);
  const Exact value = row["gauge_N"].positive();
  const auto pole = row["pole"].numbers(2);
  const auto sense = row.find("spin_sign");
  row.find("dual_check_rel");  // the table's own check of itself
  const auto q = measure([&](Inputs inputs) {
    const Wrench load{as_double(t[0], inputs), as_double(t[1], inputs), as_double(t[2], inputs)};
    return contact.visit(inputs, [&](const auto& patch) {
      const Gauge g = LimitSurface(patch, to_rounding).gauge(load);
      return std::array{g.value / resistance_of(patch), -g.twist.vy / g.twist.w, g.twist.vx / g.twist.w, g.twist.w};
    });
  });
  const std::string& place = row.node().place();
  report.add(kind(section, contact, "gauge"), deviation(q, 0, value, value), place);
  const Exact distance = sqrt(pole[0] * pole[0] + pole[1] * pole[1]);
  const double a_K = contact.visit(Inputs::rounded, [](const auto& patch) { return patch.area_radius(); });
  const bool turns_as_stated = !sense || (sense->number() < 0) == (q.value[3] < 0);
  report.add(kind(section, contact, "pole"),
             turns_as_stated ? deviation(q, 1, std::span(pole), std::max<Exact>(distance, a_K)) : failed, place);
}

void compare_gauge(const TableNode& section, AccuracyReport& report) {
  compare_rows(section, "gauge", report, [](const TableContact& contact, TableObject& row, AccuracyReport& r) {
    compare_gauge_load("gauge", contact, row, r);
  });
}

void compare_stick_radius(const TableNode& section, AccuracyReport& report) {
  compare_rows(section, "stick_radius", report, compare_direction);
}

}  // namespace patchgrip::cli
