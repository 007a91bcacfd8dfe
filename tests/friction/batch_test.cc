#include <patchgrip/friction/batch.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/tests/friction/round_reference.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::friction {
namespace {

using patchgrip::testing::units_of_rounding;
using ::testing::ThrowsMessage;

struct Batch {
  explicit Batch(std::vector<double> x_, std::vector<double> y_)
      : x(std::move(x_)), y(std::move(y_)), fx(x.size(), -7), fy(x.size(), -7), m(x.size(), -7) {}

  PoleBatch view() { return {x, y, fx, fy, m}; }

  std::vector<double> x, y, fx, fy, m;
};

// Centre, rim and its neighbours, everything between 1e-12 and 1e12 radii.
Batch poles(std::size_t n, double radius) {
  std::mt19937_64 engine(20060103);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> x, y;
  for (std::size_t i = 0; i < n; ++i) {
    double r = radius * std::pow(10, 24 * unit(engine) - 12);
    if (i % 3 == 0) r = radius * (1 + std::pow(10, -17 * unit(engine)));
    if (i % 3 == 1) r = radius * (1 - std::pow(10, -17 * unit(engine)));
    if (i % 50 == 7) r = 0;
    const double angle = 7 * unit(engine);
    x.push_back(r * std::cos(angle));
    y.push_back(i % 10 == 3 ? 0 : r * std::sin(angle));
  }
  return Batch(x, y);
}

// Force and moment relative to their sizes, in units of 2^-53; the scalar and each vector build are good to 8.
template <class P>
void expect_as_scalar(const P& patch, Batch& batch, double spin) {
  gradient(patch, spin, batch.view());
  for (std::size_t i = 0; i < batch.x.size(); ++i) {
    const Wrench g = patch.gradient(twist_about({batch.x[i], batch.y[i]}, std::copysign(1.0, spin)));
    const double force = std::hypot(g.fx, g.fy);
    EXPECT_LE(std::hypot(batch.fx[i] - g.fx, batch.fy[i] - g.fy), 12 * 0x1p-53 * force)
        << i << ": " << batch.x[i] << ' ' << batch.y[i];
    EXPECT_LE(std::fabs(batch.m[i] - g.m), 12 * 0x1p-53 * std::fabs(g.m))
        << i << ": " << batch.x[i] << ' ' << batch.y[i];
  }
}

TEST(Batch, OfAnySizeIsTheScalarAtEveryPole) {
  for (const std::size_t n : {0U, 1U, 7U, 1023U, 1024U, 1025U, 5000U}) {
    for (const double radius : {1.0, 0.0037}) {
      Batch batch = poles(n, radius);
      expect_as_scalar(HertzDisc::of_radius(radius), batch, 2.5);
      expect_as_scalar(FlatPunchDisc::of_radius(radius), batch, -1e-9);
    }
  }
}

template <class P>
void expect_eight_units(double n) {
  const double radius = 0.3;
  const kernels::PowerFamily<Real50> exact(n);
  Batch batch = poles(1500, radius);
  gradient(P::of_radius(radius), 1, batch.view());
  double worst = 0;
  for (std::size_t i = 0; i < batch.x.size(); ++i) {
    const Wrench50 e = round_wrench(exact, radius, twist_about({batch.x[i], batch.y[i]}, 1));
    const Real50 force = hypot(e.fx, e.fy);
    if (force > 0)
      worst = std::max(worst, static_cast<double>(hypot(batch.fx[i] - e.fx, batch.fy[i] - e.fy) / force) * 0x1p53);
    worst = std::max(worst, units_of_rounding(batch.m[i], e.m));
  }
  ::testing::Test::RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 8);
}

TEST(Batch, OfAHertzDiscIsGoodToEightUnits) { expect_eight_units<HertzDisc>(1); }
TEST(Batch, OfAFlatPunchDiscIsGoodToEightUnits) { expect_eight_units<FlatPunchDisc>(0); }

