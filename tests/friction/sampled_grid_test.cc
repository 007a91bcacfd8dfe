#include <patchgrip/friction/sampled/pressure_grid.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <patchgrip/friction/patch.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/sampled_cases.h>
#include <patchgrip/tests/friction/sampled_reference.h>

namespace patchgrip::friction {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

static_assert(Patch<PressureGrid>);

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Dyadic, so that corners and centres are exact.
PressureCells uneven_cells() { return {4, 3, 0.25, 0.125, -0.5, 0.25, {0, 1, 2, 1, 1, 4, 5, 2, 2, 0, 5, 0}}; }

PressureCells dome(std::size_t n) {
  const double h = 2 / static_cast<double>(n);
  return sampled_cells(n, n, h, h, -1, -1, [](double x, double y) { return std::max(0.0, 1 - x * x - y * y); });
}

PressureCells rough(std::size_t n, std::mt19937_64& engine) {
  return sampled_cells(n, n + 2, 0.001, 0.0013, 0.02, -0.01,
                       [&](double, double) { return engine() % 4 == 0 ? 0 : uniform(engine, 0, 1); });
}

TEST(SampledGrid, AgreesWithTheTable) {
  std::ifstream file(PATCHGRIP_DATA_DIR "/reference/friction.json");
  const auto table = nlohmann::json::parse(file);
  int rows = 0;
  for (const auto& entry : table["wrench_integrals"]) {
    const auto& contact = entry["contact"];
    if (contact["type"] != "grid_cells") continue;
    const auto number = [](const nlohmann::json& text) { return std::stod(text.get<std::string>()); };
    PressureCells cells{
        0, 0, number(contact["hx_m"]), number(contact["hy_m"]), number(contact["x0_m"]), number(contact["y0_m"]), {}};
    for (const auto& row : contact["cell_pressure"]) {
      cells.nx = row.size();
      ++cells.ny;
      for (const auto& p : row) cells.pressures.push_back(p);
    }
    const PressureGrid patch = PressureGrid::exact(cells);
    const double a = number(entry["a_K_m"]);
    EXPECT_NEAR(patch.area_radius(), a, 1e-15 * a);
    for (const auto& row : entry["rows"]) {
      const Twist v = twist_about({number(row["xi_M"]), number(row["eta_M"])}, 1);
      const Wrench g = patch.gradient(v);
      EXPECT_NEAR(g.fx, number(row["I1"]), 1e-14);
      EXPECT_NEAR(g.fy, number(row["I2"]), 1e-14);
      EXPECT_NEAR(g.m, a * number(row["I3"]), 1e-14 * a);
      EXPECT_NEAR(patch.dissipation(v), number(row["S_m"]), 1e-14 * number(row["S_m"]));
      ++rows;
    }
  }
  EXPECT_GE(rows, 6);
}

TEST(SampledGrid, OneCellIsARectangle) {
  const PressureGrid cell = PressureGrid::exact({1, 1, 0.5, 0.125, -0.25, -0.0625, {7}});
  const Rectangle rectangle = Rectangle::of_sides(0.5, 0.125);
  EXPECT_NEAR(cell.area_radius(), rectangle.area_radius(), 1e-16);
  EXPECT_NEAR(cell.moments().polar, rectangle.moments().polar, 1e-17);
  std::mt19937_64 engine(1);
  for (int i = 0; i < testing::cases(500); ++i) {
    const Twist v = random_motion(rectangle, engine);
    const BoundedWrench g = cell.bounded_gradient(v), h = rectangle.bounded_gradient(v);
    EXPECT_LE(std::hypot(g.value.fx - h.value.fx, g.value.fy - h.value.fy), g.force_error + h.force_error);
    EXPECT_LE(std::fabs(g.value.m - h.value.m), g.moment_error + h.moment_error);
    EXPECT_LE(scaled_difference(cell.hessian(v), rectangle.hessian(v), v, 0.2), 1e-13);
  }
}

TEST(SampledGrid, NeitherEmptyMarginsNorSplitCellsMatter) {
  const PressureGrid patch = PressureGrid::exact(uneven_cells());
  PressureCells wide{8, 6, 0.25, 0.125, -1, 0, std::vector<double>(48)};
  PressureCells split{8, 6, 0.125, 0.0625, -0.5, 0.25, {}};
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 4; ++i) wide.pressures[(j + 2) * 8 + i + 2] = uneven_cells().pressures[j * 4 + i];
  }
  for (std::size_t j = 0; j < 6; ++j) {
    for (std::size_t i = 0; i < 8; ++i) split.pressures.push_back(uneven_cells().pressures[j / 2 * 4 + i / 2]);
  }
  std::mt19937_64 engine(2);
  for (const PressureGrid& other : {PressureGrid::exact(wide), PressureGrid::exact(split)}) {
    EXPECT_EQ(other.moments().x, patch.moments().x);
    EXPECT_EQ(other.area_radius(), patch.area_radius());
    for (int i = 0; i < 300; ++i) {
      const Twist v = random_motion(patch, engine);
      const BoundedWrench g = patch.bounded_gradient(v), h = other.bounded_gradient(v);
      EXPECT_LE(std::hypot(g.value.fx - h.value.fx, g.value.fy - h.value.fy), g.force_error + h.force_error);
      EXPECT_LE(std::fabs(g.value.m - h.value.m), g.moment_error + h.moment_error);
    }
  }
}

