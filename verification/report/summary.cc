#include <patchgrip/verification/report/summary.h>

#include <fmt/format.h>

#include <cmath>

namespace patchgrip::verification {

std::string progress_line(const Run& run) {
  const std::string extent = run.setting.extent > 0 ? fmt::format(", body {:g} a", run.setting.extent) : "";
  return fmt::format("  n = {:g}{}: {} unknowns, {} iterations, {:.2f} s\n", run.setting.elements, extent, run.unknowns,
                     run.iterations, run.seconds);
}

std::string summary(const Study& study) {
  std::string text;
  for (const Comparison& c : study.comparisons) {
    const std::string order = std::isnan(c.order) ? "" : fmt::format(", order {:.1f}", c.order);
    const std::string tolerance =
        c.quantity.claim == Claim::agrees ? fmt::format(", tolerance {:.2g} %", 100 * c.quantity.tolerance) : "";
    text += fmt::format("  {}: {}{}; difference {:.3g} %, FE's own error {:.3g} %{}{}\n", c.quantity.name,
                        name_of(c.verdict), c.is_as_claimed() ? "" : " (NOT as claimed)", 100 * c.difference,
                        100 * c.relative_error, order, tolerance);
  }
  return text;
}

std::string line_of(const SolverPair& pair, const Agreement& agreement) {
  return fmt::format("GetFEM and CalculiX {}: {} of {}, {} of {}: {:.2g} % apart, their errors {:.2g} %",
                     agreement.is_within_bound ? "agree" : "DO NOT AGREE", pair.first_quantity, pair.first,
                     pair.second_quantity, pair.second, 100 * agreement.apart, 100 * agreement.bound);
}

}  // namespace patchgrip::verification
