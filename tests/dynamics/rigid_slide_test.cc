// Pucks come to rest at the times and places that are known, and about the poles that coasting down tends to.
#include <patchgrip/dynamics/rigid_slide.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/uniform_disc.h>

namespace patchgrip::dynamics {
namespace {

using friction::Law;

PlanarState moving(double vx, double vy, double w) {
  PlanarState s;
  s.twist = {vx, vy, w};
  return s;
}

// R = 0.05 m, 1 kg, J = m R^2 / 2, mu = 0.5, g = 9.81 m/s^2.
template <class P>
void expect_stop(const P& disc, double time, double distance, double turn) {
  const RigidSlide slide(disc, 1, 0.00125, Law::coulomb(0.5), 9.81);
  const Slide s = slide(moving(1, 0, 20), Vector3::Zero(), {.tolerance = 1e-13});
  EXPECT_TRUE(s.stopped);
  EXPECT_NEAR(s.time, time, 1e-13);
  EXPECT_NEAR(s.state.place[0], distance, 1e-13);
  EXPECT_NEAR(s.state.place[2], turn, 2e-11);
  EXPECT_LE(s.time_error, 1e-10);
  const Slide rough = slide(moving(1, 0, 20), Vector3::Zero(), {.tolerance = 1e-8});
  EXPECT_LE(std::fabs(rough.time - time), rough.time_error);
  EXPECT_LE(std::fabs(rough.state.place[0] - distance), rough.place_error[0]);
}

TEST(RigidSlide, APuckComesToRestWhereItIsKnownTo) {
  expect_stop(friction::UniformDisc::of_radius(0.05), .27325143366306, .12994846567449, 2.95243022942);
  expect_stop(friction::HertzDisc::of_radius(0.05), .28808448600715, .12928855096844, 3.27323081330);
}

// tau = mu g t / (a omega_0) at the stop, x0 = v0 / (a omega_0), q = m a^2 / J (reference table).
TEST(RigidSlide, ScaledStopTimes) {
  const auto tau = [](const auto& disc, double q, double x0) {
    return RigidSlide(disc, 1, 1 / q, Law::coulomb(1), 1)(moving(x0, 0, 1), Vector3::Zero(), {.tolerance = 1e-13}).time;
  };
  EXPECT_NEAR(tau(friction::HertzDisc::of_radius(1), 2.5, 2), 2.203889813833, 2e-12);
  EXPECT_NEAR(tau(friction::UniformDisc::of_radius(1), 2, 0.1), 0.7607786802246, 2e-12);
}

// x = v / (a |w|) tends to the root of f(x) = q x m(x).
TEST(RigidSlide, ThePoleOfTheStopIsThatOfCoastingDown) {
  const auto limit = [](const auto& disc, double q, double x0) {
    const Slide s = RigidSlide(disc, 1, 1 / q, Law::coulomb(1), 1)(moving(x0, 0, 1));
    return std::hypot(s.last_direction[0], s.last_direction[1]) / std::fabs(s.last_direction[2]);
  };
  for (const double x0 : {0.3, 3.}) {
    EXPECT_NEAR(limit(friction::UniformDisc::of_radius(1), 2, x0), 0.65300178920559763899, 1e-8);
    EXPECT_NEAR(limit(friction::HertzDisc::of_radius(1), 3, x0), 0.7233024093136838630929, 1e-8);
    EXPECT_NEAR(limit(friction::FlatPunchDisc::of_radius(1), 2, x0), 1, 1e-8);
  }
}

TEST(RigidSlide, PureMotionsStopAsCoulombSays) {
  const auto disc = friction::HertzDisc::of_radius(0.1);
  const RigidSlide slide(disc, 2, 0.01, Law::coulomb(0.3), 20);
  const Slide s = slide(moving(3, 4, 0));
  EXPECT_NEAR(s.time, 5 * 2 / 6., 1e-11);
  EXPECT_NEAR(s.state.place[0], 3. / 5 * 25 / 6, 1e-10);
  EXPECT_NEAR(s.state.place[2], 0, 1e-15);
  const Slide spin = slide(moving(0, 0, -7));
  EXPECT_NEAR(spin.time, 7 * 0.01 / (6 * 3 * std::numbers::pi / 16 * 0.1), 1e-11);
}

// A patch that turns with its body: from two sides the same, turned.
TEST(RigidSlide, DoesNotDependOnTheAxesOfSpace) {
  const RigidSlide slide(friction::Rectangle::of_sides(0.1, 0.03), 1, 0.001, Law::coulomb(0.4), 10);
  const Slide a = slide(moving(0.5, 0, 8));
  PlanarState from = moving(0, 0.5, 8);
  from.place[2] = std::numbers::pi / 2;
  const Slide b = slide(from);
  EXPECT_NEAR(a.time, b.time, 1e-10);
  EXPECT_NEAR(a.state.place[0], b.state.place[1], 1e-10);
  EXPECT_NEAR(a.state.place[1], -b.state.place[0], 1e-10);
}

TEST(RigidSlide, StribeckStopsSooner) {
  const auto disc = friction::HertzDisc::of_radius(0.1);
  const Slide coulomb = RigidSlide(disc, 1, 0.01, Law::coulomb(0.3), 10)(moving(1, 0, 5));
  const Slide stribeck = RigidSlide(disc, 1, 0.01, Law::stribeck(0.6, 0.3, 0.1), 10)(moving(1, 0, 5));
  EXPECT_TRUE(stribeck.stopped);
  EXPECT_LT(stribeck.time, coulomb.time);
}

TEST(RigidSlide, ALoadThatFrictionCannotStopGoesOn) {
  const RigidSlide slide(friction::HertzDisc::of_radius(0.1), 1, 0.01, Law::coulomb(0.3), 10);
  const Slide s = slide(moving(0.1, 0, 0), {4, 0, 0}, {.longest = 2});
  EXPECT_FALSE(s.stopped);
  EXPECT_GE(s.time, 2);
  EXPECT_NEAR(s.state.twist[0], 0.1 + s.time, 1e-8);
}

TEST(RigidSlide, BadInputIsRefused) {
  const auto disc = friction::HertzDisc::of_radius(0.1);
  EXPECT_THROW(RigidSlide(disc, 0, 1, Law::coulomb(0.3), 10), std::invalid_argument);
  EXPECT_THROW(RigidSlide(disc, 1, -1, Law::coulomb(0.3), 10), std::invalid_argument);
  EXPECT_THROW(RigidSlide(disc, 1, 1, Law::coulomb(0.3), -10), std::invalid_argument);
  const RigidSlide slide(disc, 1, 1, Law::coulomb(0.3), 10);
  EXPECT_THROW(slide(moving(0, 0, 0)), std::invalid_argument);
  EXPECT_THROW(slide(moving(1, 0, std::nan(""))), std::invalid_argument);
  EXPECT_THROW(slide(moving(1, 0, 0), Vector3::Zero(), {.tolerance = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::dynamics
