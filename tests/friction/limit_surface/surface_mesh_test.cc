#include <patchgrip/friction/limit_surface/surface_mesh.h>

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/tests/friction/shapes.h>

namespace patchgrip::friction {
namespace {

using Vector3 = std::array<double, 3>;

Vector3 point(const SurfaceMesh& mesh, std::uint32_t i) {
  const Wrench& t = mesh.vertices[i].load;
  return {t.fx, t.fy, t.m / mesh.moment_scale};
}

// Six times the volume of the tetrahedron from the origin.
double volume(const Vector3& a, const Vector3& b, const Vector3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

template <class P>
void expect_closed_convex(const P& patch) {
  const LimitSurface surface(patch);
  const SurfaceMesh mesh = surface_mesh(surface, 3);
  ASSERT_EQ(mesh.vertices.size(), 642u);
  ASSERT_EQ(mesh.triangles.size(), 1280u);
  EXPECT_LE(mesh.worst_gap, 1e-12);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& [a, b, c] : mesh.triangles) {
    EXPECT_GT(volume(point(mesh, a), point(mesh, b), point(mesh, c)), 0);
    ++edges[{a, b}], ++edges[{b, c}], ++edges[{c, a}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
  for (const SurfaceVertex& v : mesh.vertices) {
    EXPECT_NEAR(power(v.load, v.slip), 1, 4e-15);
    // No vertex lies beyond the tangent plane of another.
    for (const SurfaceVertex& other : mesh.vertices) ASSERT_LE(power(other.load, v.slip), 1 + 1e-12);
  }
}

TEST(SurfaceMesh, IsClosedConvexAndFacesOutwards) {
  expect_closed_convex(HertzDisc::of_radius(0.01));
  expect_closed_convex(Rectangle::of_sides(0.4, 0.02));
  expect_closed_convex(l_shape.patch());
}

TEST(SurfaceMesh, FillsUpByTheSquareOfItsEdges) {
  // The volume inside of the mesh against refinement.
  const LimitSurface surface(HertzDisc::of_radius(1));
  const auto volume_of = [&](int refinements) {
    const SurfaceMesh mesh = surface_mesh(surface, refinements);
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) sum += volume(point(mesh, a), point(mesh, b), point(mesh, c)) / 6;
    return sum;
  };
  // Inscribed, with an error of the second order.
  const double v3 = volume_of(3), v4 = volume_of(4), v5 = volume_of(5);
  EXPECT_LT(v3, v4);
  EXPECT_LT(v4, v5);
  EXPECT_NEAR((v4 - v3) / (v5 - v4), 4, 0.1);
}

TEST(SurfaceMesh, SlipIsTheNormalAndHasItsPole) {
  const SurfaceMesh mesh = surface_mesh(LimitSurface(HertzDisc::of_radius(2)), 1);
  const SurfaceVertex& top = mesh.vertices[0];
  EXPECT_EQ(top.load.fx, 0);
  EXPECT_NEAR(top.load.m, mesh.moment_scale, 1e-15);
  EXPECT_NEAR(std::hypot(top.pole()->x, top.pole()->y), 0, 1e-15);
  EXPECT_FALSE((SurfaceVertex{{1, 0, 0}, {1, 0, 0}}.pole().has_value()));
}

TEST(SurfaceMesh, RefinementsAreLimited) {
  const LimitSurface surface(HertzDisc::of_radius(2));
  EXPECT_THROW(surface_mesh(surface, -1), std::invalid_argument);
  EXPECT_THROW(surface_mesh(surface, 8), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
