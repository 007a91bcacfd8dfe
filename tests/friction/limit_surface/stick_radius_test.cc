#include <patchgrip/friction/limit_surface/stick_radius.h>

#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/several.h>

namespace patchgrip::friction {
namespace {

// data/reference/friction.json, section stick_radius
TEST(StickRadius, AgreesWithTheReferenceTable) {
  const LimitSurface surface(Rectangle::of_sides(0.04, 0.02));
  const struct {
    double phi, theta, rho;
  } rows[] = {{0.3, 0.4, 0.7634222229286390031879},
              {1.1, 0.8, 0.7858661903460601764253},
              {0, 1.2, 0.9457357575833888577626},
              {-2, 1, 0.8207047576801407744647}};
  for (const auto& [phi, theta, rho] : rows) {
    const StickRadius r = stick_radius(surface, phi, theta);
    EXPECT_NEAR(r.value, rho, 4e-15);
    EXPECT_LE(r.lower, rho);
    EXPECT_GE(r.upper, rho);
    EXPECT_LE(r.upper - r.lower, 1.1e-12);
  }
}

TEST(StickRadius, IsOneForForcesThroughTheCentroidAndMinSForMoments) {
  const LimitSurface surface(HertzDisc::of_radius(0.3));
  EXPECT_NEAR(stick_radius(surface, 2, std::numbers::pi / 2).value, 1, 1e-15);
  EXPECT_NEAR(stick_radius(surface, 0, 0).value, 3 * std::numbers::pi / 16, 1e-15);
  EXPECT_NEAR(stick_radius(surface, 0, std::numbers::pi).value, 3 * std::numbers::pi / 16, 1e-15);
}

TEST(StickRadius, OfAPatchWithoutAreaIsRefused) {
  const LimitSurface surface(
      Several::of_parts({{Placed(PointLoad{}, -0.02, 0), 1}, {Placed(PointLoad{}, 0.02, 0), 1}}));
  EXPECT_THROW(stick_radius(surface, 0, 0), std::invalid_argument);
  EXPECT_THROW(stick_radius(surface, 1, 1), std::invalid_argument);
}

TEST(StickRadius, ForcesPastTheCentroidHaveLess) {
  const LimitSurface surface(Placed(HertzDisc::of_radius(0.3), 0.1, 0));
  EXPECT_NEAR(stick_radius(surface, 0, std::numbers::pi / 2).value, 1, 1e-14);
  EXPECT_LT(stick_radius(surface, std::numbers::pi / 2, std::numbers::pi / 2).upper, 1);
}

}  // namespace
}  // namespace patchgrip::friction