// Corners, middles of sides, centres, and a hair's breadth beside them.
TEST(SampledGrid, PolesOnCornersSidesAndCentresAreLikeAnyOther) {
  const PressureCells cells = uneven_cells();
  const PressureGrid patch = PressureGrid::exact(cells);
  const SampledReference exact = SampledReference::of(cells);
  for (int j = 0; j <= 6; ++j) {
    for (int i = 0; i <= 8; ++i) {
      for (const double off : {0.0, 1e-15, 1e-9}) {
        const Twist v = twist_about({-0.5 + 0.125 * i + off, 0.25 + 0.0625 * j - off}, -2);
        const BoundedWrench g = patch.bounded_gradient(v);
        const auto [force, moment] = error_of(g.value, exact.gradient(v));
        EXPECT_LE(force, g.force_error) << i << ' ' << j << ' ' << off;
        EXPECT_LE(moment, g.moment_error) << i << ' ' << j << ' ' << off;
        EXPECT_LE(g.force_error, 1e-13);
      }
    }
  }
}

TEST(SampledGrid, HessianIsThatOfFiftyDigits) {
  std::mt19937_64 engine(3);
  for (const PressureCells& cells : {uneven_cells(), dome(4), rough(3, engine)}) {
    const PressureGrid patch = PressureGrid::exact(cells);
    const SampledReference exact = SampledReference::of(cells);
    const double a = patch.area_radius();
    for (int i = 0; i < testing::cases(8); ++i) {
      const Twist v = random_motion(patch, engine);
      const Hessian h = patch.hessian(v);
      const double size = scaled_size(h, v, a);
      EXPECT_LE(scaled_difference(h, exact.hessian(v, a), v, a), 1e-12 * size) << v.vx << ' ' << v.vy << ' ' << v.w;
      EXPECT_LE(along_itself(h, v, a), 1e-12 * size);
      EXPECT_GE(least_curvature(h, v, a), -1e-12 * size);
    }
  }
}

// Twice the force of what is there, moved and turned round: nothing changes but the frame.
TEST(SampledGrid, UnitsOfPressureDoNotMatterAndTheFrameDoesNot) {
  const PressureGrid patch = PressureGrid::exact(uneven_cells());
  PressureCells moved = uneven_cells();
  moved.x0 += 8;
  moved.y0 -= 4;
  for (double& p : moved.pressures) p *= 3e7;
  PressureCells turned = uneven_cells();  // by half a turn
  std::ranges::reverse(turned.pressures);
  turned.x0 = -0.5;
  turned.y0 = -0.625;
  const PressureGrid there = PressureGrid::exact(moved), round = PressureGrid::exact(turned);
  std::mt19937_64 engine(4);
  for (int i = 0; i < 300; ++i) {
    const Twist v = random_motion(patch, engine);
    const Wrench g = patch.gradient(v);
    const Wrench h = there.gradient({v.vx + v.w * -4, v.vy - v.w * 8, v.w});
    const Wrench r = round.gradient({-v.vx, -v.vy, v.w});
    EXPECT_LE(std::hypot(g.fx - h.fx, g.fy - h.fy), 1e-13);
    EXPECT_NEAR(h.m, g.m + 8 * h.fy + 4 * h.fx, 1e-13);
    EXPECT_LE(std::hypot(g.fx + r.fx, g.fy + r.fy), 1e-14);
    EXPECT_NEAR(r.m, g.m, 1e-14);
  }
}

