#include <patchgrip/cli/accuracy/accuracy.h>

#include <fmt/format.h>

#include <ostream>

#include <patchgrip/cli/accuracy/report.h>
#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

constexpr std::string_view remark =
    "u = 2^-53. Errors contain the rounding of the table's decimals to double; 'own' is the worst that is left without "
    "it, to\n"
    "first order. The smaller of the two is held against the tolerance, less what the table states of itself.\n";

AccuracyReport report_on(const std::string& file) {
  const TableValue table = read_table(file);
  AccuracyReport report;
  compare_table(TableNode(table, file), report);
  return report;
}

}  // namespace

int run_accuracy(const std::vector<std::string>& tables, double tolerance, bool allow_uncovered, std::ostream& out) {
  bool passed = true;
  for (const std::string& file : tables) {
    const AccuracyReport report = report_on(file);
    out << fmt::format("{}\n", printable(file, file.size()));
    report.print(out, tolerance);
    const std::size_t beyond = report.kinds_beyond(tolerance);
    out << fmt::format("{} entries compared, {} kinds beyond {:g}, {} kinds or fields not covered{}\n\n",
                       report.entries(), beyond, tolerance, report.not_covered(),
                       allow_uncovered && report.not_covered() > 0 ? " (allowed)" : "");
    passed = passed && beyond == 0 && (allow_uncovered || report.not_covered() == 0);
  }
  out << remark;
  return passed ? 0 : 1;
}

}  // namespace patchgrip::cli
