#include <patchgrip/contact/half_space/height_map.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace patchgrip::contact {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

class Reader {
 public:
  Reader(std::istream& in, std::string_view name) : in_(in), name_(name) {}

  HeightMap read() {
    std::string text;
    while (std::getline(in_, text)) {
      std::string_view rest = text;
      if (++line_ == 1 && rest.starts_with(byte_order_mark)) rest.remove_prefix(byte_order_mark.size());
      if (!rest.empty() && rest.back() == '\r') rest.remove_suffix(1);
      rest = trimmed(rest);
      if (rest.empty() || rest.front() == '#') continue;
      read_row(rest);
    }
    if (in_.bad()) fail("cannot be read");
    if (map_.ny < Grid::least_cells) {
      fail(std::to_string(map_.ny) + " rows, must be at least " + std::to_string(Grid::least_cells));
    }
    return std::move(map_);
  }

 private:
  static std::string_view trimmed(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
  }

  void read_row(std::string_view row) {
    int columns = 0;
    for (bool more = true; more;) {
      const auto comma = row.find(',');
      more = comma != std::string_view::npos;
      if (++columns > Grid::most_cells) fail("more than " + std::to_string(Grid::most_cells) + " columns");
      if (map_.heights.size() == Grid::most_cells_in_all) fail("more than 2^24 numbers");
      map_.heights.push_back(number(trimmed(row.substr(0, comma)), columns));
      if (more) row.remove_prefix(comma + 1);
    }
    if (map_.ny == 0) {
      if (columns < Grid::least_cells) {
        fail(std::to_string(columns) + " columns, must be at least " + std::to_string(Grid::least_cells));
      }
      map_.nx = columns;
      first_line_ = line_;
    } else if (columns != map_.nx) {
      fail(std::to_string(columns) + " columns, but line " + std::to_string(first_line_) + " has " +
           std::to_string(map_.nx));
    }
    if (++map_.ny > Grid::most_cells) fail("more than " + std::to_string(Grid::most_cells) + " rows");
  }

  double number(std::string_view text, int column) const {
    if (text.empty()) fail("column " + std::to_string(column) + " is empty: a comma too many");
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range || (error == std::errc() && !std::isfinite(value))) {
      fail("column " + std::to_string(column) + ": '" + shortened(text) + "' is not a finite double");
    }
    if (error != std::errc() || end != text.data() + text.size()) {
      fail("column " + std::to_string(column) + ": '" + shortened(text) + "' is not a number");
    }
    return value;
  }

  // What is quoted from a file must not flood the terminal.
  static std::string shortened(std::string_view text) {
    std::string result(text.substr(0, 30));
    std::ranges::replace_if(
        result, [](unsigned char c) { return c < 32 || c == 127; }, '?');
    return text.size() > 30 ? result + "..." : result;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(std::string(name_) + ":" + std::to_string(line_) + ": " + what);
  }

  std::istream& in_;
  std::string_view name_;
  int line_ = 0, first_line_ = 0;
  HeightMap map_{0, 0, {}};
};

}  // namespace

HeightMap HeightMap::read(std::istream& in, std::string_view name) { return Reader(in, name).read(); }

std::vector<double> HeightMap::gap_below_flat() const {
  std::vector<double> gap(heights.size());
  const double highest = *std::ranges::max_element(heights);
  std::ranges::transform(heights, gap.begin(), [highest](double height) { return highest - height; });
  return gap;
}

}  // namespace patchgrip::contact
