#include <patchgrip/cli/table.h>

#include <cmath>

#include <patchgrip/cli/csv_number.h>
#include <patchgrip/cli/interrupt.h>

namespace patchgrip::cli {

std::string to_csv(const Table& table, const std::vector<std::string>& head) {
  std::string text;
  for (const std::string& line : head) text += "# " + line + "\n";
  for (const std::string& column : table.columns) text += column + ",";
  text.back() = '\n';
  for (const auto& row : table.rows) {
    InterruptGuard::check();
    for (const double value : row) {
      if (!std::isnan(value)) append_number(text, value);
      text += ',';
    }
    text.back() = '\n';
  }
  return text;
}

}  // namespace patchgrip::cli
