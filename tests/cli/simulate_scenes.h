// Scenes of `patchgrip simulate` as text, and what it answers.
#pragma once

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <patchgrip/cli/simulate/run_simulate.h>
#include <patchgrip/cli/simulate/simulate_scene.h>

#include "scenes.h"
#include "scratch_folder.h"

namespace patchgrip::cli::test {

inline const std::filesystem::path simulate_folder = data_folder / "scenes" / "simulate";

inline const std::string good_puck = R"([contact]
patch = "hertz_disc"
radius = 0.05
normal_force = 9.81
[friction]
mu = 0.5
[body]
mass = 1
inertia = 0.00125
velocity = [1, 0]
spin = 20
[motion]
method = "rigid"
times = { from = 0, to = 0.4, count = 41 }
)";

inline const std::string good_point = R"([contact]
patch = "point"
normal_force = 10
[friction]
mu = 0.5
[body]
mass = 2
velocity = [3, 0]
[[applied]]
force = [1, 0]
ramp = [0, 1]
[motion]
times = [0, 1, 2]
)";

inline SimulateScene simulate_scene(std::string text) {
  const TomlDocument document = TomlDocument::parse(std::move(text), "scene.toml");
  return read_simulate_scene(document, MaterialLibrary({data_folder / "materials"}));
}

// The table, its rows by column.
struct MotionTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  std::string head;

  std::vector<double> operator[](const std::string& name) const {
    const auto at = std::ranges::find(columns, name) - columns.begin();
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(row.at(static_cast<std::size_t>(at)));
    return values;
  }
};

inline MotionTable read_motion_table(const std::filesystem::path& file) {
  MotionTable table;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) {
      table.head += line + "\n";
      continue;
    }
    std::istringstream cells(line + ",");
    std::vector<std::string> words;
    for (std::string cell; std::getline(cells, cell, ',');) words.push_back(cell);
    if (table.columns.empty()) {
      table.columns = words;
      continue;
    }
    table.rows.emplace_back();
    for (const std::string& word : words)
      table.rows.back().push_back(word.empty() ? std::nan("") : std::strtod(word.c_str(), nullptr));
  }
  return table;
}

class SimulateTest : public ScratchFolder {
 protected:
  struct Answer {
    nlohmann::json json;
    MotionTable table;

    double value(const char* name) const { return json["summary"][name]["value"]; }
    double error(const char* name) const { return json["summary"][name]["error"]; }
  };

  Answer answer_of(const std::filesystem::path& scene) const {
    const auto json = folder_ / "answer.json", table = folder_ / "motion.csv";
    run_simulate({scene.string(), json.string(), table.string()}, MaterialLibrary({data_folder / "materials"}));
    return {nlohmann::json::parse(std::ifstream(json)), read_motion_table(table)};
  }
  Answer answer_to(const std::string& text) const {
    std::ofstream(folder_ / "scene.toml") << text;
    return answer_of(folder_ / "scene.toml");
  }
  Answer committed(const std::string& name) const { return answer_of(simulate_folder / (name + ".toml")); }
};

}  // namespace patchgrip::cli::test
