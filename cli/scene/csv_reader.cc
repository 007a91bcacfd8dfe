#include <patchgrip/cli/scene/csv_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const auto begin = text.find_first_not_of(blank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

std::string_view unquoted(std::string_view cell) {
  return cell.size() > 1 && cell.front() == '"' && cell.back() == '"' ? cell.substr(1, cell.size() - 2) : cell;
}

// A letter, then anything but what stands between columns elsewhere.
bool is_name(std::string_view cell) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !cell.empty() && is_letter(cell.front()) && cell.find_first_of(";\t\"") == std::string_view::npos;
}

class Reader {
 public:
  Reader(const TomlReader& table, std::string_view key, std::span<const std::string_view> names)
      : table_(table), key_(key), names_(names), in_(beside_scene(table, key)) {
    if (!in_) fail("cannot be read");
  }

  NumberRows read() {
    for (std::string text; std::getline(in_, text);) {
      if (++line_ == 1 && text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
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
    cells_.clear();
    for (bool more = true; more;) {
      const auto comma = row.find(',');
      more = comma != std::string_view::npos;
      cells_.push_back(trimmed(row.substr(0, comma)));
      if (more) row.remove_prefix(comma + 1);
    }
    if (first_ == 0) {
      first_ = line_;
      width_ = cells_.size();
      if (is_header()) return read_header();
      for (std::size_t i = 0; i < width_; ++i) used_.push_back(i);
    }
    if (cells_.size() != width_) fail(fmt::format("{} columns, but line {} has {}", cells_.size(), first_, width_));
    if (read_.numbers.size() + used_.size() > most_numbers) fail(fmt::format("more than {} numbers", most_numbers));
    for (const std::size_t column : used_) read_.numbers.push_back(number(cells_[column], column));
    read_.columns = used_.size();
    read_.lines.push_back(line_);
  }

  bool is_header() const {
    return !names_.empty() && std::ranges::all_of(cells_, [](std::string_view cell) {
      return cell.empty() || (is_name(unquoted(cell)) && !parsed(cell));
    });
  }

  void read_header() {
    read_.has_header = true;
    std::ranges::transform(cells_, cells_.begin(), unquoted);
    for (const std::string_view name : names_) {
      const auto found = std::ranges::find(cells_, name);
      if (found == cells_.end())
        fail(fmt::format("no column is headed {}: {} are needed", name, fmt::join(names_, ", ")));
      if (std::ranges::count(cells_, name) > 1) fail(fmt::format("more than one column is headed {}", name));
      used_.push_back(static_cast<std::size_t>(found - cells_.begin()));
    }
  }

  static std::optional<double> parsed(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
  }

  double number(std::string_view text, std::size_t column) const {
    if (text.empty()) {
      // The first row says how many there are.
      const bool ends_with_comma = line_ == first_ && column > 0 && column + 1 == width_;
      fail(fmt::format("column {} is empty{}", column + 1, ends_with_comma ? ": a comma too many" : ""));
    }
    const auto value = parsed(text);
    if (value && std::isfinite(*value)) return *value;
    const bool otherwise = width_ == 1 && text.find_first_of("; \t") != std::string_view::npos;
    fail(fmt::format("column {}: '{}' is not a finite number{}", column + 1, printable(text, 30),
                     otherwise ? "; numbers are separated by commas" : ""));
  }

  [[noreturn]] void fail(const std::string& what) const { refuse_line(table_, key_, line_, what); }

  const TomlReader& table_;
  std::string_view key_;
  std::span<const std::string_view> names_;
  std::ifstream in_;
  std::vector<std::string_view> cells_;  // of a row
  std::vector<std::size_t> used_;        // columns
  std::size_t line_ = 0, first_ = 0;     // first: the line that says the width
  std::size_t width_ = 0;
  NumberRows read_;
};

}  // namespace

NumberRows read_numbers(const TomlReader& table, std::string_view key, std::span<const std::string_view> names) {
  return Reader(table, key, names).read();
}

void refuse_line(const TomlReader& table, std::string_view key, std::size_t line, std::string_view why) {
  const Place place = table.place(key);
  throw SceneError(beside_scene(table, key).string(), line,
                   fmt::format("{}, read for {}", why, located(place.file, place.line, place.words)));
}

std::filesystem::path beside_scene(const TomlReader& table, std::string_view key) {
  std::filesystem::path file = std::filesystem::path(table.document().name()).parent_path() / table.text(key);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) table.refuse(key, "no such file: " + file.string());
  return file;
}

}  // namespace patchgrip::cli
