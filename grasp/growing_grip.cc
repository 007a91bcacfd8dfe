#include <patchgrip/grasp/growing_grip.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include <patchgrip/contact/require.h>

namespace patchgrip::grasp {
namespace {

// Contacts are made anew for each grip, but not smaller than under this share of the largest force: a finger that
// hardly presses carries no load either.
constexpr double least_share = 1e-9;

// Relative; of a contact that is made smaller than its force would: rounding must not make it too large.
constexpr double spare = 1e-14;

// A force to start from.
double size_of(const Vector6& load, const std::vector<GrowingContact>& contacts) {
  double reach = 0;
  for (const GrowingContact& c : contacts) reach = std::max(reach, c(1).position().norm());
  return load.head<3>().norm() + load.tail<3>().norm() / (reach > 0 ? reach : 1);
}

Grasp under(const std::vector<GrowingContact>& contacts, const std::vector<double>& forces,
            const GripSettings& settings) {
  std::vector<Contact> made;
  made.reserve(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) made.push_back(contacts[i](forces[i]));
  return Grasp(std::move(made), settings);
}

}  // namespace

GrowingGrip least_growing_grip(const std::vector<GrowingContact>& contacts, const Vector6& load,
                               const GripSettings& settings) {
  settings.check();
  for (const double x : load) contact::require_finite("load", x);
  GrowingGrip grip;
  if (load.isZero(0)) {
    grip.verdict = grip.lower_answer.verdict = grip.upper_answer.verdict = Verdict::holds;
    grip.lower_answer.contacts.resize(contacts.size());
    grip.upper_answer.contacts.resize(contacts.size());
    return grip;
  }
  std::vector<double> forces(contacts.size());
  const auto answer_at = [&](double s) {
    std::ranges::fill(forces, s);
    return under(contacts, forces, settings).least_grip(load);
  };

  // p(s) = s, in the logarithm; p falls.
  const auto excess = [&](double log_s) { return std::log(answer_at(std::exp(log_s)).value) - log_s; };
  const double start = std::log(size_of(load, contacts));
  double low = start, high = start;
  while (excess(high) > 0 && high < start + std::log(settings.force_limit)) high += 1;
  while (excess(low) < 0 && low > start - std::log(settings.force_limit)) low -= 1;
  double s = std::exp(high);
  if (low < high && excess(high) <= 0) {
    std::uintmax_t most = 100;
    const auto [a, b] =
        boost::math::tools::toms748_solve(excess, low, high, boost::math::tools::eps_tolerance<double>(52), most);
    s = std::exp((a + b) / 2);
  }
  grip.lower_answer = answer_at(s);
  grip.lower = std::min(s, grip.lower_answer.lower);

  grip.upper = std::numeric_limits<double>::infinity();
  if (grip.lower_answer.verdict != Verdict::holds) {
    grip.verdict = grip.lower_answer.verdict;
    return grip;
  }

  // Contacts as large as their own forces make them, by damped iteration; then only as large as that, to the last digit.
  std::ranges::fill(forces, grip.lower);
  for (int round = 0; round < 60; ++round) {
    const GripAnswer answer = under(contacts, forces, settings).least_grip(load);
    if (answer.verdict != Verdict::holds) break;
    double change = 0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const double own = std::max(answer.contacts[i].normal_force, least_share * answer.upper);
      change = std::max(change, std::fabs(own - forces[i]) / answer.upper);
      forces[i] = (forces[i] + own) / 2;
    }
    if (change < spare) break;
  }
  constexpr int most_rounds = 200;
  for (int round = 0; round < most_rounds; ++round) {
    const GripAnswer answer = under(contacts, forces, settings).least_grip(load);
    if (answer.verdict != Verdict::holds) break;
    bool admissible = true;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const double F = answer.contacts[i].normal_force;
      if (F == 0 || F >= forces[i]) continue;
      admissible = false;
      forces[i] = std::max(F, least_share * answer.upper) * (1 - spare);
    }
    if (!admissible) continue;
    grip.upper = answer.upper;
    grip.upper_answer = answer;
    grip.verdict = Verdict::holds;
    break;
  }
  return grip;
}

}  // namespace patchgrip::grasp
