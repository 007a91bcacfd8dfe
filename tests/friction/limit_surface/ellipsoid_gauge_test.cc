// Ellipsoids for the limit surface: proven sides, shapes, and the laws of a convex body.
#include <patchgrip/friction/limit_surface/ellipsoid_gauge.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/friction/limit_surface/cheap_gauges.h>

namespace patchgrip::friction {
namespace {

struct NamedGauge {
  std::string name;
  EllipsoidGauge gauge;
};

template <class P>
std::vector<NamedGauge> every_ellipsoid(const P& patch) {
  return {{"axis", EllipsoidGauge::axis(patch)},
          {"least_squares", EllipsoidGauge::least_squares(patch)},
          {"even", EllipsoidGauge::even(patch)},
          {"inner", EllipsoidGauge::inner(patch)},
          {"enclosing", EllipsoidGauge::enclosing(patch)}};
}

TEST(EllipsoidGauge, ErrsByNoMoreThanItSaysAndByAsMuchSafeNeverBelowOuterNeverAbove) {
  for_every_kind([](const std::string& kind, const auto& patch) {
    for (const auto& [name, gauge] : every_ellipsoid(patch)) {
      SCOPED_TRACE(kind + ' ' + name);
      const GaugeSides seen = judge(gauge, patch, testing::cases(400));
      if (testing::all_cases()) {
        EXPECT_GE(seen.largest_excess, 0.8 * gauge.largest_excess() - 1e-3);
        EXPECT_GE(seen.largest_deficit, 0.8 * gauge.largest_deficit() - 1e-3);
      }
      const double both = (1 + gauge.largest_excess()) / (1 - gauge.largest_deficit());
      EXPECT_NEAR(1 + gauge.safe().largest_excess(), both, 1e-14);
      EXPECT_LE(gauge.safe().largest_deficit(), 1e-15);
      EXPECT_LE(gauge.outer().largest_excess(), 1e-15);
      EXPECT_LE(gauge.slack(), 1.3e-5);
      judge(gauge.safe(), patch, testing::cases(40));
      judge(gauge.outer(), patch, testing::cases(40));
    }
  });
}

TEST(EllipsoidGauge, OfTheAxesTouchesDiscsFromOutside) {
  const auto expect_outer = [](const auto& disc, double deficit) {
    const auto gauge = EllipsoidGauge::axis(disc);
    EXPECT_LE(gauge.largest_excess(), 1e-5);  // what the proof leaves open
    EXPECT_NEAR(gauge.largest_deficit(), deficit, 1.5e-5);
  };
  expect_outer(HertzDisc::of_radius(1), 0.06000);
  expect_outer(UniformDisc::of_radius(1), 0.06580);
  expect_outer(FlatPunchDisc::of_radius(1), 0.07632);
  expect_outer(Ring::of_radius(1), 0.09968);
}

// Attained by loads, not by bounds: the side that a slender patch or a heavy centre errs on is the other one too.
TEST(EllipsoidGauge, OfTheAxesErrsOnEitherSideOfSlenderPatches) {
  const Rectangle slender = Rectangle::of_sides(10, 1);
  const GaugeSides seen = judge(EllipsoidGauge::axis(slender), slender, 4000);
  EXPECT_NEAR(seen.largest_excess, 0.0409, 2e-4);
  EXPECT_NEAR(seen.largest_deficit, 0.1310, 2e-4);
}

// A cylinder's edge: the force and the moment that the patch holds alone it nearly holds together.
TEST(EllipsoidGauge, OfTheAxesAsksTooMuchUnderAHeavyCentre) {
  const auto patch = target(0.999, 1e-6);
  const auto gauge = EllipsoidGauge::axis(patch);
  const Wrench load{1, 0, CentredFrame::of(patch).length};
  EXPECT_NEAR(gauge.value(load), std::sqrt(2), 1e-12);
  EXPECT_LE(LimitSurface(patch).gauge(load).upper, 1.01);
  EXPECT_GE(gauge.largest_excess(), 0.39);
  EXPECT_LE(gauge.largest_excess(), std::sqrt(2) - 1);
}

TEST(EllipsoidGauge, OfTheAxesIsExactForForcesThroughTheCentreAndForMoments) {
  const auto expect_exact = [](const auto& patch) {
    const auto gauge = EllipsoidGauge::axis(patch);
    const PressureMoments s = patch.moments();
    EXPECT_NEAR(gauge.value({3, -4, s.x * -4 - s.y * 3}), 5, 1e-13);
    const double M0 = patch.dissipation(twist_about({s.x, s.y}, 1));
    EXPECT_NEAR(gauge.value({0, 0, 2 * M0}), 2, 1e-13);
    EXPECT_NEAR(LimitSurface(patch).gauge({0, 0, 2 * M0}).value, 2, 1e-12);
  };
  expect_exact(HertzDisc::of_radius(0.01));
  expect_exact(Rectangle::of_sides(0.3, 0.05));
  expect_exact(Placed(Ring::of_radius(0.5), 2, -7));
}

// sqrt(det A) is inverse to the volume.
double volume(const EllipsoidGauge& gauge, const CentredFrame& axes) {
  const auto along = [&](const Wrench& t) { return gauge.value(axes.global(t)); };
  const auto dot = [&](const Wrench& s, const Wrench& t) {
    const double both = along(sum(s, t)), other = along(sum(s, scaled(-1, t)));
    return (both * both - other * other) / 4;
  };
  const Wrench x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const double xx = dot(x, x), xy = dot(x, y), xz = dot(x, z), yy = dot(y, y), yz = dot(y, z), zz = dot(z, z);
  return 1 / std::sqrt(xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz));
}

TEST(EllipsoidGauge, InnerIsTheLargestWithinEnclosingTheSmallestAboutAndEvenTheLeastWrong) {
  for_every_kind([](const std::string& kind, const auto& patch) {
    SCOPED_TRACE(kind);
    const auto axes = CentredFrame::of(patch);
    const auto even = EllipsoidGauge::even(patch), inner = EllipsoidGauge::inner(patch);
    const auto enclosing = EllipsoidGauge::enclosing(patch);
    const auto of_D_squared = [](double ratio) { return std::fabs(1 / (ratio * ratio) - 1); };
    EXPECT_NEAR(of_D_squared(1 - even.largest_deficit()), of_D_squared(1 + even.largest_excess()), 5e-3);
    EXPECT_LE(inner.largest_deficit(), 1e-15);
    EXPECT_LE(enclosing.largest_excess(), 1e-15);
    for (const auto& other : {EllipsoidGauge::axis(patch), EllipsoidGauge::least_squares(patch), even}) {
      EXPECT_GE(volume(inner, axes), 0.98 * volume(other.safe(), axes));
      EXPECT_LE(volume(enclosing, axes), 1.02 * volume(other.outer(), axes));
      EXPECT_LE(even.safe().largest_excess(), other.safe().largest_excess() + 1e-3);
    }
    EXPECT_LE(even.safe().largest_excess(), inner.largest_excess() + 1e-3);
  });
}

TEST(EllipsoidGauge, IsAConvexBodyWithItsDissipation) {
  for_every_kind([](const std::string& kind, const auto& patch) {
    SCOPED_TRACE(kind);
    const auto axes = CentredFrame::of(patch);
    expect_convex_body(EllipsoidGauge::axis(patch), axes, testing::cases(300));
    expect_convex_body(EllipsoidGauge::least_squares(patch), axes, testing::cases(300));
  });
}

TEST(EllipsoidGauge, SizeAndPlaceOfThePatchMoveTheMomentAlone) {
  const auto unit = EllipsoidGauge::least_squares(l_shape.patch());
  const auto twice = EllipsoidGauge::least_squares(Polygon::uniform(scaled(l_ring, 2)));
  const auto away = EllipsoidGauge::least_squares(Placed(l_shape.patch(), 5, -7));
  EXPECT_NEAR(unit.largest_excess(), twice.largest_excess(), 1e-9);
  EXPECT_NEAR(unit.largest_deficit(), away.largest_deficit(), 1e-9);
  std::mt19937_64 engine(3);
  const auto axes = CentredFrame::of(l_shape.patch());
  for (int i = 0; i < 1000; ++i) {
    const Wrench t = random_load(engine, axes);
    const double g = unit.value(t);
    EXPECT_NEAR(twice.value({t.fx, t.fy, 2 * t.m}), g, 1e-10 * g);
    EXPECT_NEAR(away.value({t.fx, t.fy, t.m + 5 * t.fy + 7 * t.fx}), g, 1e-10 * g);
  }
}

TEST(EllipsoidGauge, HoldsOverTheWholeRangeOfDoubles) {
  for_every_kind([](const std::string& kind, const auto& patch) {
    SCOPED_TRACE(kind);
    expect_every_size(EllipsoidGauge::axis(patch), CentredFrame::of(patch));
  });
}

TEST(EllipsoidGauge, HasPartsThatArePointLoads) {
  const auto gauge = EllipsoidGauge::even(disc_and_point());
  judge(gauge, disc_and_point(), testing::cases(400));
  EXPECT_LE(gauge.slack(), 1.3e-5);
  judge(EllipsoidGauge::least_squares(disc_and_point()), disc_and_point(), testing::cases(400));
}

// All pressure in one point, to rounding or as far as its distance lets one see.
template <class P>
void expect_refused(const P& patch) {
  for (auto* make : {EllipsoidGauge::axis<P>, EllipsoidGauge::least_squares<P>, EllipsoidGauge::even<P>,
                     EllipsoidGauge::inner<P>, EllipsoidGauge::enclosing<P>}) {
    try {
      make(patch);
      ADD_FAILURE() << "accepted";
    } catch (const std::invalid_argument& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("moment about the centre of pressure = "), std::string::npos);
    }
  }
}

