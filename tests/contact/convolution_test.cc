#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/love_kernel.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/tests/contact/half_space_shapes.h>

namespace patchgrip::contact {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<double> random_field(const Grid& grid, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::vector<double> field(grid.size());
  for (double& value : field) value = patchgrip::testing::uniform(engine, -1, 2);
  return field;
}

double largest(const std::vector<double>& field) {
  double most = 0;
  for (const double value : field) most = std::max(most, std::abs(value));
  return most;
}

double largest_difference(const std::vector<double>& one, const std::vector<double>& other) {
  double most = 0;
  for (std::size_t k = 0; k < one.size(); ++k) most = std::max(most, std::abs(one[k] - other[k]));
  return most;
}

// Sizes with and without factors of two, oblong cells.
TEST(Convolution, AgreesWithTheDirectSum) {
  for (const Grid& grid : {Grid::square(16, 1), Grid::of_cells(8, 31, 0.1, 0.2), Grid::of_cells(37, 12, 0.3, 0.04)}) {
    const auto pressure = random_field(grid, 1);
    std::vector<double> direct(grid.size());
    for (int j = 0; j < grid.ny; ++j) {
      for (int i = 0; i < grid.nx; ++i) {
        for (int l = 0; l < grid.ny; ++l) {
          for (int k = 0; k < grid.nx; ++k) {
            direct[grid.index(i, j)] +=
                pressure[grid.index(k, l)] *
                love_displacement(1, 7, grid.dx / 2, grid.dy / 2, (i - k) * grid.dx, (j - l) * grid.dy);
          }
        }
      }
    }
    const auto u = half_space_displacement(grid, Surface::free, pressure, 7);
    EXPECT_LE(largest_difference(u, direct), convolution_error * largest(direct));
  }
}

TEST(Convolution, PeriodicWaveIsScaledByItsLength) {
  const Grid grid = Grid::of_cells(48, 30, 0.1, 0.15);
  for (const auto& [m, n] : {std::pair{1, 0}, {0, 4}, {3, 2}, {24, 15}}) {
    const double qx = 2 * pi * m / (48 * 0.1), qy = 2 * pi * n / (30 * 0.15);
    const auto pressure =
        sample(grid, [&](double x, double y) { return 5 + 3 * std::cos(qx * (x - 0.05) + qy * (y - 0.075)); });
    const auto u = half_space_displacement(grid, Surface::periodic, pressure, 2);
    const auto exact = sample(grid, [&](double x, double y) {
      return 3 * std::cos(qx * (x - 0.05) + qy * (y - 0.075)) / std::hypot(qx, qy);
    });
    EXPECT_LE(largest_difference(u, exact), 4 * convolution_error * largest(exact)) << m << ' ' << n;
  }
}

TEST(Convolution, ThreadsDoNotChangeTheResult) {
  const Grid grid = Grid::of_cells(90, 70, 0.1, 0.1);
  const auto pressure = random_field(grid, 2);
  for (const Surface surface : {Surface::free, Surface::periodic}) {
    const auto alone = half_space_displacement(grid, surface, pressure, 1, 1);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(half_space_displacement(grid, surface, pressure, 1, threads), alone);
  }
}

RC_GTEST_PROP(Convolution, IsReciprocal, ()) {
  const Grid grid = Grid::of_cells(*rc::gen::inRange(8, 24), *rc::gen::inRange(8, 24), 0.1, 0.15);
  for (const Surface surface : {Surface::free, Surface::periodic}) {
    const auto p = random_field(grid, *rc::gen::arbitrary<unsigned>()),
               q = random_field(grid, *rc::gen::arbitrary<unsigned>());
    const auto up = half_space_displacement(grid, surface, p, 1), uq = half_space_displacement(grid, surface, q, 1);
    double one = 0, other = 0, scale = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
      one += up[k] * q[k];
      other += uq[k] * p[k];
      scale += std::abs(up[k] * q[k]);
    }
    RC_ASSERT(std::abs(one - other) <= 1e-13 * scale);
  }
}

RC_GTEST_PROP(Convolution, IsPositiveDefinite, ()) {
  const Grid grid = Grid::of_cells(*rc::gen::inRange(8, 24), *rc::gen::inRange(8, 24), 0.1, 0.1);
  const auto p = random_field(grid, *rc::gen::arbitrary<unsigned>());
  const auto u = half_space_displacement(grid, Surface::free, p, 1);
  double energy = 0;
  for (std::size_t k = 0; k < p.size(); ++k) energy += u[k] * p[k];
  RC_ASSERT(energy > 0);
}

RC_GTEST_PROP(Convolution, ScalesWithLengthAndModulus, ()) {
  const int power = *rc::gen::inRange(-30, 30);
  const double factor = std::ldexp(1, power);
  const auto p = random_field(Grid::square(12, 1), *rc::gen::arbitrary<unsigned>());
  const auto u = half_space_displacement(Grid::square(12, 1), Surface::free, p, 1);
  const auto longer = half_space_displacement(Grid::square(12, factor), Surface::free, p, 1);
  const auto stiffer = half_space_displacement(Grid::square(12, 1), Surface::free, p, factor);
  for (std::size_t k = 0; k < u.size(); ++k) {
    RC_ASSERT(longer[k] == factor * u[k]);
    RC_ASSERT(stiffer[k] == u[k] / factor);
  }
}

// The inverse problem: Hertz' pressure bulges the surface into the paraboloid, a = R = E* = 1.
TEST(HalfSpaceDisplacement, UnderHertzPressureIsTheParaboloid) {
  struct Row {
    int cells;
    double error;
  };
  for (const auto& [cells, bound] : {Row{64, 3.5e-4}, {128, 6e-5}, {256, 2e-5}}) {
    const Grid grid = Grid::square(cells, 2.5);
    const auto p = sample(grid, [](double x, double y) { return 2 / pi * std::sqrt(std::max(0., 1 - x * x - y * y)); });
    const auto u = half_space_displacement(grid, Surface::free, p, 1);
    const auto exact = sample(grid, [](double x, double y) {
      const double r = std::hypot(x, y);
      return r <= 1 ? 1 - r * r / 2 : ((2 - r * r) * std::asin(1 / r) + std::sqrt(r * r - 1)) / pi;
    });
    double squares = 0;
    for (std::size_t k = 0; k < u.size(); ++k) squares += std::pow(u[k] - exact[k], 2);
    EXPECT_LE(std::sqrt(squares / static_cast<double>(u.size())), bound) << cells;
  }
}

TEST(HalfSpaceDisplacement, OutOfRangeParametersAreNamed) {
  const Grid grid = Grid::square(8, 1);
  std::vector<double> p(64, 1.);
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  EXPECT_THAT([&] { half_space_displacement(grid, Surface::free, p, 0); },
              refused("contact_modulus = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([&] { half_space_displacement(grid, Surface::free, p, 1, 0); },
              refused("threads = 0 is not allowed: must lie in [1, 64]"));
  p[5] = NAN;
  EXPECT_THAT([&] { half_space_displacement(grid, Surface::free, p, 1); },
              refused("pressure = nan is not allowed: must be finite"));
  p.pop_back();
  EXPECT_THAT([&] { half_space_displacement(grid, Surface::free, p, 1); },
              refused("pressure.size() = 63 is not allowed: must be nx ny of the grid"));
}

}  // namespace
}  // namespace patchgrip::contact
