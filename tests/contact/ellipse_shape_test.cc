#include <patchgrip/contact/ellipse_shape.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::contact_rows;
using patchgrip::testing::Exact;
using patchgrip::testing::log_uniform;
using patchgrip::testing::units_of_rounding;

using Shape = EllipseShape<long double>;

double units(long double value, const Exact& exact) {
  return static_cast<double>(abs((Exact(value) - exact) / exact) * 0x1p53);
}

TEST(EllipseShape, AgreesWithTheTable) {
  const auto rows = contact_rows("hertz_ellipse");
  ASSERT_EQ(rows.size(), 5U);
  for (const auto& row : rows) {
    const auto shape = Shape::of_ratio(row.input("ratio"));
    const auto agrees = [&](long double value, const char* name) {
      const Exact exact = row.output(name);
      if (exact == 0) {
        EXPECT_EQ(value, 0) << name;
      } else {
        EXPECT_LE(units_of_rounding(static_cast<double>(value), exact), 2) << name;
      }
    };
    agrees(shape.eccentricity, "e");
    agrees(shape.k, "b_over_a");
    agrees(shape.seed_F1(), "F1");
    agrees(shape.seed_F2(), "F2");
    const auto small = shape.against_small_radius();
    agrees(small.pressure, "f_p_ref_Rsmall");
    agrees(small.force, "f_FN_ref_Rsmall");
    agrees(small.a, "f_a_ref_Rsmall");
    agrees(small.b, "f_b_ref_Rsmall");
    const auto large = shape.against_large_radius();
    agrees(large.pressure, "f_p_ref_Rlarge");
    agrees(large.force, "f_FN_ref_Rlarge");
    agrees(large.a, "f_a_ref_Rlarge");
    agrees(large.b, "f_b_ref_Rlarge");
  }
}

TEST(EllipseShape, HoldsItsBoundFromTheCircleToTheLine) {
  std::mt19937_64 engine(20060110);
  double worst = 0;
  for (int i = 0; i < cases(500); ++i) {
    const double small = log_uniform(engine, i % 4 == 0 ? 1e-30 : 1e-8, 1);
    const bool near_circle = i % 2 == 1;
    const auto shape = near_circle ? Shape::of_one_minus_ratio(small / 2) : Shape::of_ratio(small);
    const auto exact = near_circle ? EllipseShape<Exact>::of_one_minus_ratio(Exact(small) / 2)
                                   : EllipseShape<Exact>::of_ratio(Exact(small));
    worst = std::max({worst, units(shape.k, exact.k), units(shape.one_minus_k, exact.one_minus_k),
                      units(shape.eccentricity, exact.eccentricity), units(shape.integrals.K, exact.integrals.K),
                      units(shape.integrals.B, exact.integrals.B), units(shape.integrals.D, exact.integrals.D)});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 0x1p-3);
}

// The loop of means against Carlson's own forms, which share nothing with it, in fifty digits.
TEST(EllipseShape, SolvesCarlsonsForm) {
  std::mt19937_64 engine(20060111);
  for (int i = 0; i < cases(500); ++i) {
    const Exact ratio = log_uniform(engine, 1e-12, 1);
    const auto shape = EllipseShape<Exact>::of_ratio(ratio);
    const Exact k2 = shape.k * shape.k;
    const Exact along = boost::math::ellint_rd(Exact(0), k2, Exact(1));
    const Exact across = boost::math::ellint_rd(Exact(0), Exact(1), k2);
    EXPECT_LE(abs(along / (across * ratio) - 1), 1e-46);
    EXPECT_LE(abs(boost::math::ellint_rf(Exact(0), k2, Exact(1)) / shape.integrals.K - 1), 1e-46);
    EXPECT_LE(abs(along / (3 * shape.integrals.D) - 1), 1e-46);
    EXPECT_LE(abs(k2 * across / (3 * shape.integrals.B) - 1), 1e-46);
  }
}

TEST(EllipseShape, IsACircleAtRatioOne) {
  const auto shape = Shape::of_ratio(1);
  EXPECT_EQ(shape.k, 1);
  EXPECT_EQ(shape.eccentricity, 0);
  EXPECT_NEAR(static_cast<double>(shape.seed_F1()), 1, 1e-18);
  EXPECT_NEAR(static_cast<double>(shape.seed_F2()), 1, 1e-18);
}

TEST(EllipseShape, DepartsFromTheCircleByTwoThirdsOfTheRatio) {
  for (const double part : {1e-300, 1e-30, 1e-16, 1e-8}) {
    const auto shape = Shape::of_one_minus_ratio(part);
    EXPECT_NEAR(static_cast<double>(shape.one_minus_k / part), 2. / 3, part + 1e-15);
    EXPECT_NEAR(static_cast<double>(shape.eccentricity * shape.eccentricity / part), 4. / 3, 2 * part + 1e-15);
  }
}

// Line contact: ratio -> k^2 (ln(4/k) - 1).
TEST(EllipseShape, TendsToTheLine) {
  for (const double ratio : {1e-6, 1e-10, 1e-30}) {
    const double k = static_cast<double>(Shape::of_ratio(ratio).k);
    EXPECT_NEAR(k * k * (std::log(4 / k) - 1) / ratio, 1, 10 * k * k * std::log(1 / k));
  }
}

RC_GTEST_PROP(EllipseShape, GetsRounderWithTheRatio, ()) {
  const double ratio = std::pow(10, -1e-3 * *rc::gen::inRange(1, 29999));
  RC_ASSERT(Shape::of_ratio(ratio).k < Shape::of_ratio(ratio * (1 + 1e-12)).k);
}

// The seed's statement below figure 4.11, put right: with R_e both change little while the ratio is near 1.
TEST(EllipseShape, SeedsFactorsStayNearOneForNearlyRoundZones) {
  const auto shape = Shape::of_ratio(0.5L);
  const double F1 = static_cast<double>(shape.seed_F1()), F2 = static_cast<double>(shape.seed_F2());
  EXPECT_NEAR(1 / (F1 * F1 * std::sqrt(F2)), 1.017, 5e-4);
  EXPECT_NEAR(std::pow(F2, -1.5), 1.010, 5e-4);
}

TEST(EllipseShape, RatiosOutsideTheDomainAreNamed) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  EXPECT_THAT([] { Shape::of_ratio(0); }, refused("radius_ratio = 0 is not allowed: must lie in [1e-30, 1]"));
  EXPECT_THAT([] { Shape::of_ratio(1.5L); }, refused("radius_ratio = 1.5 is not allowed: must lie in [1e-30, 1]"));
  EXPECT_THAT([] { Shape::of_ratio(std::nan("")); },
              refused("radius_ratio = nan is not allowed: must lie in [1e-30, 1]"));
  EXPECT_THAT([] { Shape::of(0.5L, -1e-3L); },
              refused("one_minus_radius_ratio = -0.001 is not allowed: must lie in [0, 1]"));
}

}  // namespace
}  // namespace patchgrip::contact
