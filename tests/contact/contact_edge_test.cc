#include <patchgrip/contact/half_space/contact_edge.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/contact/half_space_shapes.h>

namespace patchgrip::contact {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<ZoneArea> areas(const Grid& grid, Surface surface, const GapFunction& pressure) {
  const auto field = sample(grid, pressure);
  Workers workers(2);
  return zone_areas(grid, surface, field, map_zones(grid, surface, field, {workers}), {workers});
}

GapFunction hertz(double x0, double y0, double a = 1, double b = 1) {
  return [=](double x, double y) {
    return std::sqrt(std::max(0., 1 - std::pow((x - x0) / a, 2) - std::pow((y - y0) / b, 2)));
  };
}

// p^2 of an exact Hertz pressure is a quadratic: the fit is exact, the piecewise linear edge is in the mean over its
// cells, and the offset of the solver's pressure is taken off in vain.
TEST(ContactEdge, ExactHertzPressure) {
  for (const int cells : {32, 64, 128, 256}) {
    const Grid grid = Grid::square(cells, 2.5);
    for (const double shift : {0., 0.3}) {
      const auto zones = areas(grid, Surface::free, hertz(shift * grid.dx, -0.7 * shift * grid.dx));
      ASSERT_EQ(zones.size(), 1U);
      EXPECT_TRUE(zones[0].resolved);
      const double offset = 2 * edge_offset * grid.dx + 2 * edge_curvature_offset * grid.dx * grid.dx;
      EXPECT_NEAR(zones[0].area / pi, 1 - offset, 0.05 * std::pow(grid.dx, 2)) << cells;
    }
  }
}

TEST(ContactEdge, EllipseAcrossTheSidesOfAPeriodicSurface) {
  const Grid grid = Grid::square(128, 2.5);
  const auto inside = areas(grid, Surface::periodic, hertz(0, 0, 1, 0.4));
  const auto wrapped = areas(grid, Surface::periodic, [&](double x, double y) {
    const auto pressure = hertz(0, 0, 1, 0.4);
    return pressure(x + (x < 0 ? 1.25 : -1.25), y + (y < 0 ? 1.25 : -1.25));
  });
  ASSERT_EQ(wrapped.size(), 1U);
  EXPECT_NEAR(wrapped[0].area, inside[0].area, 1e-12);
  const double perimeter = 4.6026;
  const double offset = edge_offset * grid.dx * perimeter + 2 * pi * edge_curvature_offset * grid.dx * grid.dx;
  EXPECT_NEAR(inside[0].area, 0.4 * pi - offset, 5e-5);
}

TEST(ContactEdge, RingHasTwoEdges) {
  const Grid grid = Grid::square(128, 2.5);
  const auto zones = areas(grid, Surface::free, [](double x, double y) {
    const double r = std::hypot(x, y);
    return std::sqrt(std::max(0., (1 - r) * (r - 0.4)));
  });
  ASSERT_EQ(zones.size(), 1U);
  EXPECT_NEAR(zones[0].area / (pi * (1 - 0.16)), 1, 1e-3);
}

TEST(ContactEdge, EachZoneHasItsOwn) {
  const Grid grid = Grid::square(256, 2.5);
  const auto zones = areas(grid, Surface::free, [](double x, double y) {
    return std::max(hertz(-0.5, 0, 0.4, 0.4)(x, y), 0.01 * hertz(0.5, 0, 0.3, 0.5)(x, y));
  });
  ASSERT_EQ(zones.size(), 2U);
  const auto [small, large] = std::minmax(zones[0].area, zones[1].area);
  EXPECT_NEAR(small / (pi * 0.15), 1, 1e-3);
  EXPECT_NEAR(large / (pi * 0.16), 1, 1e-3);
}

TEST(ContactEdge, PunchIsCounted) {
  const Grid grid = Grid::square(64, 2.5);
  const auto zones = areas(grid, Surface::free, [](double x, double y) {
    return x * x + y * y < 1 ? 1 / std::sqrt(1.001 - x * x - y * y) : 0;
  });
  EXPECT_FALSE(zones[0].resolved);
  EXPECT_LE(std::abs(zones[0].area - pi), 3 * zones[0].error);
}

TEST(ContactEdge, SmallZonesAreCounted) {
  const Grid grid = Grid::square(32, 32);
  const auto zones = areas(grid, Surface::free,
                           [](double x, double y) { return std::abs(x - 0.5) + std::abs(y - 0.5) < 1.5 ? 1. : 0.; });
  ASSERT_EQ(zones.size(), 1U);
  EXPECT_FALSE(zones[0].resolved);
  EXPECT_EQ(zones[0].area, 5);
  EXPECT_GT(zones[0].error, 0);
}

TEST(ContactEdge, FullContactIsAll) {
  const Grid grid = Grid::of_cells(32, 24, 0.1, 0.2);
  const auto zones = areas(grid, Surface::periodic, [](double, double) { return 2.; });
  EXPECT_DOUBLE_EQ(zones[0].area, 32 * 24 * 0.02);
  EXPECT_EQ(zones[0].error, 0);
}

TEST(ContactEdge, NoContactIsNoZone) {
  EXPECT_TRUE(areas(Grid::square(16, 1), Surface::free, [](double, double) { return 0.; }).empty());
}

}  // namespace
}  // namespace patchgrip::contact
