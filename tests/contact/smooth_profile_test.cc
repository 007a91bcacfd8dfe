#include <patchgrip/contact/smooth_profile.h>

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
#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/power_profile.h>
#include <patchgrip/contact/sphere.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::contact {
namespace {

using Contact = AxisymmetricContact<SmoothProfile>;

static_assert(Profile<SmoothProfile>);

SmoothShape sphere() {
  return {[](double r) { return r * r / (1 + std::sqrt(1 - r * r)); },
          [](double r) { return r / std::sqrt(1 - r * r); }, [](double r) { return std::pow(1 - r * r, -1.5); }};
}

SmoothShape power(double m) {
  return {[m](double r) { return std::pow(r, m); }, [m](double r) { return m * std::pow(r, m - 1); },
          [m](double r) { return m * (m - 1) * std::pow(r, m - 2); }};
}

template <class P>
void expect_same(const SmoothProfile& smooth, const P& closed, double a) {
  const double bound = 1e-11;
  EXPECT_NEAR(smooth.approach(a) / closed.approach(a), 1, bound);
  EXPECT_NEAR(smooth.approach_slope(a) / closed.approach_slope(a), 1, bound);
  EXPECT_NEAR(smooth.force(a) / closed.force(a), 1, bound);
  for (const double rho : {0.01, 0.5, 0.999}) {
    EXPECT_NEAR(smooth.pressure(rho * a, a) / closed.pressure(rho * a, a), 1, bound);
  }
  for (const double rho : {1.0001, 1.4, 20.}) {
    EXPECT_NEAR(smooth.displacement(rho * a, a) / closed.displacement(rho * a, a), 1, bound);
  }
  const double force = closed.force(a);
  EXPECT_NEAR(smooth.radius_of_force(force) / a, 1, 2 * bound);
  EXPECT_NEAR(smooth.radius_of_approach(closed.approach(a)) / a, 1, 2 * bound);
}

TEST(SmoothProfile, AgreesWithTheClosedForms) {
  expect_same(SmoothProfile::of(sphere(), 0.99), Sphere::of_radius(1), 0.6);
  for (const double m : {0.7, 1., 1.5, 2., 6.}) {
    expect_same(SmoothProfile::of(power(m), 5), PowerProfile::of_coefficient(1, m), 1.3);
  }
}

// A shape without a closed form: the laws of axisymmetric.h instead.
TEST(SmoothProfile, StiffnessIsThatOfEveryProfile) {
  const SmoothProfile profile =
      SmoothProfile::of({[](double r) { return std::cosh(r) - 1; }, [](double r) { return std::sinh(r); },
                         [](double r) { return std::cosh(r); }},
                        3);
  const double a = 1.1;
  const double h = 1e-4;
  const double rise =
      (profile.force(a + h) - profile.force(a - h)) / (profile.approach(a + h) - profile.approach(a - h));
  EXPECT_NEAR(rise / (2 * a), 1, 1e-8);
  const auto contact = Contact::under_force(profile, 10, 2);
  EXPECT_NEAR(profile.force(contact.radius()) / 5, 1, 1e-10);
  EXPECT_LT(contact.approach_error() / contact.approach(), 1e-10);
}

// A kink is not smooth: no value rather than a wrong one.
TEST(SmoothProfile, KinkInsideIsRefused) {
  const SmoothProfile profile =
      SmoothProfile::of({[](double r) { return r < 0.37 ? 0 : r - 0.37; }, [](double r) { return r < 0.37 ? 0. : 1.; },
                         [](double) { return 0.; }},
                        3);
  EXPECT_THAT([&] { profile.force(1); }, ::testing::ThrowsMessage<std::runtime_error>(
                                             ::testing::HasSubstr("force not integrated: estimated error ")));
}

TEST(SmoothProfile, OutOfRangeParametersAreNamed) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  EXPECT_THAT([] { SmoothProfile::of(sphere(), 0); },
              refused("max_radius = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { SmoothProfile::of(sphere(), 1, 1e-14); },
              refused("tolerance = 1e-14 is not allowed: must lie in [1e-11, 0.001]"));
  EXPECT_THAT([] { Contact::at_radius(SmoothProfile::of(sphere(), 0.9), 0.95, 1); },
              refused("contact_radius = 0.95 is not allowed: must lie in [0, 0.9]"));
}

}  // namespace
}  // namespace patchgrip::contact