TEST(Batch, TakesAnyOtherPatchPoleByPole) {
  Batch batch = poles(100, 1);
  const Ring ring = Ring::of_radius(1);
  const Rectangle rectangle = Rectangle::of_sides(2, 1);
  gradient(ring, -3, batch.view());
  for (std::size_t i = 0; i < batch.x.size(); ++i) {
    const Wrench g = ring.gradient(twist_about({batch.x[i], batch.y[i]}, -1));
    EXPECT_TRUE(batch.fx[i] == g.fx && batch.fy[i] == g.fy && batch.m[i] == g.m);
  }
  gradient(rectangle, 1, batch.view());
  for (std::size_t i = 0; i < batch.x.size(); ++i) {
    const Wrench g = rectangle.gradient(twist_about({batch.x[i], batch.y[i]}, 1));
    EXPECT_TRUE(batch.fx[i] == g.fx && batch.fy[i] == g.fy && batch.m[i] == g.m);
  }
}

TEST(Batch, HoldsForPolesWhoseSquaresOverflowOrUnderflow) {
  for (const double radius : {1.0, 1e-160, 1e160, 1e-300}) {
    Batch batch({1e300, -1e200, 1e160, 3e-200, 1e-310, 0, 0, radius}, {1e299, 0, 1e160, 4e-200, 0, 1e-200, 0, 0});
    expect_as_scalar(HertzDisc::of_radius(radius), batch, 1);
    expect_as_scalar(FlatPunchDisc::of_radius(radius), batch, -1);
  }
}

// One chunk may hold what the next may not.
TEST(Batch, AHugePoleDoesNotSpoilItsNeighbours) {
  Batch batch = poles(4096, 1);
  batch.x[1500] = 1e200;
  batch.y[4095] = -1e250;
  expect_as_scalar(HertzDisc::of_radius(1), batch, 1);
}

TEST(Batch, NotANumberStaysInItsPlace) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Batch batch({0.5, nan, 2, 0.1}, {0, 1, nan, 0.2});
  gradient(HertzDisc::of_radius(1), 1, batch.view());
  for (const std::size_t i : {1U, 2U})
    EXPECT_TRUE(std::isnan(batch.fx[i]) && std::isnan(batch.fy[i]) && std::isnan(batch.m[i]));
  for (const std::size_t i : {0U, 3U})
    EXPECT_TRUE(std::isfinite(batch.fx[i]) && std::isfinite(batch.fy[i]) && std::isfinite(batch.m[i]));
}

TEST(Batch, WritesNothingBeyondItsSpans) {
  Batch batch = poles(16, 1);
  PoleBatch part = batch.view();
  part = {part.pole_x.first(9), part.pole_y.first(9), part.force_x.first(9), part.force_y.first(9),
          part.moment.first(9)};
  gradient(HertzDisc::of_radius(1), 1, part);
  for (std::size_t i = 9; i < 16; ++i) EXPECT_TRUE(batch.fx[i] == -7 && batch.fy[i] == -7 && batch.m[i] == -7);
}

TEST(Batch, SpansOfDifferentLengthAreRefused) {
  const HertzDisc disc = HertzDisc::of_radius(1);
  Batch batch = poles(8, 1);
  for (int wrong = 0; wrong < 4; ++wrong) {
    PoleBatch view = batch.view();
    if (wrong == 0) view.pole_y = view.pole_y.first(7);
    if (wrong == 1) view.force_x = view.force_x.first(7);
    if (wrong == 2) view.force_y = view.force_y.first(0);
    if (wrong == 3) view.moment = view.moment.last(7);
    EXPECT_THAT(
        [&] { gradient(disc, 1, view); },
        ThrowsMessage<std::invalid_argument>("length of pole_x = 8 is not allowed: must be that of the other spans"));
    EXPECT_THROW(gradient(Ring::of_radius(1), 1, view), std::invalid_argument);
  }
}

TEST(Batch, WithoutSpinIsRefused) {
  Batch batch = poles(2, 1);
  const char* message = "spin = 0 is not allowed: must not be zero: a translation has no pole in the plane";
  EXPECT_THAT([&] { gradient(HertzDisc::of_radius(1), 0, batch.view()); },
              ThrowsMessage<std::invalid_argument>(message));
  EXPECT_THAT([&] { gradient(Ring::of_radius(1), 0, batch.view()); }, ThrowsMessage<std::invalid_argument>(message));
}

TEST(Batch, SpinThatIsNotANumberIsRefused) {
  Batch batch = poles(2, 1);
  EXPECT_THROW(gradient(HertzDisc::of_radius(1), std::nan(""), batch.view()), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
