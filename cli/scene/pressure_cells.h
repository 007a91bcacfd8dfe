// Cells of a grid from a table of their centres and pressures, as `patchgrip press` writes it of a height map.
//
//     x_m,y_m,pressure_Pa
//
// One row a cell, in any order, each cell once; x and y each in equal steps, to a thousandth of a step.
#pragma once

#include <array>
#include <string_view>

#include <patchgrip/cli/scene/csv_reader.h>
#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/friction/sampled/pressure_grid.h>

namespace patchgrip::cli {

constexpr std::array<std::string_view, 3> pressure_columns{"x_m", "y_m", "pressure_Pa"};

// `rows` have these columns. Throws SceneError at `key`, which names the file.
friction::PressureCells cells_of(const NumberRows& rows, const TomlReader& table, std::string_view key);

}  // namespace patchgrip::cli
