#include <patchgrip/friction/kernels/round_table.h>

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/kernels/power_table.h>
#include <patchgrip/tests/friction/round_reference.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::friction::kernels {
namespace {

using patchgrip::testing::units_of_rounding;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Both sides of every border of the rows from 1 down to 2^-61, and points between.
std::vector<double> keys() {
  std::vector<double> d{1};
  for (int octave = 1; octave <= 61; ++octave) {
    for (const double quarter : {1.0, 1.25, 1.5, 1.75}) {
      const double border = std::ldexp(quarter, -octave);
      if (octave > 12 && quarter != 1) continue;  // one row is as good as another there
      d.insert(d.end(), {border, std::nextafter(border, 0), 1.1 * border});
    }
  }
  return d;
}

class TableOfExponent : public ::testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(RoundTable, TableOfExponent, ::testing::Values(-0.5, -0.3, 0.25, 0.5, 3.2, 20),
                         [](const auto& instance) { return "Number" + std::to_string(instance.index); });

TEST_P(TableOfExponent, IsGoodToFiveUnitsAcrossAllItsRows) {
  const double n = GetParam();
  const PowerFamily<Real50> exact(n);
  const auto table = power_table(n);
  double worst = 0, worst_slope = 0;
  const auto compare = [&](const Pair& computed, double slope, const RoundValues<Real50>& g) {
    worst = std::max({worst, units_of_rounding(computed[0], g.force), units_of_rounding(computed[1], g.moment)});
    worst_slope = std::max(worst_slope, units_of_rounding(slope, g.slope));
  };
  for (const double d : keys()) {
    compare(table->gradient(false, d, 1 - d), table->slope(false, d, 1 - d), exact.outside(d));
    // Inside, d is the small one near the rim and x near the centre: here x = d.
    if (d > 0.5) continue;
    compare(table->gradient(true, d, 1 - d), table->slope(true, d, 1 - d), exact.inside(d));
    compare(table->gradient(true, 1 - d, d), table->slope(true, 1 - d, d), exact.inside(1 - Real50(d)));
  }
  RecordProperty("worst_units", std::to_string(worst));
  RecordProperty("worst_units_of_slope", std::to_string(worst_slope));
  EXPECT_LE(worst, 5);
  EXPECT_LE(worst_slope, 8);
}

TEST(RoundTable, HasItsLastRowsAtTheRimAtTheCentreAndAtInfinity) {
  const auto table = power_table(1);
  const PowerFamily<Real50> exact(1);
  EXPECT_LE(units_of_rounding(table->gradient(true, 0, 1)[0], exact.inside(0).force), 3);
  EXPECT_LE(units_of_rounding(table->gradient(false, 0, 1)[1], exact.outside(0).moment), 3);
  EXPECT_LE(units_of_rounding(table->gradient(true, 1, 0)[0], exact.inside(1).force), 3);
  EXPECT_LE(units_of_rounding(table->gradient(true, 1, 1e-300)[1], exact.inside(1).moment), 3);
  EXPECT_LE(units_of_rounding(table->gradient(false, 1, 0)[1], exact.outside(1).moment), 3);
}

TEST(RoundTable, OfARingHasAnInfiniteSlopeAtTheRimAlone) {
  const auto ring = power_table(-0.5);
  EXPECT_EQ(ring->slope(true, 0, 1), infinity);
  EXPECT_EQ(ring->slope(false, 0, 1), infinity);
  EXPECT_TRUE(std::isfinite(ring->slope(true, 1e-300, 1)));
  EXPECT_TRUE(std::isfinite(power_table(-0.4)->slope(true, 0, 1)));
}

TEST(RimLevels, GrowWithTheSingularityOfThePressure) {
  EXPECT_EQ(rim_levels(-1), 62);    // a ring: the slope is a logarithm
  EXPECT_EQ(rim_levels(-0.5), 62);  // clamped: 48 / 0.5 rows would be below the rounding of d
  EXPECT_EQ(rim_levels(0), 48);     // uniform
  EXPECT_EQ(rim_levels(0.5), 32);   // Hertz
  EXPECT_EQ(rim_levels(100), 2);
}

TEST(Select, IsTheConditionalOperator) {
  EXPECT_EQ(select(true, 1.5, -2), 1.5);
  EXPECT_EQ(select(false, 1.5, -2), -2);
  EXPECT_TRUE(std::isnan(select(true, std::nan(""), 1)));
  EXPECT_EQ(select(false, std::nan(""), infinity), infinity);
}

// What a table is made from may be anything with inside(), outside() and rim_slope().
struct Polynomial {
  RoundValues<long double> inside(long double d) const { return {1 + d, d * d, 3}; }
  RoundValues<long double> outside(long double d) const { return {2 - d, 1 + d * d * d, d}; }
  long double rim_slope() const { return 0; }
};

TEST(RoundTable, ReproducesPolynomialsToRounding) {
  const auto table = RoundTable::build<long double>(Polynomial{}, {8, 4});
  for (const double d : {0.0, 1e-5, 0.003, 0.1, 0.3, 0.49}) {
    const double row = std::max(d, 0x1p-8);  // the last row covers all that is nearer to the rim
    EXPECT_NEAR(table.gradient(true, d, 1 - d)[0], 1 + d, 0x1p-52);
    EXPECT_NEAR(table.gradient(true, d, 1 - d)[1], d * d, 0x1p-52 * row * row);
    EXPECT_NEAR(table.gradient(false, d, 1 - d)[0], 2 - d, 0x1p-52);
    EXPECT_NEAR(table.slope(false, d, 1 - d), d, 0x1p-52 * row);
  }
}

}  // namespace
}  // namespace patchgrip::friction::kernels
