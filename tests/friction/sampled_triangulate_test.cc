#include <patchgrip/friction/sampled/triangulate.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/tests/friction/sampled_cases.h>
#include <patchgrip/tests/friction/shapes.h>

namespace patchgrip::friction {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

double area(const Triangulation& mesh, const std::array<std::size_t, 3>& t) {
  const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

double longest_edge(const Triangulation& mesh) {
  double longest = 0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &p = mesh.points[t[i]], &q = mesh.points[t[(i + 1) % 3]];
      longest = std::max(longest, std::hypot(p.x - q.x, p.y - q.y));
    }
  }
  return longest;
}

class TriangulationOf : public ::testing::TestWithParam<Shape> {};

INSTANTIATE_TEST_SUITE_P(, TriangulationOf, ::testing::Values(triangle, l_shape, frame, comb, slender_10, away),
                         [](const auto& instance) { return instance.param.name; });

// With a uniform pressure it is the polygon again: nothing is missing, nothing is there twice, holes are left out.
TEST_P(TriangulationOf, FillsThePolygonWithEdgesNoLongerThanAskedFor) {
  const Shape& shape = GetParam();
  const Polygon polygon = shape.patch();
  const double edge = polygon.area_radius() / 4;
  const Triangulation mesh = triangulate(shape.outer, shape.holes, edge);
  EXPECT_LE(longest_edge(mesh), edge);
  for (const auto& t : mesh.triangles) EXPECT_GT(area(mesh, t), 0);
  const PressureMesh patch = PressureMesh::linear(mesh, sample(mesh, [](double, double) { return 2; }));
  const double a = polygon.area_radius();
  EXPECT_NEAR(patch.area_radius(), a, 1e-12 * a);
  EXPECT_NEAR(patch.moments().polar, polygon.moments().polar, 1e-12 * a * a);
  std::mt19937_64 engine(1);
  for (int i = 0; i < 50; ++i) {
    const PressureMoments s = polygon.moments();
    const Twist v = random_motion(polygon, engine);
    const Wrench g = patch.gradient(v), h = polygon.gradient(v);
    EXPECT_LE(std::hypot(g.fx - h.fx, g.fy - h.fy), 1e-10);
    EXPECT_NEAR(g.m, h.m, 1e-10 * (a + std::hypot(s.x, s.y)));
  }
}

TEST(Triangulate, ShorterEdgesMakeMoreTriangles) {
  const auto count = [](double edge) { return triangulate(l_ring, {}, edge).triangles.size(); };
  EXPECT_GE(count(0.1), 3 * count(0.2));
  EXPECT_LE(count(0.1), 6 * count(0.2));
}

TEST(Triangulate, BadInputIsRefusedByName) {
  const auto refused = [](const PointRing& outer, const std::vector<PointRing>& holes, double edge, const char* text) {
    EXPECT_THAT([&] { triangulate(outer, holes, edge); }, ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  refused(l_ring, {}, 0, "largest_edge = 0 is not allowed");
  refused(l_ring, {}, -1, "largest_edge = -1 is not allowed");
  refused(l_ring, {}, INFINITY, "largest_edge = inf is not allowed");
  refused(l_ring, {}, 1e-5, "for this area");
  refused({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}, 0.1, "crosses or touches itself");
  refused(box(0, 0, 1, 1), {box(0.5, 0.5, 2, 2)}, 0.1, "holes[0]");
}

}  // namespace
}  // namespace patchgrip::friction
