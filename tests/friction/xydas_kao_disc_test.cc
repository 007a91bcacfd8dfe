#include <patchgrip/friction/xydas_kao_disc.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/round_reference.h>
#include <patchgrip/tests/friction/stack_reference.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::friction {
namespace {

using patchgrip::testing::units_of_rounding;
using ::testing::ThrowsMessage;
using Real30 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<30>, boost::multiprecision::et_off>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

auto refused(const std::string& message) { return ThrowsMessage<std::invalid_argument>(message); }
auto of(double radius, double alpha) {
  return [=] { XydasKaoDisc::of_radius(radius, alpha); };
}

double relative(const Real50& value, const Real50& exact) { return static_cast<double>(abs(value / exact - 1)); }

// The mean over rings of r p(r) with p as printed in (4.68), unnormalised: what a stack of discs can't share an error
// with.
class FromThePressure {
 public:
  explicit FromThePressure(long double alpha)
      : alpha_(alpha), ring_(-0.5L), load_(mean([](long double) { return 1.0L; }, 1)) {}

  long double force(long double x) const {
    return mean(
               [&](long double r) {
                 return x <= r ? ring_.inside((r - x) / r).force * x / r : ring_.outside((x - r) / x).force;
               },
               x) /
           load_;
  }
  long double moment(long double x) const {
    return mean(
               [&](long double r) {
                 return x <= r ? ring_.inside((r - x) / r).moment * r : ring_.outside((x - r) / x).moment * r * r / x;
               },
               x) /
           load_;
  }
  long double polar() const {
    return mean([](long double r) { return r * r; }, 1) / load_;
  }

 private:
  // Split where the pole is; towards the rim in terms of 1 - r.
  template <class Function>
  long double mean(const Function& function, long double split) const {
    const long double middle = split < 1 ? split : 0.5L;
    const auto weighted = [&](long double r, long double gap) {
      return r * std::pow(-std::expm1(alpha_ * std::log1p(-gap)), 1 / alpha_) * function(r);
    };
    boost::math::quadrature::tanh_sinh<long double> quadrature;
    return quadrature.integrate([&](long double r) { return weighted(r, 1 - r); }, 0.0L, middle) +
           quadrature.integrate([&](long double gap) { return weighted(1 - gap, gap); }, 0.0L, 1 - middle);
  }

