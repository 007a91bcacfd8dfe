#include <patchgrip/cli/table.h>

#include <cmath>
#include <cstddef>

#include <patchgrip/cli/csv_number.h>
#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/progress.h>

namespace patchgrip::cli {

void add_warnings(std::vector<std::string>& head, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) head.push_back("warning: " + warning);
}

std::string to_csv(const Table& table, const std::vector<std::string>& head) {
  std::string text;
  for (const std::string& line : head) text += "# " + line + "\n";
  for (const std::string& column : table.columns) text += column + ",";
  text.back() = '\n';
  Progress progress("table", table.rows.size(), Progress::wanted(Progress::no_output));
  std::size_t done = 0;
  for (const auto& row : table.rows) {
    InterruptGuard::check();
    progress.at(done++);
    for (const double value : row) {
      if (!std::isnan(value)) append_number(text, value);
      text += ',';
    }
    text.back() = '\n';
  }
  return text;
}

}  // namespace patchgrip::cli
