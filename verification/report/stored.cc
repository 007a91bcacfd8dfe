#include <patchgrip/verification/report/stored.h>

#include <fmt/format.h>

#include <algorithm>

#include <patchgrip/verification/claims/all_claims.h>
#include <patchgrip/verification/report/result_json.h>

namespace patchgrip::verification {

StoredRun stored_run_of(const Case& one, std::string_view level, const Study& study) {
  StoredRun run{std::string(one.name), std::string(level), versions(), {}, {}};
  for (const Run& mesh : study.runs) {
    run.meshes.push_back({mesh.setting.elements, mesh.setting.extent, mesh.seconds, mesh.values});
  }
  for (const Comparison& c : study.comparisons) run.quantities.push_back({c.quantity.name, c.fe, c.fe_error});
  return run;
}

Reproduction reproduces(const StoredRun& fresh, const StoredRun& stored) {
  const auto claims = claims_of(fresh.name).quantities();
  if (stored.quantities.size() != fresh.quantities.size()) return {false, "  stored: other quantities\n"};
  Reproduction result{true, ""};
  for (std::size_t q = 0; q < fresh.quantities.size(); ++q) {
    const auto& now = fresh.quantities[q];
    const auto& then = stored.quantities[q];
    if (now.name != then.name || now.fe.size() != then.fe.size()) return {false, "  stored: other quantities\n"};
    const double apart = largest_of(distances(now.fe, then.fe)) / claims[q].scale;
    const double bound = (largest_of(now.fe_error) + largest_of(then.fe_error)) / claims[q].scale;
    const bool is_within = apart <= bound;
    result.is_within_bound = result.is_within_bound && is_within;
    result.report += fmt::format("  stored {}: {:.2g} of the scale apart, bound {:.2g}{}\n", now.name, apart, bound,
                                 is_within ? "" : " (NOT reproduced)");
  }
  return result;
}

}  // namespace patchgrip::verification
