// Scenes for `patchgrip press` as text, and what it answers by name.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <patchgrip/cli/press/answer.h>
#include <patchgrip/cli/press/press_creep.h>
#include <patchgrip/cli/press/press_scene.h>
#include <patchgrip/cli/press/press_tables.h>
#include <patchgrip/cli/table.h>

#include "scenes.h"

namespace patchgrip::cli::test {

inline const std::filesystem::path press_folder = data_folder / "scenes" / "press";

inline PressScene press_scene(std::string text) {
  return read_press_scene(TomlDocument::parse(std::move(text), (press_folder / "scene.toml").string()),
                          MaterialLibrary({data_folder / "materials"}));
}

inline PressScene committed(const std::string& name) {
  return read_press_scene(TomlDocument::read(press_folder / (name + ".toml")),
                          MaterialLibrary({data_folder / "materials"}));
}

inline std::vector<std::string> committed_scenes() { return scenes_in(press_folder); }

// A stamp on soft rubber, E* = 200 kPa / 3.
inline std::string stamp(const std::string& shape, const std::string& load = "normal_force = 0.1") {
  return "[contact]\n" + load + "\n[[contact.bodies]]\n" + shape +
         "\nrigid = true\n[[contact.bodies]]\nplane = true\nyoungs_modulus = 50e3\npoisson_ratio = 0.5\n";
}

struct Answered {
  Answer answer;
  Table table;
};

inline Answered answered(const PressScene& scene) {
  if (std::holds_alternative<TimedLoad>(scene.load)) {
    PressedOverTime pressed = press_over_time(scene);
    return {std::move(pressed.answer), std::move(pressed.table)};
  }
  Pressed pressed = press(scene);
  Table table = scene.sweep ? sweep_table(scene, pressed.answer.warnings) : surface_table(scene, pressed);
  return {std::move(pressed.answer), std::move(table)};
}

inline bool has(const LawAnswer& law, std::string_view name) {
  return std::ranges::find(law.results, name, &Result::name) != law.results.end();
}

inline const Result& result(const LawAnswer& law, std::string_view name) {
  const auto found = std::ranges::find(law.results, name, &Result::name);
  if (found == law.results.end()) throw std::logic_error("no result " + std::string(name));
  return *found;
}

inline double value(const LawAnswer& law, std::string_view name) { return result(law, name).value; }

inline const LawAnswer& beside(const Answer& answer, std::string_view law) {
  const auto found = std::ranges::find(answer.beside, law, &LawAnswer::law);
  if (found == answer.beside.end()) throw std::logic_error("no law " + std::string(law));
  return *found;
}

inline std::size_t column(const Table& table, std::string_view name) {
  const auto found = std::ranges::find(table.columns, name);
  if (found == table.columns.end()) throw std::logic_error("no column " + std::string(name));
  return static_cast<std::size_t>(found - table.columns.begin());
}

}  // namespace patchgrip::cli::test
