#include <patchgrip/friction/sampled/pressure_mesh.h>

#include <array>
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
#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/sampled_cases.h>
#include <patchgrip/tests/friction/sampled_reference.h>

namespace patchgrip::friction {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

static_assert(Patch<PressureMesh>);

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double number(const nlohmann::json& text) { return std::stod(text.get<std::string>()); }

PressureMesh table_mesh(const nlohmann::json& contact) {
  Triangulation mesh;
  std::vector<double> pressures;
  for (const auto& vertex : contact["vertices_m"]) mesh.points.push_back({number(vertex[0]), number(vertex[1])});
  for (const auto& triangle : contact["triangles"]) mesh.triangles.push_back({triangle[0], triangle[1], triangle[2]});
  for (const auto& p : contact["nodal_pressure"]) pressures.push_back(number(p));
  return PressureMesh::linear(mesh, pressures);
}

TEST(SampledMesh, AgreesWithTheTable) {
  std::ifstream file(PATCHGRIP_DATA_DIR "/reference/friction.json");
  const auto table = nlohmann::json::parse(file);
  int rows = 0;
  for (const auto& entry : table["wrench_integrals"]) {
    if (entry["contact"]["type"] != "triangles_linear") continue;
    const PressureMesh patch = table_mesh(entry["contact"]);
    const double a = number(entry["a_K_m"]);
    EXPECT_NEAR(patch.area_radius(), a, 1e-15 * a);
    for (const auto& row : entry["rows"]) {
      const Twist v = twist_about({number(row["xi_M"]), number(row["eta_M"])}, 1);
      const Wrench g = patch.gradient(v);
      EXPECT_NEAR(g.fx, number(row["I1"]), 1e-14);
      EXPECT_NEAR(g.fy, number(row["I2"]), 1e-14);
      EXPECT_NEAR(g.m, a * number(row["I3"]), 1e-13 * a);
      EXPECT_NEAR(patch.dissipation(v), number(row["S_m"]), 1e-14 * number(row["S_m"]));
      ++rows;
    }
  }
  for (const auto& entry : table["hessian_S"]) {
    if (entry["contact"]["type"] != "triangles_linear") continue;
    const PressureMesh patch = table_mesh(entry["contact"]);
    for (const auto& row : entry["rows"]) {
      const Hessian h = patch.hessian(twist_about({number(row["xi_M"]), number(row["eta_M"])}, 1));
      const double size = std::fabs(number(row["S_xixi"])) + std::fabs(number(row["S_etaeta"]));
      EXPECT_NEAR(h.yy, number(row["S_xixi"]), 1e-13 * size);
      EXPECT_NEAR(-h.xy, number(row["S_xieta"]), 1e-13 * size);
      EXPECT_NEAR(h.xx, number(row["S_etaeta"]), 1e-13 * size);
      ++rows;
    }
  }
  EXPECT_GE(rows, 12);
}

void expect_same(const PressureMesh& a, const auto& b, std::mt19937_64& engine, int count) {
  for (int i = 0; i < count; ++i) {
    const Twist v = random_motion(a, engine);
    const BoundedWrench g = a.bounded_gradient(v), h = b.bounded_gradient(v);
    EXPECT_LE(std::hypot(g.value.fx - h.value.fx, g.value.fy - h.value.fy), g.force_error + h.force_error);
    EXPECT_LE(std::fabs(g.value.m - h.value.m), g.moment_error + h.moment_error);
    const double size = scaled_size(b.hessian(v), v, b.area_radius());
    EXPECT_LE(scaled_difference(a.hessian(v), b.hessian(v), v, b.area_radius()), 1e-12 * size);
  }
}

TEST(SampledMesh, UniformPressureOnAPolygonIsThePolygon) {
  std::mt19937_64 engine(1);
  Triangulation mesh = shaken_mesh(5, 4, 1, 0, engine);
  const std::vector<double> nodes(mesh.points.size(), 3.7), triangles(mesh.triangles.size(), 0.2);
  const Polygon polygon = Polygon::uniform({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  expect_same(PressureMesh::linear(mesh, nodes), polygon, engine, 200);
  expect_same(PressureMesh::constant(mesh, triangles), polygon, engine, 200);
}

// Every triangle in four through the middles of its edges.
Triangulation refined(const Triangulation& mesh) {
  Triangulation fine{mesh.points, {}};
  for (const auto& t : mesh.triangles) {
    std::array<std::size_t, 3> middle;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &p = mesh.points[t[i]], &q = mesh.points[t[(i + 1) % 3]];
      middle[i] = fine.points.size();  // those of neighbours are points of their own
      fine.points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2});
    }
    fine.triangles.push_back({t[0], middle[0], middle[2]});
    fine.triangles.push_back({middle[0], t[1], middle[1]});
    fine.triangles.push_back({middle[2], middle[1], t[2]});
    fine.triangles.push_back({middle[0], middle[1], middle[2]});
  }
  return fine;
}

TEST(SampledMesh, RefinementOfALinearPressureChangesNothing) {
  std::mt19937_64 engine(2);
  const auto plane = [](double x, double y) { return 1 + 2 * x + 0.5 * y; };
  const Triangulation coarse = shaken_mesh(2, 3, 1, 0.2, engine);
  const Triangulation fine = refined(coarse);
  expect_same(PressureMesh::linear(fine, nodal(fine, plane)), PressureMesh::linear(coarse, nodal(coarse, plane)),
              engine, 200);
}

