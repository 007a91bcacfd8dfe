// The pole of a puck that comes to rest, against closed forms and the table.
#include <patchgrip/dynamics/coast_down.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/uniform_disc.h>

namespace patchgrip::dynamics {
namespace {

TEST(CoastDown, AgreesWithTheTable) {
  EXPECT_NEAR(coast_down_pole(friction::UniformDisc::of_radius(3), 2), 0.65300178920559763899, 1e-15);
  EXPECT_NEAR(coast_down_pole(friction::HertzDisc::of_radius(0.1), 3), 0.7233024093136838630929, 1e-15);
  EXPECT_NEAR(coast_down_pole(friction::UniformDisc::of_radius(1), 3.5), 1.338502130243691749268, 2e-15);
}

// Of a flat punch inside, pi x / 4 = q x (pi / 4 - pi x^2 / 8).
TEST(CoastDown, AgreesWithTheClosedFormOfAFlatPunch) {
  for (const double q : {1.2, 1.5, 2.})
    EXPECT_NEAR(coast_down_pole(friction::FlatPunchDisc::of_radius(1), q), std::sqrt(2 - 2 / q), 1e-15);
}

// n + 1 < q < 2 n + 3
template <class P>
void expect_domain(const P& disc, double n) {
  EXPECT_EQ(coast_down_pole(disc, (n + 1) * (1 - 1e-9)), 0);
  EXPECT_LT(coast_down_pole(disc, (n + 1) * (1 + 1e-9)), 1e-3);
  EXPECT_GT(coast_down_pole(disc, (n + 1) * (1 + 1e-9)), 0);
  EXPECT_GT(coast_down_pole(disc, (2 * n + 3) * (1 - 1e-9)), 1e3);
  EXPECT_EQ(coast_down_pole(disc, (2 * n + 3) * (1 + 1e-9)), std::numeric_limits<double>::infinity());
}

TEST(CoastDown, HasAPoleWhereItIsKnownTo) {
  expect_domain(friction::HertzDisc::of_radius(1), 1);
  expect_domain(friction::UniformDisc::of_radius(1), 0.5);
  expect_domain(friction::Ring::of_radius(1), -0.5);
  expect_domain(friction::PowerDisc::of_radius(1, 2.5), 2.5);
}

TEST(CoastDown, BadInputIsRefused) {
  for (const double q : {0., -1., std::nan("")})
    EXPECT_THROW(coast_down_pole(friction::HertzDisc::of_radius(1), q), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::dynamics
