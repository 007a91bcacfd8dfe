#include <patchgrip/friction/sampled/scattered.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/friction/sampled/triangulate.h>
#include <patchgrip/tests/friction/sampled_cases.h>
#include <patchgrip/tests/friction/shapes.h>

namespace patchgrip::friction {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Vertices, points on the edges and points inside, of every ring.
std::vector<Point> scattered_over(const Shape& shape, std::mt19937_64& engine) {
  std::vector<PointRing> rings = shape.holes;
  rings.push_back(shape.outer);
  std::vector<Point> points;
  for (const PointRing& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      points.push_back(a);
      for (int k = 0; k < 3; ++k) {
        const double t = uniform(engine, 0.05, 0.95);
        points.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      }
    }
  }
  const std::size_t on_rings = points.size();
  const Triangulation inside = triangulate(shape.outer, shape.holes, shape.patch().area_radius() / 3);
  for (const auto& [i, j, k] : inside.triangles) {
    const Point &p = inside.points[i], &q = inside.points[j], &r = inside.points[k];
    points.push_back({(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3});
  }
  EXPECT_GT(points.size(), on_rings);
  std::ranges::shuffle(points, engine);
  return points;
}

void expect_alike(const PressureMesh& a, const PressureMesh& b, double origin, std::mt19937_64& engine) {
  const double radius = b.area_radius();
  EXPECT_NEAR(a.area_radius(), radius, 1e-8 * radius);
  EXPECT_NEAR(a.moments().polar, b.moments().polar, 1e-8 * radius * radius);
  for (int i = 0; i < 50; ++i) {
    const Twist v = random_motion(b, engine);
    const Wrench g = a.gradient(v), h = b.gradient(v);
    EXPECT_LE(std::hypot(g.fx - h.fx, g.fy - h.fy), 2e-8);
    EXPECT_NEAR(g.m, h.m, 2e-8 * (radius + origin));
  }
}

class ScatteredOver : public ::testing::TestWithParam<Shape> {};

INSTANTIATE_TEST_SUITE_P(, ScatteredOver,
                         ::testing::Values(triangle, l_shape, frame, comb, slender_10, away, micrometre),
                         [](const auto& instance) { return instance.param.name; });

// Whatever the points, a pressure that is linear in x and y is the same. Those on edges lie there only to rounding.
TEST_P(ScatteredOver, ALinearPressureDoesNotDependOnThePoints) {
  const Shape& shape = GetParam();
  std::mt19937_64 engine(1);
  const std::vector<Point> points = scattered_over(shape, engine);
  const Triangulation mesh = triangulate_between(points, shape.outer, shape.holes);
  ASSERT_EQ(mesh.points.size(), points.size());  // no vertex without its point
  const PressureMoments s = shape.patch().moments();
  const double a = shape.patch().area_radius();
  const auto pressure = [&](double x, double y) { return 20 + (x - s.x) / a + 2 * (y - s.y) / a; };
  const Triangulation other = triangulate(shape.outer, shape.holes, a / 4);
  expect_alike(PressureMesh::linear(mesh, sample(mesh, pressure)), PressureMesh::linear(other, sample(other, pressure)),
               std::hypot(s.x, s.y), engine);
}

// Pyramid over the square |x|, |y| <= s: polar moment 2 s^2 / 5.
TEST(Scattered, ThePressureFallsToNothingAtVerticesWithoutPoints) {
  const Triangulation mesh = triangulate_between({{0, 0}}, box(-3, -3, 3, 3), {});
  ASSERT_EQ(mesh.points.size(), 5U);
  EXPECT_EQ(mesh.triangles.size(), 4U);
  const PressureMesh pyramid = PressureMesh::linear(mesh, {7, 0, 0, 0, 0});
  EXPECT_NEAR(pyramid.moments().polar, 0.4 * 9, 1e-14);
  EXPECT_NEAR(pyramid.moments().x, 0, 1e-15);
}

TEST(Scattered, APointBesideARingWithinItsReachBelongsToIt) {
  const auto corners = [](double beside) {
    return triangulate_between({{0.5, beside}, {0.5, 0.5}}, box(0, 0, 1, 1), {}).triangles.size();
  };
  EXPECT_EQ(corners(1e-9), 5U);   // five rim nodes around the middle
  EXPECT_EQ(corners(-1e-9), 5U);  // outside, by less than the reach of sqrt(2) 1e-9
  EXPECT_EQ(corners(2e-9), 6U);   // inside: one triangle more, next to the rim
}

TEST(Scattered, BadInputIsRefusedByName) {
  const auto refused = [](const PointRing& points, const PointRing& outer, const std::vector<PointRing>& holes,
                          const char* text) {
    EXPECT_THAT([&] { triangulate_between(points, outer, holes); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  const PointRing unit = box(0, 0, 1, 1);
  const PointRing hole = box(0.25, 0.25, 0.5, 0.5);
  refused({{0.5, 0.5}, {2, 0.25}}, unit, {}, "points[1] = [2, 0.25] is not allowed: must lie within the vertices");
  refused({{0.5, -3e-9}}, unit, {}, "must lie within the vertices");
  refused({{0.3, 0.3}}, unit, {hole}, "points[0] = [0.3, 0.3] is not allowed: must lie outside of holes[0]");
  refused({{0.75, 0.5}, {0.75, 0.5}}, unit, {}, "points[1] = [0.75, 0.5] is not allowed: is the same as points[0]");
  refused({{0.75, INFINITY}}, unit, {}, "coordinates must be finite");
  refused({{0.5, 0.5}}, {{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}, "crosses or touches itself");
  refused({{0.5, 0.5}}, unit, {box(0.5, 0.5, 2, 2)}, "holes[0]");
}

}  // namespace
}  // namespace patchgrip::friction
