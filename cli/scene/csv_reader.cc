#include <patchgrip/cli/scene/csv_reader.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const auto begin = text.find_first_not_of(blank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : name_(file.string()), in_(file) {
    if (!in_) fail("cannot be read");
  }

  NumberRows read() {
    for (std::string text; std::getline(in_, text);) {
      ++line_;
      const std::string_view row = trimmed(text);
      if (!row.empty() && row.front() != '#') read_row(row);
    }
    if (in_.bad()) fail("cannot be read");
    line_ = 0;
    if (read_.lines.empty()) fail("has no numbers");
    return std::move(read_);
  }

 private:
  void read_row(std::string_view row) {
    std::size_t columns = 0;
    for (bool more = true; more;) {
      const auto comma = row.find(',');
      more = comma != std::string_view::npos;
      if (read_.numbers.size() == most_numbers) fail(fmt::format("more than {} numbers", most_numbers));
      read_.numbers.push_back(number(trimmed(row.substr(0, comma)), ++columns));
      if (more) row.remove_prefix(comma + 1);
    }
    if (read_.lines.empty()) read_.columns = columns;
    if (columns != read_.columns) {
      fail(fmt::format("{} columns, but line {} has {}", columns, read_.lines.front(), read_.columns));
    }
    read_.lines.push_back(line_);
  }

  double number(std::string_view text, std::size_t column) const {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = end == text.data() + text.size();
    if (error == std::errc() && whole && std::isfinite(value)) return value;
    fail(fmt::format("column {}: '{}' is not a finite number", column, printable(text, 30)));
  }

  [[noreturn]] void fail(const std::string& what) const { throw SceneError(name_, line_, what); }

  std::string name_;
  std::ifstream in_;
  std::size_t line_ = 0;
  NumberRows read_;
};

}  // namespace

NumberRows read_numbers(const std::filesystem::path& file) { return Reader(file).read(); }

std::filesystem::path beside_scene(const TomlReader& table, std::string_view key) {
  std::filesystem::path file = std::filesystem::path(table.document().name()).parent_path() / table.text(key);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) table.refuse(key, "no such file: " + file.string());
  return file;
}

}  // namespace patchgrip::cli
