// Whether a profile keeps the errors that it states: its double against its own formulas in fifty digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::testing {

// Errors over what is stated; all must stay below one.
struct WorstErrors {
  double approach = 0, slope = 0, force = 0, pressure = 0, displacement = 0, radius = 0, exchange = 0;

  template <class P>
  void of_functions(const P& profile, double a, double inside, double outside) {
    const contact::ProfileErrors e = profile.errors();
    const Exact exact(a);
    take(approach, units_of_rounding(profile.approach(a), profile.approach(exact)) / e.approach);
    take(slope, units_of_rounding(profile.approach_slope(a), profile.approach_slope(exact)) / e.approach);
    take(force, units_of_rounding(profile.force(a), profile.force(exact)) / e.force);
    if (inside > 0 && inside < a) {
      take(pressure,
           units_of_rounding(profile.pressure(inside, a), profile.pressure(Exact(inside), exact)) / e.pressure);
    }
    if (outside > a) {
      take(displacement,
           units_of_rounding(profile.displacement(outside, a), profile.displacement(Exact(outside), exact)) /
               e.displacement);
    }
  }

  // of_force and of_approach are the true radii of `force` and `approach`.
  template <class P>
  void of_inversions(const P& profile, double load, const Exact& of_force, double depth, const Exact& of_approach) {
    using Contact = contact::AxisymmetricContact<P>;
    const contact::ProfileErrors e = profile.errors();
    take(radius, units_of_rounding(profile.radius_of_force(load), of_force) / e.radius);
    take(radius, units_of_rounding(profile.radius_of_approach(depth), of_approach) / e.radius);
    const auto loaded = Contact::under_force(profile, load, 1);
    const auto moved = Contact::at_approach(profile, depth, 1);
    take(exchange, units_of_rounding(loaded.approach(), profile.approach(of_force)) * 0x1p-53 * loaded.approach() /
                       loaded.approach_error());
    take(exchange,
         units_of_rounding(moved.force(), profile.force(of_approach)) * 0x1p-53 * moved.force() / moved.force_error());
  }

  void expect_within_stated() const {
    const auto check = [](const char* name, double value) {
      ::testing::Test::RecordProperty(name, std::to_string(value));
      EXPECT_LE(value, 1) << name;
    };
    check("approach", approach);
    check("slope", slope);
    check("force", force);
    check("pressure", pressure);
    check("displacement", displacement);
    check("radius", radius);
    check("exchange", exchange);
  }

 private:
  static void take(double& worst, double value) { worst = std::isnan(value) ? value : std::max(worst, value); }
};

}  // namespace patchgrip::testing