TEST(SampledMesh, TrianglesOnTopOfOneAnotherAddUp) {
  std::mt19937_64 engine(3);
  const Triangulation mesh = shaken_mesh(2, 2, 1, 0.1, engine);
  Triangulation twice = mesh;
  twice.triangles.insert(twice.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
  const auto p = nodal(mesh, [](double x, double) { return 1 + x; });
  expect_same(PressureMesh::linear(twice, p), PressureMesh::linear(mesh, p), engine, 100);
}

TEST(SampledMesh, PolesOnNodesEdgesAndCentresAreLikeAnyOther) {
  std::mt19937_64 engine(4);
  const Triangulation mesh = shaken_mesh(3, 3, 0.5, 0.2, engine);
  const auto p = nodal(mesh, [&](double, double) { return uniform(engine, 0, 1); });
  const PressureMesh patch = PressureMesh::linear(mesh, p);
  const SampledReference exact = SampledReference::linear(mesh, p);
  for (const auto& t : mesh.triangles) {
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    for (const Pole& pole : {Pole{a.x, a.y}, Pole{(a.x + b.x) / 2, (a.y + b.y) / 2}, Pole{2 * b.x - a.x, 2 * b.y - a.y},
                             Pole{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}, Pole{a.x + 1e-13, a.y}}) {
      const Twist v = twist_about(pole, -0.7);
      const BoundedWrench g = patch.bounded_gradient(v);
      const auto [force, moment] = error_of(g.value, exact.gradient(v));
      EXPECT_LE(force, g.force_error);
      EXPECT_LE(moment, g.moment_error);
      EXPECT_LE(g.force_error, 1e-12);
    }
  }
}

TEST(SampledMesh, HessianIsThatOfFiftyDigits) {
  std::mt19937_64 engine(5);
  const Triangulation mesh = shaken_mesh(2, 3, 0.7, 0.25, engine);
  const auto p = nodal(mesh, [&](double, double) { return uniform(engine, 0, 1); });
  const std::vector<double> q(p.begin(), p.begin() + 7);
  Triangulation part{mesh.points, {mesh.triangles.begin(), mesh.triangles.begin() + 7}};
  const auto compare = [&](const PressureMesh& patch, const SampledReference& exact) {
    const double a = patch.area_radius();
    for (int i = 0; i < testing::cases(8); ++i) {
      const Twist v = random_motion(patch, engine);
      const Hessian h = patch.hessian(v);
      const double size = scaled_size(h, v, a);
      EXPECT_LE(scaled_difference(h, exact.hessian(v, a), v, a), 2e-12 * size) << v.vx << ' ' << v.vy << ' ' << v.w;
      EXPECT_LE(along_itself(h, v, a), 2e-12 * size);
      EXPECT_GE(least_curvature(h, v, a), -2e-12 * size);
    }
  };
  compare(PressureMesh::linear(mesh, p), SampledReference::linear(mesh, p));
  compare(PressureMesh::constant(part, q), SampledReference::constant(part, q));
}

TEST(SampledMesh, TurnsWithItsPoints) {
  std::mt19937_64 engine(6);
  const Triangulation mesh = shaken_mesh(3, 3, 1, 0.2, engine);
  const auto p = nodal(mesh, [](double x, double y) { return 1 + x * y; });
  Triangulation turned = mesh;  // by a quarter
  for (Point& point : turned.points) point = {-point.y, point.x};
  const PressureMesh patch = PressureMesh::linear(mesh, p), other = PressureMesh::linear(turned, p);
  for (int i = 0; i < 200; ++i) {
    const Twist v = random_motion(patch, engine);
    const Wrench g = patch.gradient(v), h = other.gradient({-v.vy, v.vx, v.w});
    EXPECT_LE(std::hypot(h.fx + g.fy, h.fy - g.fx), 1e-13);
    EXPECT_NEAR(h.m, g.m, 1e-13);
  }
}

TEST(SampledMesh, BadInputIsRefusedByName) {
  const Triangulation good{{{0, 0}, {1, 0}, {0, 1}, {2, 0}}, {{0, 1, 2}}};
  const auto refused = [](const Triangulation& mesh, const std::vector<double>& p, const char* message) {
    EXPECT_THAT([&] { PressureMesh::linear(mesh, p); }, ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
  };
  const std::vector<double> p{1, 1, 1, 0};
  refused(good, {1, 1, 1}, "pressures has 3 numbers: one for each of 4 points is expected");
  refused(good, {1, -1, 1, 1}, "pressures[1] = -1 is not allowed");
  refused(good, {1, nan, 1, 1}, "pressures[1] = nan is not allowed");
  refused(good, {0, 0, 0, 1}, "pressures are all 0 on the triangles");
  refused({good.points, {}}, p, "triangles has 0 entries");
  refused({good.points, {{0, 1, 4}}}, p, "triangles[0] names point 4: there are 4");
  refused({good.points, {{0, 1, 2}, {0, 1, 3}}}, p, "triangles[1] has no area");
  refused({good.points, {{0, 1, 1}}}, p, "triangles[0] has no area");
  refused({{{0, 0}, {1, 0}, {0, 1}, {1e-20, 0}, {0, 1e-20}}, {{0, 1, 2}, {0, 3, 4}}}, {1, 1, 1, 1, 1},
          "the triangle of points 0, 3, 4 is too small");
  Triangulation bad = good;
  bad.points[1].y = nan;
  refused(bad, p, "points[1].y = nan is not allowed");
  EXPECT_THAT(
      [&] {
        PressureMesh::constant(good, {1, 2});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("one for each of 1 triangles is expected")));
  EXPECT_THAT([&] { PressureMesh::linear_within(0.1, good, p); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("tolerance = 0.1 is not allowed")));
}

}  // namespace
}  // namespace patchgrip::friction
