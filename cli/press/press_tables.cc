#include <patchgrip/cli/press/press_tables.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/scene/direction.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/cli/unanswered.h>

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

// A warning without its numbers.
std::string wording(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string words;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool exponent = text[i] == 'e' && i > 0 && is_digit(text[i - 1]);
    if (!is_digit(text[i]) && !exponent && std::string_view("+-.").find(text[i]) == std::string_view::npos) {
      words += text[i];
    }
  }
  return words;
}

// What is warned of at the values of a sweep: in the same words once.
class SweepWarnings {
 public:
  void add(const std::string& value, const std::vector<std::string>& warnings) {
    for (const std::string& text : warnings) {
      std::string words = wording(text);
      const auto same = std::ranges::find(all_, words, &Warning::words);
      if (same == all_.end()) {
        all_.push_back({std::move(words), text, value, value, 1, false});
      } else {
        same->last = value;
        ++same->values;
        same->differs = same->differs || text != same->text;
      }
    }
  }

  void append_to(std::vector<std::string>& warnings) const {
    for (const Warning& w : all_) {
      warnings.push_back(w.values == 1 ? fmt::format("{}: {}", w.first, w.text)
                                       : fmt::format("{} to {}, at {} values{} {}", w.first, w.last, w.values,
                                                     w.differs ? "; at the first" : ":", w.text));
    }
  }

 private:
  struct Warning {
    std::string words, text, first, last;
    std::size_t values;
    bool differs;  // in its numbers
  };
  std::vector<Warning> all_;
};

}  // namespace

Pressed press_swept(const PressScene& scene, std::size_t index) {
  const PressScene one = at_sweep_value(scene, index);
  const std::string& words = load_place(one).words;
  try {
    return press(one);
  } catch (const SceneError& error) {
    if (std::string_view(error.what()).find(words) != std::string_view::npos) throw;
    throw SceneError(error, fmt::format(", at {}", words));
  } catch (const std::runtime_error& error) {
    throw Unanswered(load_place(one), error.what());
  }
}

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
  SweepWarnings told;
  for (std::size_t i = 0; i < values; ++i) {
    InterruptGuard::check();
    std::vector<double> row{scene.sweep->values[i]};
    try {
      const Answer answer = press_swept(scene, i).answer;
      add_law(table, row, answer.main, "");
      for (const LawAnswer& law : answer.beside) add_law(table, row, law, law.law + "_");
      told.add(load_place(at_sweep_value(scene, i)).words, answer.warnings);
    } catch (const SceneError& error) {
      if (++without == 1) first = error;
    }
    table.rows.push_back(std::move(row));
  }
  if (without == values) throw *first;
  if (without > 0) {
    warnings.push_back(fmt::format("no answer at {} of {} values; the first: {}", without, values, first->what()));
  }
  told.append_to(warnings);
  for (auto& row : table.rows) row.resize(table.columns.size(), not_known);
  return table;
}

}  // namespace patchgrip::cli