TEST(SampledGrid, SpeedAndSizeScale) {
  const PressureGrid patch = PressureGrid::exact(uneven_cells());
  std::mt19937_64 engine(5);
  for (const double k : {0x1p-300, 0x1p300}) {
    PressureCells cells = uneven_cells();
    for (double* length : {&cells.dx, &cells.dy, &cells.x0, &cells.y0}) *length *= k;
    const PressureGrid scaled = PressureGrid::exact(cells);
    for (int i = 0; i < 100; ++i) {
      const Twist v = random_motion(patch, engine);
      const Wrench g = patch.gradient(v);
      const Wrench fast = patch.gradient({k * v.vx, k * v.vy, k * v.w});
      const Wrench large = scaled.gradient({v.vx, v.vy, v.w / k});
      EXPECT_TRUE(fast.fx == g.fx && fast.fy == g.fy && fast.m == g.m);
      EXPECT_TRUE(large.fx == g.fx && large.fy == g.fy && large.m == k * g.m);
      EXPECT_EQ(patch.dissipation({k * v.vx, k * v.vy, k * v.w}), k * patch.dissipation(v));
    }
  }
}

TEST(SampledGrid, AtRestItAnswersTheLeastSubgradientAndHasNoHessian) {
  const PressureGrid patch = PressureGrid::exact(uneven_cells());
  const BoundedWrench g = patch.bounded_gradient({});
  EXPECT_TRUE(g.value.fx == 0 && g.value.fy == 0 && g.value.m == 0);
  EXPECT_EQ(patch.dissipation({}), 0);
  EXPECT_THAT([&] { patch.hessian({}); }, ThrowsMessage<std::domain_error>(HasSubstr("twist = 0 is not allowed")));
}

TEST(SampledGrid, NotANumberComesOutWhereItGoesIn) {
  const PressureGrid patch = PressureGrid::exact(uneven_cells());
  for (const Twist& v : {Twist{nan, 1, 1}, Twist{1, nan, 1}, Twist{1, 1, nan}, Twist{infinity, 1, 1}}) {
    const Wrench g = patch.gradient(v);
    EXPECT_TRUE(std::isnan(g.fx) && std::isnan(g.fy) && std::isnan(g.m));
    EXPECT_TRUE(std::isnan(patch.dissipation(v)));
  }
}

TEST(SampledGrid, BadInputIsRefusedByName) {
  const auto refused = [](auto change, const char* message) {
    PressureCells cells = uneven_cells();
    change(cells);
    EXPECT_THAT([&] { PressureGrid::exact(cells); }, ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
  };
  refused([](PressureCells& c) { c.dx = 0; }, "dx = 0 is not allowed");
  refused([](PressureCells& c) { c.dy = nan; }, "dy = nan is not allowed");
  refused([](PressureCells& c) { c.x0 = infinity; }, "x0 = inf is not allowed");
  refused([](PressureCells& c) { c.nx = 0; }, "nx, ny = 0, 3 are not allowed");
  refused([](PressureCells& c) { c.ny = std::size_t{1} << 62; }, "there must be from 1 to 2^24 cells");
  refused([](PressureCells& c) { c.pressures.pop_back(); }, "pressures has 11 numbers: nx ny = 12 are expected");
  refused([](PressureCells& c) { c.pressures[5] = -1e-9; }, "pressures[5] = -1e-09 is not allowed");
  refused([](PressureCells& c) { c.pressures[2] = nan; }, "pressures[2] = nan is not allowed");
  refused([](PressureCells& c) { std::ranges::fill(c.pressures, 0); }, "pressures are all 0");
  refused([](PressureCells& c) { c.dx = c.dy = 1e-200; }, "polar moment");
  for (const double tolerance : {0.0, 1e-15, 0.1, nan}) {
    EXPECT_THAT([&] { PressureGrid::within(tolerance, uneven_cells()); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("tolerance = ")));
  }
}

}  // namespace
}  // namespace patchgrip::friction
