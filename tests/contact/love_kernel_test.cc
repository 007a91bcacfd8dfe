#include <patchgrip/contact/half_space/love_kernel.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/math/constants/constants.hpp>

#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::contact_rows;
using patchgrip::testing::Exact;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;
using patchgrip::testing::units_of_rounding;

// A hundred digits: the four corners cancel as the square of the distance.
using Corners = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

Exact exact(double pressure, double modulus, double a, double b, double x, double y) {
  const Corners integral = love_integral<Corners>(a, b, x, y);
  return Exact(integral) * pressure / (boost::math::constants::pi<Exact>() * modulus);
}

TEST(LoveKernel, AgreesWithTheTable) {
  const auto rows = contact_rows("love_rectangle");
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    const double u = love_displacement(row.input("p"), row.input("E_star"), row.input("hx"), row.input("hy"),
                                       row.input("x"), row.input("y"));
    EXPECT_LE(units_of_rounding(u, row.output("u_z_at_xy")), love_error_units + 2);  // the inputs are decimal
  }
}

// Every aspect ratio; inside, on the sides and their continuations, in the corners, near and far.
TEST(LoveKernel, ErrorIsBoundedEverywhere) {
  std::mt19937_64 engine(20061201);
  double worst = 0;
  for (int k = 0; k < cases(1500); ++k) {
    const double a = log_uniform(engine, 1e-9, 1e3);
    const double b = a * log_uniform(engine, 1e-8, 1e8);
    const auto place = [&](double half) {
      switch (k % 5) {
        case 0:
          return uniform(engine, -1, 1) * half;
        case 1:
          return std::floor(uniform(engine, -1, 2)) * half;
        case 2:
          return uniform(engine, -1, 1) * log_uniform(engine, 1e-3, 1e3) * std::max(a, b);
        case 3:
          return half * (1 + uniform(engine, -1, 1) * log_uniform(engine, 1e-12, 1));
        default:
          return uniform(engine, -1, 1) * log_uniform(engine, 1e-9, 1e12) * half;
      }
    };
    const double x = place(a), y = place(b);
    const double pressure = log_uniform(engine, 1e-3, 1e9), modulus = log_uniform(engine, 1e3, 1e12);
    const double units =
        units_of_rounding(love_displacement(pressure, modulus, a, b, x, y), exact(pressure, modulus, a, b, x, y));
    worst = std::max(worst, units);
    ASSERT_LE(units, love_error_units) << "a = " << a << " b = " << b << " x = " << x << " y = " << y;
  }
  RecordProperty("worst_units", std::to_string(worst));
}

TEST(LoveKernel, TableOfAGridAgreesWithFiftyDigits) {
  for (const double aspect : {1., 0.3, 8.}) {
    const Grid grid = Grid::of_cells(512, 512, 0.01, 0.01 / aspect);
    std::vector<double> table(513 * 513);
    Workers workers(2);
    fill_love_table(grid, 513, 513, table.data(), workers);
    std::mt19937_64 engine(20061202);
    double worst = 0;
    for (int k = 0; k < cases(1200); ++k) {
      const int reach = k % 3 == 0 ? 512 : 40;
      const int i = k < 25 ? k % 5 : static_cast<int>(uniform(engine, 0, reach + 1));
      const int j = k < 25 ? k / 5 : static_cast<int>(uniform(engine, 0, reach + 1));
      const Exact reference = exact(1, 1, grid.dx / 2, grid.dy / 2, i * grid.dx, j * grid.dy);
      const double error =
          std::abs(static_cast<double>(Exact(table[static_cast<std::size_t>(j * 513 + i)]) / reference - 1));
      worst = std::max(worst, error);
    }
    RecordProperty("worst_error", std::to_string(worst));
    EXPECT_LE(worst, love_table_error);
  }
}

TEST(LoveKernel, SelfTermOfASquareIsTheHandbooks) {
  const double u = love_displacement(1, 1, 0.5, 0.5, 0, 0);
  EXPECT_LE(units_of_rounding(u, 4 * asinh(Exact(1)) / boost::math::constants::pi<Exact>()), 1);
}

RC_GTEST_PROP(LoveKernel, IsEvenAndKnowsNoAxis, ()) {
  const double x = 1e-3 * *rc::gen::inRange(-5000, 5000), y = 1e-3 * *rc::gen::inRange(-5000, 5000);
  const double b = 1e-3 * *rc::gen::inRange(1, 5000);
  const double u = love_displacement(1, 1, 1, b, x, y);
  RC_ASSERT(love_displacement(1, 1, 1, b, -x, y) == u);
  RC_ASSERT(love_displacement(1, 1, 1, b, x, -y) == u);
  RC_ASSERT(std::abs(love_displacement(1, 1, b, 1, y, x) / u - 1) < 1e-15);
}

RC_GTEST_PROP(LoveKernel, HalvesAddUp, ()) {
  const double x = 1e-3 * *rc::gen::inRange(-3000, 3000), y = 1e-3 * *rc::gen::inRange(-3000, 3000);
  const double left = love_displacement(1, 1, 0.5, 1, x + 0.5, y), right = love_displacement(1, 1, 0.5, 1, x - 0.5, y);
  RC_ASSERT(std::abs((left + right) / love_displacement(1, 1, 1, 1, x, y) - 1) < 1e-15);
}

TEST(LoveKernel, FarAwayIsAPointLoad) {
  for (const double r : {1e3, 1e6, 1e12}) {
    const double point = 4 / (boost::math::constants::pi<double>() * r);
    EXPECT_NEAR(love_displacement(1, 1, 1, 1, 0.6 * r, 0.8 * r) / point, 1, 1 / (r * r) + 1e-15);
  }
}

TEST(LoveKernel, OutOfRangeParametersAreNamed) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  const std::string rule = " is not allowed: must be positive and finite";
  EXPECT_THAT([] { love_displacement(0, 1, 1, 1, 0, 0); }, refused("pressure = 0" + rule));
  EXPECT_THAT([] { love_displacement(1, -1, 1, 1, 0, 0); }, refused("contact_modulus = -1" + rule));
  EXPECT_THAT([] { love_displacement(1, 1, 0, 1, 0, 0); }, refused("half_x = 0" + rule));
  EXPECT_THAT([] { love_displacement(1, 1, 1, INFINITY, 0, 0); }, refused("half_y = inf" + rule));
  EXPECT_THAT([] { love_displacement(1, 1, 1, 1, std::nan(""), 0); },
              refused("x = nan is not allowed: must be finite"));
  EXPECT_THROW(love_displacement(1e-300, 1e300, 1, 1, 0, 0), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