  long double alpha_;
  kernels::PowerFamily<long double> ring_;
  long double load_;
};

class OfAlpha : public ::testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(XydasKaoDisc, OfAlpha, ::testing::Values(0.5, 0.7, 1, 1.3, 1.8, 5, 50),
                         [](const auto& instance) { return "Number" + std::to_string(instance.index); });

TEST_P(OfAlpha, ForceAndMomentAreGoodToEightUnits) {
  const double alpha = GetParam();
  const double radius = 0.0037;
  const XydasKaoDisc disc = XydasKaoDisc::of_radius(radius, alpha);
  const StackReference<Real30> reference(alpha);
  double worst = 0;
  for (const double x : {0.0, 1e-6, 0.3, 0.5, 0.95, 1.0, 1 - 1e-12, 1 + 1e-6, 1.4, 1e8}) {
    const Twist v = twist_about({radius * x * 0.28, radius * x * 0.96}, 1);
    const Wrench g = disc.gradient(v);
    const Wrench50 exact = round_wrench(reference, radius, v);
    if (x > 0) worst = std::max({worst, units_of_rounding(g.fx, exact.fx), units_of_rounding(g.fy, exact.fy)});
    worst = std::max(worst, units_of_rounding(g.m, exact.m));
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 8);
}

TEST_P(OfAlpha, ReferenceIsTheMeanOverThePrintedPressure) {
  const double alpha = GetParam();
  const StackReference<Real30> reference(alpha);
  const FromThePressure printed(alpha);
  EXPECT_LT(relative(Real50(reference.polar()), printed.polar()), 1e-15);
  for (const double x : {0.3, 0.8}) {
    const auto g = reference.inside(1 - Real30(x));
    EXPECT_LT(relative(Real50(g.force) * x, printed.force(x)), 1e-14) << x;
    EXPECT_LT(relative(Real50(g.moment), printed.moment(x)), 1e-14) << x;
  }
  for (const double x : {1.25, 4.0}) {
    const auto g = reference.outside(1 - 1 / Real30(x));
    EXPECT_LT(relative(Real50(g.force), printed.force(x)), 1e-14) << x;
    EXPECT_LT(relative(Real50(g.moment) / x, printed.moment(x)), 1e-14) << x;
  }
}

TEST_P(OfAlpha, PolarMomentIsThatOfThePressure) {
  const double alpha = GetParam();
  const PressureMoments s = XydasKaoDisc::of_radius(2, alpha).moments();
  EXPECT_EQ(s.x, 0);
  EXPECT_EQ(s.y, 0);
  EXPECT_LT(relative(s.polar / 4, FromThePressure(alpha).polar()), 1e-14);
  // Far away the moment is half the polar moment over the distance.
  EXPECT_NEAR(XydasKaoDisc::of_radius(2, alpha).gradient(twist_about({0, 1e9}, 1)).m * 1e9, s.polar / 2,
              1e-14 * s.polar);
}

TEST(XydasKaoDisc, HessianEqualsDifferencesOfTheExactGradient) {
  for (const double alpha : {0.5, 1.3, 50.0}) {
    const XydasKaoDisc disc = XydasKaoDisc::of_radius(1, alpha);
    const StackReference<Real30> reference(alpha);
    const auto gradient = [&](const Real50& vx, const Real50& vy, const Real50& w) {
      return round_wrench(reference, 1, vx, vy, w);
    };
    for (const double x : {0.4, 2.5}) {
      const Twist v = twist_about({0, x}, 1);
      // 30 digits in the gradient leave 1e-24 / step.
      const Hessian exact = hessian_by_differences(gradient, v, 1, 1e-5);
      EXPECT_LE(scaled_difference(disc.hessian(v), exact, v, 1), 1e-13 * scaled_size(exact, v, 1)) << alpha << ' ' << x;
    }
  }
}

TEST(XydasKaoDisc, OfAlphaTwoIsHertz) {
  const XydasKaoDisc disc = XydasKaoDisc::of_radius(0.3, 2);
  const HertzDisc hertz = HertzDisc::of_radius(0.3);
  EXPECT_NEAR(disc.moments().polar, hertz.moments().polar, 1e-15);
  for (const double x : {0.0, 1e-9, 0.3, 0.5, 0.99, 1.0, 1 + 1e-12, 1.7, 1e6}) {
    const Twist v = twist_about({0, 0.3 * x}, 1);
    const Wrench a = disc.gradient(v);
    const Wrench b = hertz.gradient(v);
    EXPECT_NEAR(a.fx, b.fx, 16 * 0x1p-53 * b.fx) << x;  // 8 units each
    EXPECT_NEAR(a.m, b.m, 16 * 0x1p-53 * b.m) << x;
    EXPECT_NEAR(disc.hessian(v).ww, hertz.hessian(v).ww, 1e-13 * hertz.hessian(v).ww) << x;
  }
}

// The pressure is flat but for a strip of width 1/alpha where it misses a share of order 1/alpha: 1/alpha^2 in all.
TEST(XydasKaoDisc, TendsToTheUniformDiscLikeTheInverseSquareOfAlpha) {
  const UniformDisc uniform = UniformDisc::of_radius(1);
  const XydasKaoDisc at_25 = XydasKaoDisc::of_radius(1, 25);
  const XydasKaoDisc at_50 = XydasKaoDisc::of_radius(1, 50);
  for (const double x : {0.0, 0.4, 1.6}) {
    const Twist v = twist_about({0, x}, 1);
    const double ratio = (at_25.gradient(v).m - uniform.gradient(v).m) / (at_50.gradient(v).m - uniform.gradient(v).m);
    EXPECT_NEAR(ratio, 4, 0.4) << x;
  }
  EXPECT_NEAR((at_25.moments().polar - 0.5) / (at_50.moments().polar - 0.5), 4, 0.4);
}

TEST(XydasKaoDisc, TellsItsRadiusAndAlpha) {
  const XydasKaoDisc disc = XydasKaoDisc::of_radius(0.7, 1.8);
  EXPECT_EQ(disc.radius(), 0.7);
  EXPECT_EQ(disc.area_radius(), 0.7);
  EXPECT_EQ(disc.alpha(), 1.8);
}

TEST(XydasKaoDisc, AlphaOutsideItsDomainIsRefused) {
  EXPECT_THAT(of(1, 0.4), refused("alpha = 0.4 is not allowed: must lie in [0.5, 50]"));
  EXPECT_THAT(of(1, 50.5), refused("alpha = 50.5 is not allowed: must lie in [0.5, 50]"));
  EXPECT_THAT(of(1, -2), refused("alpha = -2 is not allowed: must lie in [0.5, 50]"));
  EXPECT_THAT(of(1, nan), refused("alpha = nan is not allowed: must lie in [0.5, 50]"));
  EXPECT_THROW(of(1, infinity)(), std::invalid_argument);
}

TEST(XydasKaoDisc, RadiiThatAreNotPositiveAndFiniteAreRefused) {
  EXPECT_THAT(of(-0.1, 2), refused("radius = -0.1 is not allowed: must be positive and finite"));
  EXPECT_THROW(of(nan, 2)(), std::invalid_argument);
  EXPECT_THROW(of(infinity, 2)(), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