TEST(EllipsoidGauge, APointIsRefused) {
  expect_refused(PointLoad{});
  expect_refused(Placed(PointLoad{}, 0.3, 0.1));
  expect_refused(Placed(HertzDisc::of_radius(1e-3), 1.5e12, 0));
  expect_refused(Several::of_parts({{Placed(PointLoad{}, 0.1, 0.3), 1}, {Placed(PointLoad{}, 0.1, 0.3), 2}}));
}

TEST(EllipsoidGauge, NoLoadAsksForNothingAndLoadsThatAreNotFiniteForNoNumber) {
  const auto gauge = EllipsoidGauge::axis(HertzDisc::of_radius(1));
  EXPECT_EQ(gauge.value({}), 0);
  EXPECT_EQ(gauge.gauge({}).upper, 0);
  EXPECT_EQ(gauge.twist({}).w, 0);
  EXPECT_EQ(gauge.dissipation({}), 0);
  const Gauge bad = gauge.gauge({0, std::numeric_limits<double>::quiet_NaN(), 0});
  EXPECT_TRUE(std::isnan(bad.value) && std::isnan(bad.lower) && std::isnan(bad.upper) && std::isnan(bad.twist.w));
  EXPECT_EQ(bad.status, GaugeStatus::not_finite);
}

}  // namespace
}  // namespace patchgrip::friction
