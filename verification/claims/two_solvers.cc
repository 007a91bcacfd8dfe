#include <patchgrip/verification/claims/two_solvers.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <patchgrip/verification/claims/all_claims.h>

namespace patchgrip::verification {
namespace {

struct Found {
  std::vector<double> off, error;  // from the library's value and by FE's own estimate, relative to the scale
};

Found found(const StoredRun& run, std::string_view name, std::string_view quantity) {
  const auto claims = claims_of(name).quantities();
  for (std::size_t q = 0; q < claims.size() && run.name == name; ++q) {
    if (claims[q].name != quantity || run.quantities.at(q).name != quantity) continue;
    Found found;
    for (std::size_t k = 0; k < claims[q].library.size(); ++k) {
      found.off.push_back((run.quantities[q].fe.at(k) - claims[q].library[k]) / claims[q].scale);
      found.error.push_back(run.quantities[q].fe_error.at(k) / claims[q].scale);
    }
    return found;
  }
  throw std::out_of_range(fmt::format("the run of '{}' has no '{}' of '{}'", run.name, quantity, name));
}

}  // namespace

std::span<const SolverPair> solver_pairs() {
  static constexpr std::string_view sphere_pressure = "p(r), a/4 <= r <= 3a/4", punch_pressure = "p(r), r <= 0.9 a";
  static constexpr std::array pairs{
      SolverPair{"sphere", "approach", "sphere_ccx", "force", -1.5},
      SolverPair{"sphere", sphere_pressure, "sphere_ccx", sphere_pressure, 1},
      SolverPair{"flat_punch", "approach", "flat_punch_ccx", "force", -1},
      SolverPair{"flat_punch", punch_pressure, "flat_punch_ccx", punch_pressure, 1},
      SolverPair{"creep_shear", "approach", "creep_shear_ccx", "approach", 1},
  };
  return pairs;
}

Agreement agreement(const SolverPair& pair, const StoredRun& first, const StoredRun& second) {
  const Found one = found(first, pair.first, pair.first_quantity);
  const Found other = found(second, pair.second, pair.second_quantity);
  Agreement worst{0, 0, true};
  for (std::size_t k = 0; k < one.off.size(); ++k) {
    const double apart = std::fabs(pair.factor * one.off[k] - other.off.at(k));
    const double bound = std::fabs(pair.factor) * one.error[k] + other.error[k];
    const bool uses_more = k == 0 || apart * worst.bound > worst.apart * bound;
    worst = {uses_more ? apart : worst.apart, uses_more ? bound : worst.bound, worst.is_within_bound && apart <= bound};
  }
  return worst;
}

}  // namespace patchgrip::verification
