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

// (h_0^p - h_1^p) / (h_1^p - h_2^p), h = 1 / n; it grows with p.
double ratio_at(double n_0, double n_1, double n_2, double p) {
  const double from = std::log(n_1 / n_0), to = std::log(n_2 / n_1);
  return p == 0 ? from / to : std::expm1(p * from) / -std::expm1(-p * to);
}

Refined refined(const std::vector<Run>& runs, std::size_t quantity) {
  constexpr double highest_order = 2;
  const std::size_t last = runs.size() - 1;
  const auto elements = [&](std::size_t run) { return runs[run].setting.elements; };
  const auto& coarse = runs[last - 1].values[quantity];
  Values step = distances(runs[last].values[quantity], coarse);
  double order = std::numeric_limits<double>::quiet_NaN();
  double trusted = 1;
  if (last >= 2) {
    const double n_0 = elements(last - 2), n_1 = elements(last - 1), n_2 = elements(last);
    const Values before = distances(coarse, runs[last - 2].values[quantity]);
    order = observed_order(n_0, n_1, n_2, largest_of(before) / largest_of(step));
    trusted = std::isnan(order) ? 0.5 : std::clamp(order, 0.5, highest_order);
    const double shrunk = ratio_at(n_0, n_1, n_2, highest_order);
    for (std::size_t k = 0; k < step.size(); ++k) step[k] = std::max(step[k], before[k] / shrunk);
  }
  for (double& error : step) error /= std::pow(elements(last) / elements(last - 1), trusted) - 1;
  return {step, order};
}

Run timed(const std::vector<Quantity>& quantities, const Setting& setting, const Solver& solve, Solved& solved) {
  const auto begin = std::chrono::steady_clock::now();
  solved = solve(setting);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  if (solved.values.size() != quantities.size()) throw std::logic_error("a case solves what it does not claim");
  for (std::size_t q = 0; q < quantities.size(); ++q) require_complete(quantities[q], solved.values[q]);
  return {setting, solved.unknowns, solved.iterations, taken.count(), solved.values};
}

}  // namespace

double observed_order(double n_0, double n_1, double n_2, double ratio_of_steps) {
  double low = -6, high = 20;
  const auto is_below = [&](double p) { return ratio_at(n_0, n_1, n_2, p) < ratio_of_steps; };
  if (!is_below(low) || is_below(high)) return std::numeric_limits<double>::quiet_NaN();
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (is_below(middle) ? low : high) = middle;
  }
  return (low + high) / 2;
}

Study study(const std::vector<Quantity>& quantities, const std::vector<Setting>& settings, const Solver& solve,
            const std::function<void(const Run&)>& progress) {
  Study study;
  for (const Setting& setting : settings) {
    study.runs.push_back(timed(quantities, setting, solve, study.finest));
    progress(study.runs.back());
    if (study.finest.stress && (!study.stress || study.finest.stress->triangles.size() <= most_triangles)) {
      study.stress = study.finest.stress;
    }
  }
  if (settings.front().extent > 0) {
    Solved larger;
    const Setting& coarse = settings[settings.size() - 2];
    study.larger_body = timed(quantities, {coarse.elements, 2 * coarse.extent}, solve, larger);
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
