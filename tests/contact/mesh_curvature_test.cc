#include <patchgrip/contact/mesh_curvature.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/ellipsoid_mesh.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::ellipsoid_mesh;
using patchgrip::testing::uniform;

double dot(const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

TriangleMesh mesh_of(int levels, const std::array<double, 3>& axes, double scatter, std::mt19937_64& engine) {
  auto triangles = ellipsoid_mesh(levels, axes[0], axes[1], axes[2]);
  std::normal_distribution<double> noise(0, scatter * axes[0]);
  if (scatter > 0) {
    for (auto& v : triangles.vertices) {
      for (double& x : v) x += noise(engine);
    }
  }
  return TriangleMesh::of(triangles.vertices, triangles.triangles);
}

// The truth in the point that the fit speaks of.
PrincipalCurvatures truth(const std::array<double, 3>& axes, const Vector& point) {
  const double u = std::atan2(point[1] / axes[1], point[0] / axes[0]);
  const double v = std::asin(std::clamp(point[2] / axes[2], -1., 1.));
  return Ellipsoid::of_axes(axes[0], axes[1], axes[2]).curvatures(u, v);
}

// Of the difference of the two matrices of curvature in the tangent plane of the second: its larger eigenvalue in size.
double difference(const PrincipalCurvatures& found, const PrincipalCurvatures& exact) {
  const auto entry = [&](const Vector& p, const Vector& q) {
    return found.k_max * dot(found.direction_of_k_max, p) * dot(found.direction_of_k_max, q) +
           found.k_min * dot(found.direction_of_k_min, p) * dot(found.direction_of_k_min, q);
  };
  const Vector& x = exact.direction_of_k_max;
  const Vector& y = exact.direction_of_k_min;
  const double xx = entry(x, x) - exact.k_max, yy = entry(y, y) - exact.k_min, xy = entry(x, y);
  return std::abs(xx + yy) / 2 + std::hypot((xx - yy) / 2, xy);
}

TEST(MeshCurvature, HoldsItsErrorOnEllipsoids) {
  std::mt19937_64 engine(20060300);
  double worst = 0;
  std::vector<double> ratios;
  for (const auto& axes :
       {std::array{1., 1., 1.}, std::array{0.03, 0.02, 0.01}, std::array{3., 1., 1.}, std::array{1., 1., 5.}}) {
    for (const int levels : {3, 4, 5}) {
      for (const double scatter : {0., 1e-7, 1e-5, 1e-4}) {
        const auto mesh = mesh_of(levels, axes, scatter, engine);
        for (int i = 0; i < cases(11); ++i) {
          const auto point = Ellipsoid::of_axes(axes[0], axes[1], axes[2])
                                 .point(uniform(engine, -3.14, 3.14), std::asin(uniform(engine, -1, 1)));
          const auto found = curvature_near(mesh, point);
          const auto exact = truth(axes, found.point);
          const double error =
              std::max({std::abs(found.curvatures.k_max - exact.k_max), std::abs(found.curvatures.k_min - exact.k_min),
                        difference(found.curvatures, exact)});
          ratios.push_back(error / found.curvature_error);
          worst = std::max(worst, ratios.back());
        }
      }
    }
  }
  std::nth_element(ratios.begin(), ratios.begin() + static_cast<long>(ratios.size() / 2), ratios.end());
  RecordProperty("worst_of_bound", std::to_string(worst));
  RecordProperty("worst_median", std::to_string(ratios[ratios.size() / 2]));
  EXPECT_LE(worst, 1);
  EXPECT_GE(ratios[ratios.size() / 2], 0.05);
}

TEST(MeshCurvature, OfAFineMeshIsGoodAndFindsDirectionsAndNormal) {
  std::mt19937_64 engine(20060301);
  const std::array axes{0.03, 0.02, 0.01};
  const auto mesh = mesh_of(5, axes, 0, engine);
  // The points of the reference table.
  for (const auto& [u, v] : {std::pair{0.4, 0.7}, std::pair{0., 1.2}}) {
    const auto found = curvature_near(mesh, Ellipsoid::of_axes(0.03, 0.02, 0.01).point(u, v));
    const auto exact = truth(axes, found.point);
    EXPECT_LE(found.curvature_error, 0.02 * exact.k_max);
    EXPECT_NEAR(found.curvatures.k_max, exact.k_max, 2e-3 * exact.k_max);
    EXPECT_NEAR(found.curvatures.k_min, exact.k_min, 2e-3 * exact.k_max);
    EXPECT_GE(dot(found.curvatures.normal, exact.normal), 1 - 1e-6);
    EXPECT_GE(std::abs(dot(found.curvatures.direction_of_k_max, exact.direction_of_k_max)), 1 - 1e-4);
  }
}

TEST(MeshCurvature, GetsBetterWithTheFourthPowerOfTheSpacing) {
  std::mt19937_64 engine(20060302);
  const std::array axes{1., 0.9, 0.8};
  std::array<double, 3> errors{};
  for (const int levels : {3, 4, 5}) {
    const auto mesh = mesh_of(levels, axes, 0, engine);
    for (int i = 0; i < 30; ++i) {
      const auto found = curvature_near(mesh, Ellipsoid::of_axes(1, 0.9, 0.8).point(0.2 * i, 1.2 * std::sin(3 * i)));
      const auto exact = truth(axes, found.point);
      errors[static_cast<std::size_t>(levels - 3)] += std::abs(found.curvatures.k_max - exact.k_max) / 30;
    }
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 4, 0.7);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 4, 0.7);
}

