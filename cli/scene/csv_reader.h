// Rows of numbers from a text file beside a scene: heights or pressures of a grid, or a table of `patchgrip press`.
//
//     # any number of comments, and empty lines
//     1.2e3, 0.8e3, 1.1e3
//
// Numbers separated by commas; blanks around them are ignored. All rows are of the same length.
//
// Where columns are asked for by name, the first row may be their header: names alone, in quotes or not. Then only
// these columns are kept, in the order that is asked for, and the others may hold anything.
//
// Throws   SceneError naming file, line and column, and the key of the scene that asks for the file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include <patchgrip/cli/scene/toml_reader.h>

namespace patchgrip::cli {

struct NumberRows {
  std::size_t rows() const noexcept { return lines.size(); }
  std::span<const double> operator[](std::size_t row) const noexcept {
    return std::span(numbers).subspan(row * columns, columns);
  }

  bool has_header = false;
  std::size_t columns = 0;
  std::vector<double> numbers;     // row by row
  std::vector<std::size_t> lines;  // of the file, of each row
};

constexpr std::size_t most_numbers = std::size_t{1} << 24;

// The file that a key names, looked for beside the scene.
std::filesystem::path beside_scene(const TomlReader& table, std::string_view key);

// The numbers in it.
NumberRows read_numbers(const TomlReader& table, std::string_view key, std::span<const std::string_view> names = {});

// Refuses a line of it; line 0 is the file as a whole.
[[noreturn]] void refuse_line(const TomlReader& table, std::string_view key, std::size_t line, std::string_view why);

}  // namespace patchgrip::cli
