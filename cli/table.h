// A table of numbers with named columns, as CSV.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace patchgrip::cli {

// What is not known at a row. An empty cell in CSV.
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  // each as long as `columns`
};

// What a table leaves out, as lines of its head.
void add_warnings(std::vector<std::string>& head, const std::vector<std::string>& warnings);

// `head` are comment lines, without "# ". Throws Interrupted.
std::string to_csv(const Table& table, const std::vector<std::string>& head);

}  // namespace patchgrip::cli