TEST(MeshCurvature, OfAHollowIsNegative) {
  auto ball = ellipsoid_mesh(4, 1, 1, 1);
  // Half of a ball, seen from inside.
  std::vector<std::array<std::size_t, 3>> bowl;
  for (const auto& t : ball.triangles) {
    if (ball.vertices[t[0]][2] < 0.1) bowl.push_back({t[0], t[2], t[1]});
  }
  const auto found = curvature_near(TriangleMesh::of(ball.vertices, bowl), {0, 0, -1});
  EXPECT_NEAR(found.curvatures.k_max, -1, found.curvature_error);
  EXPECT_NEAR(found.curvatures.k_min, -1, found.curvature_error);
  EXPECT_GT(found.curvatures.normal[2], 0.999);
}

TEST(MeshCurvature, NearABorderIsRefused) {
  auto ball = ellipsoid_mesh(4, 1, 1, 1);
  std::vector<std::array<std::size_t, 3>> bowl;
  for (const auto& t : ball.triangles) {
    if (ball.vertices[t[0]][2] < 0) bowl.push_back(t);
  }
  const auto mesh = TriangleMesh::of(ball.vertices, bowl);
  EXPECT_NO_THROW(curvature_near(mesh, {0, 0, -1}));
  EXPECT_THAT(
      [&] {
        curvature_near(mesh, {1, 0, 0});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(
          "mesh has fewer than 40 vertices around the point before its border or its end"));
  const auto coarse = ellipsoid_mesh(0, 1, 1, 1);
  EXPECT_THROW(curvature_near(TriangleMesh::of(coarse.vertices, coarse.triangles), {1, 0, 0}), std::invalid_argument);
}

// At the edge of a cube nothing is smooth: the estimate says so.
TEST(MeshCurvature, AtAnEdgeTheEstimateIsAsLargeAsTheCurvature) {
  auto cube = ellipsoid_mesh(4, 1, 1, 1);
  for (auto& v : cube.vertices) {
    const double size = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    for (double& x : v) x /= size;
  }
  const auto found = curvature_near(TriangleMesh::of(cube.vertices, cube.triangles), {1, 1, 0});
  EXPECT_GE(found.curvature_error, 0.5 * std::abs(found.curvatures.k_max));
}

// A corner written with another rounding in one of its triangles.
TEST(MeshCurvature, AnOpenSeamIsToldAsSuch) {
  auto mesh = ellipsoid_mesh(4, 0.03, 0.02, 0.01);
  const std::size_t split = mesh.triangles[0][0];
  const Vector place = mesh.vertices[split];
  mesh.vertices.push_back({place[0] + 1e-15, place[1], place[2]});
  mesh.triangles[0][0] = mesh.vertices.size() - 1;
  EXPECT_THAT([&] { curvature_near(TriangleMesh::of(mesh.vertices, mesh.triangles), place); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("open along a seam")));
  mesh.vertices.back()[0] = place[0] + 1e-4;
  EXPECT_THAT([&] { curvature_near(TriangleMesh::of(mesh.vertices, mesh.triangles), place); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("before its border")));
}

}  // namespace
}  // namespace patchgrip::contact
