#include <patchgrip/verification/study.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace patchgrip::verification {
namespace {

using Values = std::vector<double>;

constexpr std::size_t most_triangles = 4000;  // of a picture

struct Refined {
  Values error;
  double order;
};

Refined refined(const std::vector<Run>& runs, std::size_t quantity) {
  const std::size_t last = runs.size() - 1;
  const auto& fine = runs[last].values[quantity];
  const auto& coarse = runs[last - 1].values[quantity];
  const double ratio = runs[last].setting.elements / runs[last - 1].setting.elements;
  Values step = distances(fine, coarse);
  double order = std::numeric_limits<double>::quiet_NaN();
  double trusted = 1;
  if (last >= 2) {
    const Values before = distances(coarse, runs[last - 2].values[quantity]);
    order = std::log(largest_of(before) / largest_of(step)) / std::log(ratio);
    trusted = std::isnan(order) ? 1 : std::clamp(order, 0.5, 2.);
    for (std::size_t k = 0; k < step.size(); ++k) step[k] = std::max(step[k], before[k] / (ratio * ratio));
  }
  for (double& error : step) error /= std::pow(ratio, trusted) - 1;
  return {step, order};
}

Run timed(const Setting& setting, const Solver& solve, Solved& solved) {
  const auto begin = std::chrono::steady_clock::now();
  solved = solve(setting);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  return {setting, solved.unknowns, solved.iterations, taken.count(), solved.values};
}

}  // namespace

Study study(const std::vector<Quantity>& quantities, const std::vector<Setting>& settings, const Solver& solve,
            const std::function<void(const Run&)>& progress) {
  Study study;
  for (const Setting& setting : settings) {
    study.runs.push_back(timed(setting, solve, study.finest));
    progress(study.runs.back());
    if (study.finest.stress && (!study.stress || study.finest.stress->triangles.size() <= most_triangles)) {
      study.stress = study.finest.stress;
    }
    if (study.finest.values.size() != quantities.size()) throw std::logic_error("a case solves what it does not claim");
  }
  if (settings.front().extent > 0) {
    Solved larger;
    const Setting& coarse = settings[settings.size() - 2];
    study.larger_body = timed({coarse.elements, 2 * coarse.extent}, solve, larger);
    progress(*study.larger_body);
  }
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    auto [error, order] = refined(study.runs, q);
    if (study.larger_body) {
      const Values moved = distances(study.larger_body->values[q], study.runs[settings.size() - 2].values[q]);
      for (std::size_t k = 0; k < error.size(); ++k) error[k] += 4. / 3 * moved[k];
    }
    study.comparisons.push_back(compare(quantities[q], study.runs.back().values[q], error, order));
  }
  return study;
}

}  // namespace patchgrip::verification
