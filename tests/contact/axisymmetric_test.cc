#include <patchgrip/contact/axisymmetric.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/contact/cone.h>
#include <patchgrip/contact/endpoint_quadrature.h>
#include <patchgrip/contact/flat_end_cone.h>
#include <patchgrip/contact/flat_end_paraboloid.h>
#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/point_profile.h>
#include <patchgrip/contact/power_sum.h>
#include <patchgrip/contact/sphere.h>

namespace patchgrip::contact {
namespace {

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

// A profile, and the radii at which its slope jumps.
template <class P>
struct Case {
  const char* name;
  P profile;
  std::vector<double> jumps;
};

template <class Law>
void for_each_profile(const Law& law) {
  law(Case<Paraboloid>{"paraboloid", Paraboloid::of_radius(2), {}});
  law(Case<Cone>{"cone", Cone::of_slope(0.3), {}});
  law(Case<PowerProfile>{"power 0.4", PowerProfile::of_coefficient(0.3, 0.4), {}});
  law(Case<PowerProfile>{"power 1.7", PowerProfile::of_coefficient(0.3, 1.7), {}});
  law(Case<PowerProfile>{"power 5.2", PowerProfile::of_coefficient(0.3, 5.2), {}});
  law(Case<PowerProfile>{"power 30", PowerProfile::of_coefficient(0.3, 30), {}});
  law(Case<PowerSum>{"sphere series", PowerSum::sphere_series(1.5, 6), {}});
  law(Case<Sphere>{"sphere", Sphere::of_radius(1.2), {}});
  law(Case<FlatEndParaboloid>{"flat end, paraboloid", FlatEndParaboloid::of(0.4, 2), {0.4}});
  law(Case<FlatEndCone>{"flat end, cone", FlatEndCone::of(0.4, 0.3), {0.4}});
  law(Case<PointProfile>{"points",
                         PointProfile::through(std::vector<ProfilePoint>{{0, 0}, {0.3, 0.02}, {0.8, 0.1}, {2.5, 0.9}}),
                         {0.3, 0.8}});
}

// Integral over [lo, hi] of f(r), in pieces between the jumps and a.
template <class F>
double piecewise(const F& f, double lo, double hi, std::vector<double> jumps) {
  std::erase_if(jumps, [&](double b) { return b <= lo || b >= hi; });
  jumps.push_back(hi);
  std::sort(jumps.begin(), jumps.end());
  double sum = 0;
  for (const double end : jumps) {
    // On the jump itself, where rounding leads, the logarithm is cut off.
    sum += integrate_to_both_ends(
        [&](double since, double left) {
          const double r = since < left ? lo + since : end - left;
          return r == lo || r == end ? 0. : f(r);
        },
        lo, end);
    lo = end;
  }
  return sum;
}

TEST(AxisymmetricContact, PressureCarriesTheForce) {
  for_each_profile([](const auto& c) {
    for (const double a : {0.45, 1.1}) {
      const double carried =
          piecewise([&](double r) { return 2 * std::numbers::pi * r * c.profile.pressure(r, a); }, 0, a, c.jumps);
      EXPECT_NEAR(carried / c.profile.force(a), 1, 1e-12) << c.name << " at " << a;
    }
  });
}

TEST(AxisymmetricContact, StiffnessIsTwiceTheRadius) {
  for_each_profile([](const auto& c) {
    for (const double a : {0.45, 1.1}) {
      const double h = 1e-5 * a;
      const double dF = c.profile.force(a + h) - c.profile.force(a - h);
      const double d = c.profile.approach(a + h) - c.profile.approach(a - h);
      EXPECT_NEAR(dF / d / (2 * a), 1, 1e-7) << c.name << " at " << a;
      EXPECT_NEAR(d / (2 * h) / c.profile.approach_slope(a), 1, 1e-5) << c.name << " at " << a;
    }
  });
}

TEST(AxisymmetricContact, PunchLoadsAddUpToOne) {
  for_each_profile([](const auto& c) {
    for (const double a : {0.45, 1.1}) {
      const double all = piecewise([&](double x) { return punch_load_density(c.profile, x, a); }, 0, a, c.jumps);
      EXPECT_NEAR(all, 1, 1e-7) << c.name << " at " << a;  // g' ~ (x - b)^(-1/2) is cut off at the rounding of x
    }
  });
}

TEST(AxisymmetricContact, SurfaceIsContinuousAtTheRimAndFarAwayThatOfAPointLoad) {
  for_each_profile([](const auto& c) {
    for (const double a : {0.45, 1.1}) {
      const double inside = c.profile.displacement(a, a);
      const double outside = c.profile.displacement(a * (1 + 1e-15), a);
      EXPECT_NEAR(outside / inside, 1, 1e-12) << c.name;
      EXPECT_NEAR(c.profile.displacement(1e7, a) * std::numbers::pi * 1e7 / c.profile.force(a), 1, 1e-12) << c.name;
    }
  });
}

TEST(AxisymmetricContact, GapOpensMonotonically) {
  for_each_profile([](const auto& c) {
    const auto contact = AxisymmetricContact<std::decay_t<decltype(c.profile)>>::at_radius(c.profile, 0.9, 2);
    double before = 0;
    for (double r = 0.9; r < 1.19; r += 0.01) {
      const double gap = contact.gap(r);
      EXPECT_GE(gap, before) << c.name << " at " << r;
      before = gap;
    }
    EXPECT_GT(before, 0) << c.name;
  });
}

// Betti: what the pressures of one contact do in the displacements of the other does not depend on which is which.
TEST(AxisymmetricContact, TwoPressuresAreReciprocal) {
  const double a = 0.7;
  const double other = 1.05;
  const auto second = FlatEndCone::of(0.5, 0.2);
  for_each_profile([&](const auto& c) {
    auto jumps = c.jumps;
    jumps.insert(jumps.end(), {0.5, a, other});
    const double one =
        piecewise([&](double r) { return r * c.profile.pressure(r, a) * second.displacement(r, other); }, 0, a, jumps);
    const double two = piecewise([&](double r) { return r * second.pressure(r, other) * c.profile.displacement(r, a); },
                                 0, other, jumps);
    EXPECT_NEAR(one / two, 1, 1e-12) << c.name;
  });
}

TEST(AxisymmetricContact, ThreeWaysToTheSameContact) {
  for_each_profile([](const auto& c) {
    using Contact = AxisymmetricContact<std::decay_t<decltype(c.profile)>>;
    const auto by_radius = Contact::at_radius(c.profile, 0.9, 2e6);
    const auto by_force = Contact::under_force(c.profile, by_radius.force(), 2e6);
    const auto by_approach = Contact::at_approach(c.profile, by_radius.approach(), 2e6);
    for (const auto& contact : {by_force, by_approach}) {
      const double slack = 1 + 1e-15;
      EXPECT_NEAR(contact.radius(), by_radius.radius(), 8 * contact.radius_error() * slack) << c.name;
      EXPECT_NEAR(contact.force(), by_radius.force(), contact.force_error() + 8 * by_radius.force_error()) << c.name;
      EXPECT_NEAR(contact.approach(), by_radius.approach(), contact.approach_error() + 8 * by_radius.approach_error())
          << c.name;
      EXPECT_NEAR(contact.pressure(0.5), by_radius.pressure(0.5),
                  8 * contact.pressure_error(0.5) + by_radius.pressure_error(0.5))
          << c.name;
      EXPECT_NEAR(contact.gap(1.1), by_radius.gap(1.1), 8 * (contact.gap_error(1.1) + by_radius.gap_error(1.1)))
          << c.name;
      EXPECT_EQ(contact.stiffness(), 2 * 2e6 * contact.radius());
      EXPECT_NEAR(contact.mean_pressure() * std::numbers::pi * contact.radius() * contact.radius() / contact.force(), 1,
                  1e-15);
    }
  });
}

RC_GTEST_PROP(AxisymmetricContact, MoreForceMeansMoreOfEverything, ()) {
  const double force = *rc::gen::map(rc::gen::inRange(-60, 0), [](int i) { return std::pow(10, 0.1 * i); });
  for_each_profile([&](const auto& c) {
    if (!(1.1 * force < c.profile.force(std::min(2., c.profile.max_radius() * 0.999)))) return;
    using Contact = AxisymmetricContact<std::decay_t<decltype(c.profile)>>;
    const auto less = Contact::under_force(c.profile, force, 1);
    const auto more = Contact::under_force(c.profile, 1.1 * force, 1);
    RC_ASSERT(more.radius() >= less.radius());
    RC_ASSERT(more.approach() > less.approach());
    RC_ASSERT(more.stiffness() >= less.stiffness());
    const double r = 0.3 * less.radius();
    RC_ASSERT(more.pressure(r) > less.pressure(r));
    RC_ASSERT(more.displacement(3) > less.displacement(3));
  });
}

TEST(AxisymmetricContact, PressureVanishesOutsideAndGapInside) {
  for_each_profile([](const auto& c) {
    const auto contact = AxisymmetricContact<std::decay_t<decltype(c.profile)>>::at_radius(c.profile, 0.9, 2);
    EXPECT_EQ(contact.pressure(0.9), 0) << c.name;
    EXPECT_EQ(contact.pressure(1.1), 0) << c.name;
    EXPECT_EQ(contact.gap(0.5), 0) << c.name;
    EXPECT_EQ(contact.gap_error(0.5), 0) << c.name;
    EXPECT_EQ(contact.pressure_error(1.1), 0) << c.name;
  });
}

TEST(AxisymmetricContact, IsEvenInTheRadiusAndNanOfNan) {
  for_each_profile([](const auto& c) {
    const auto contact = AxisymmetricContact<std::decay_t<decltype(c.profile)>>::under_force(c.profile, 0.1, 2);
    const double nan = std::nan("");
    for (const double part : {0.2, 0.9, 1.1, 3.}) {
      const double r = part * contact.radius();
      EXPECT_EQ(contact.pressure(-r), contact.pressure(r)) << c.name;
      EXPECT_EQ(contact.displacement(-r), contact.displacement(r)) << c.name;
      EXPECT_EQ(contact.gap(-r), contact.gap(r)) << c.name;
      EXPECT_EQ(contact.pressure_error(-r), contact.pressure_error(r)) << c.name;
      EXPECT_EQ(contact.displacement_error(-r), contact.displacement_error(r)) << c.name;
      EXPECT_EQ(contact.gap_error(-r), contact.gap_error(r)) << c.name;
    }
    EXPECT_TRUE(std::isnan(contact.pressure(nan))) << c.name;
    EXPECT_TRUE(std::isnan(contact.displacement(nan))) << c.name;
    EXPECT_TRUE(std::isnan(contact.gap(nan))) << c.name;
  });
}

TEST(AxisymmetricContact, OutOfRangeParametersAreNamed) {
  using Contact = AxisymmetricContact<Paraboloid>;
  const auto profile = Paraboloid::of_radius(1);
  const std::string rule = " is not allowed: must be positive and finite";
  EXPECT_THAT([&] { Contact::at_radius(profile, 0, 1); }, refused("contact_radius = 0" + rule));
  EXPECT_THAT([&] { Contact::at_radius(profile, 1, -1); }, refused("contact_modulus = -1" + rule));
  EXPECT_THAT([&] { Contact::under_force(profile, std::nan(""), 1); }, refused("normal_force = nan" + rule));
  EXPECT_THAT([&] { Contact::under_force(profile, 1, 0); }, refused("contact_modulus = 0" + rule));
  EXPECT_THAT([&] { Contact::at_approach(profile, std::numeric_limits<double>::infinity(), 1); },
              refused("approach = inf" + rule));
}

TEST(AxisymmetricContact, ResultsBeyondTheRangeOfDoubleAreRefused) {
  using Contact = AxisymmetricContact<Paraboloid>;
  const auto profile = Paraboloid::of_radius(1);
  EXPECT_THROW(Contact::at_radius(profile, 1e200, 1), std::invalid_argument);
  EXPECT_THROW(Contact::at_radius(profile, 1e-200, 1), std::invalid_argument);
  EXPECT_THROW(Contact::under_force(profile, 1e-300, 1e300), std::invalid_argument);
  EXPECT_THROW(Contact::under_force(profile, 1e300, 1e-300), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
