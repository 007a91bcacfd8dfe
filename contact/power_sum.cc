#include <patchgrip/contact/power_sum.h>

#include <algorithm>

#include <patchgrip/contact/increasing_root.h>

namespace patchgrip::contact {

PowerSum PowerSum::of(std::vector<PowerProfile> powers) {
  require_in("number of powers", static_cast<double>(powers.size()), 1, 1000);
  return PowerSum(std::move(powers));
}

PowerSum PowerSum::sphere_series(double radius, int terms) {
  require_positive("radius", radius);
  require_in("terms", terms, 1, 500);
  std::vector<PowerProfile> powers;
  double c = 0.5;
  for (int k = 1; k <= terms; ++k) {
    powers.push_back(PowerProfile::through(c * radius, radius, 2 * k));
    c *= (2 * k - 1.) / (2 * k + 2);
  }
  return PowerSum(std::move(powers));
}

// Each power alone would need at most its own radius; all of them together need less than the smallest of those.
double PowerSum::radius_of_approach(double approach) const {
  double start = std::numeric_limits<double>::infinity();
  for (const PowerProfile& power : powers_) start = std::min(start, power.radius_of_approach(approach));
  return increasing_root([&](double a) { return this->approach(a); }, [&](double a) { return approach_slope(a); },
                         approach, start);
}

double PowerSum::radius_of_force(double force) const {
  double start = std::numeric_limits<double>::infinity();
  for (const PowerProfile& power : powers_) start = std::min(start, power.radius_of_force(force));
  return increasing_root([&](double a) { return this->force(a); }, [&](double a) { return 2 * a * approach_slope(a); },
                         force, start);
}

ProfileErrors PowerSum::errors() const noexcept {
  ProfileErrors largest{};
  double flattest = std::numeric_limits<double>::infinity();
  for (const PowerProfile& power : powers_) {
    const ProfileErrors e = power.errors();
    largest.approach = std::max(largest.approach, e.approach);
    largest.force = std::max(largest.force, e.force);
    largest.pressure = std::max(largest.pressure, e.pressure);
    largest.displacement = std::max(largest.displacement, e.displacement);
    flattest = std::min(flattest, power.exponent());
  }
  const double added = static_cast<double>(powers_.size());
  largest.approach += added;
  largest.force += added;
  largest.pressure += added;
  largest.displacement += added;
  // Newton ends within rounding of where the computed value crosses: the error of the value over the local exponent.
  largest.radius = 4 + std::max(largest.approach / flattest, largest.force / (flattest + 1));
  return largest;
}

}  // namespace patchgrip::contact
