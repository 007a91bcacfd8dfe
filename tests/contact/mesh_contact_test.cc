#include <patchgrip/contact/mesh_contact.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/ellipsoid_mesh.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::ellipsoid_mesh;
using patchgrip::testing::uniform;

// Ellipsoids on either side of z = 0, touching in the origin: the upper one turned about z.
TriangleMesh touching(int levels, const std::array<double, 3>& axes, double turn, int side) {
  auto mesh = ellipsoid_mesh(levels, axes[0], axes[1], axes[2]);
  const double c = std::cos(turn), s = std::sin(turn);
  for (auto& v : mesh.vertices) v = {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2] + side * axes[2]};
  return TriangleMesh::of(mesh.vertices, mesh.triangles);
}

// At the pole of an ellipsoid 1/R is az/ax^2 along x and az/ay^2 along y.
PrincipalRadii at_pole(const std::array<double, 3>& axes) {
  return {axes[0] * axes[0] / axes[2], axes[1] * axes[1] / axes[2]};
}

TEST(MeshContact, HoldsItsErrorsOnEllipsoids) {
  std::mt19937_64 engine(20060320);
  double worst = 0;
  for (int i = 0; i < cases(12); ++i) {
    const auto axes = [&] {
      return std::array{uniform(engine, 0.02, 0.04), uniform(engine, 0.02, 0.04), uniform(engine, 0.01, 0.03)};
    };
    const auto below = axes(), above = axes();
    const double turn = uniform(engine, -1.5, 1.5);
    const auto contact =
        MeshContact::between(touching(4 + i % 2, below, 0, -1), touching(4, above, turn, 1), {0, 0, 0});
    const auto exact = RelativeRadii::of_bodies(at_pole(below), at_pole(above), turn);
    worst = std::max({worst, std::abs(1 / contact.radii.small - 1 / exact.small) / contact.curvature_error,
                      std::abs(1 / contact.radii.large - 1 / exact.large) / contact.curvature_error});

    const auto pressed = contact.under_force(2, 1e6);
    const auto truth = HertzEllipse::under_force(2, exact, 1e6);
    worst = std::max({worst, std::abs(pressed.ellipse.a - truth.a) / pressed.a_error,
                      std::abs(pressed.ellipse.b - truth.b) / pressed.b_error,
                      std::abs(pressed.ellipse.peak_pressure - truth.peak_pressure) / pressed.peak_pressure_error,
                      std::abs(pressed.ellipse.approach - truth.approach) / pressed.approach_error});
    EXPECT_LE(pressed.approach_error, 0.05 * truth.approach);

    // R1 of the lower ellipsoid lies along x.
    if (exact.one_minus_ratio > 0.2) {
      const double along =
          contact.direction_a[0] * std::cos(exact.angle_a) + contact.direction_a[1] * std::sin(exact.angle_a);
      EXPECT_GE(std::abs(along), 0.999);
    }
  }
  RecordProperty("worst_of_bound", std::to_string(worst));
  EXPECT_LE(worst, 1);
}

TEST(MeshContact, TurnGoesFromThePToTheMDirectionAboutTheNormalOfP) {
  const std::array axes{0.02, 0.04, 0.02};  // k_max along x
  for (const double turn : {-1.2, -0.4, 0.4, 0.7, 1.2}) {
    const auto contact = MeshContact::between(touching(5, axes, 0, -1), touching(5, axes, turn, 1), {0, 0, 0});
    EXPECT_NEAR(std::remainder(contact.turn - turn, std::numbers::pi), 0, 0.02);
  }
}

TEST(MeshContact, ABallAddsItsCurvature) {
  const std::array axes{0.02, 0.04, 0.02};
  const TriangleMesh mesh = touching(5, axes, 0, -1);
  for (const double R : {0.03, static_cast<double>(INFINITY), -0.3}) {
    const auto contact = MeshContact::with_ball(mesh, R, {0, 0, 0});
    const auto exact = RelativeRadii::of_bodies(at_pole(axes), {R, R}, 0);
    EXPECT_LE(std::abs(1 / contact.radii.small - 1 / exact.small), contact.curvature_error) << R;
    EXPECT_LE(std::abs(1 / contact.radii.large - 1 / exact.large), contact.curvature_error) << R;
    EXPECT_EQ(contact.curvature_error, contact.first.curvature_error);
    EXPECT_EQ(MeshContact::with_ball(contact.first, R).radii.small, contact.radii.small);
  }
}

TEST(MeshContact, BodiesThatDoNotFaceEachOtherAreRefused) {
  const std::array ball{0.02, 0.02, 0.02};
  const auto below = touching(4, ball, 0, -1);
  EXPECT_THAT(
      [&] {
        MeshContact::between(below, below, {0, 0, 0});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("angle_between_normals")));
  EXPECT_THAT(
      [&] {
        MeshContact::between(below, touching(4, {0.02, 0.02, 0.02}, 0, 1), {0, 0.02, -0.02});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("distance of the point to the mesh")));
}

TEST(MeshContact, MeshesTooCoarseToTellAreRefused) {
  const std::array sharp{0.05, 0.05, 0.002};
  EXPECT_THAT(
      [&] {
        MeshContact::between(touching(3, sharp, 0, -1), touching(3, sharp, 0.3, 1), {0.04, 0, 0});
      },
      ::testing::Throws<std::invalid_argument>());
}

}  // namespace
}  // namespace patchgrip::contact
