#include <patchgrip/cli/press/press_tables.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/scene/direction.h>
#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

std::string with_unit(const std::string& name, const std::string& unit) {
  if (unit == "1") return name;
  std::string suffix = unit;
  for (std::size_t at = 0; (at = suffix.find_first_of("/^ ", at)) != std::string::npos;) suffix[at] = '_';
  return name + "_" + suffix;
}

// The cell of a column in a row; a column that is new is empty in the rows before.
double& cell(Table& table, std::vector<double>& row, const std::string& column) {
  const auto found = std::ranges::find(table.columns, column);
  const auto index = static_cast<std::size_t>(found - table.columns.begin());
  if (found == table.columns.end()) table.columns.push_back(column);
  if (row.size() <= index) row.resize(index + 1, not_known);
  return row[index];
}

void add_law(Table& table, std::vector<double>& row, const LawAnswer& law, const std::string& prefix) {
  for (const Result& r : law.results) {
    cell(table, row, with_unit(prefix + r.name, r.unit)) = r.value;
    cell(table, row, with_unit(prefix + r.name + "_error", r.unit)) = r.error;
  }
}

}  // namespace

Table surface_table(const PressScene& scene, const Pressed& pressed) {
  if (pressed.map && !scene.profile.distance) return *pressed.map;
  if (!pressed.surface) {
    (scene.adhesion ? scene.adhesion->place : scene.subject_place)
        .refuse(
            fmt::format("{} says nothing about the surface: its table is that of a [sweep]", pressed.answer.main.law));
  }
  const Place& place = scene.profile.place ? *scene.profile.place : load_place(scene);
  const Sequence distance = scene.profile.distances(pressed.extent);
  Table table{{"x_m", "y_m", "pressure_Pa", "pressure_error_Pa"}, {}};
  if (pressed.knows_displacement) {
    for (const char* column : {"displacement_m", "displacement_error_m", "gap_m", "gap_error_m"}) {
      table.columns.emplace_back(column);
    }
  }
  for (const PressureBeside& law : pressed.beside) table.columns.push_back("pressure_" + law.law + "_Pa");
  const Direction along = direction_at(scene.profile.angle);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    InterruptGuard::check();
    const double x = distance[i] * along.x;
    const double y = distance[i] * along.y;
    const SurfacePoint s = at(place, [&] { return pressed.surface(x, y); });
    auto& row = table.rows.emplace_back(std::vector{x, y, s.pressure.value, s.pressure.error});
    if (pressed.knows_displacement) {
      for (const Estimate& b : {s.displacement, s.gap}) row.insert(row.end(), {b.value, b.error});
    }
    for (const PressureBeside& law : pressed.beside) row.push_back(law.pressure(x, y));
  }
  return table;
}

Table sweep_table(const PressScene& scene, std::vector<std::string>& warnings) {
  constexpr std::array<const char*, 5> names{"given_normal_force_N", "given_approach_m", "given_contact_radius_m",
                                             "given_radii_ratio", "given_mu"};
  Table table{{names[static_cast<std::size_t>(scene.sweep->kind)]}, {}};
  const std::size_t values = scene.sweep->values.size();
  std::optional<SceneError> first;
  std::size_t without = 0;
  for (std::size_t i = 0; i < values; ++i) {
    InterruptGuard::check();
    std::vector<double> row{scene.sweep->values[i]};
    try {
      const Answer answer = press(at_sweep_value(scene, i)).answer;
      add_law(table, row, answer.main, "");
      for (const LawAnswer& law : answer.beside) add_law(table, row, law, law.law + "_");
    } catch (const SceneError& error) {
      if (++without == 1) first = error;
    }
    table.rows.push_back(std::move(row));
  }
  if (without == values) throw *first;
  if (without > 0) {
    warnings.push_back(fmt::format("no answer at {} of {} values; the first: {}", without, values, first->what()));
  }
  for (auto& row : table.rows) row.resize(table.columns.size(), not_known);
  return table;
}

}  // namespace patchgrip::cli
