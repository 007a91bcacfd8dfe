// Every law warns alike where slopes are not small.
#include <patchgrip/cli/steepness.h>

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/cli/friction_table.h>
#include <patchgrip/contact/hertz_circle.h>
#include <patchgrip/contact/hertz_ellipse.h>

#include "limit_scenes.h"
#include "press_scenes.h"

namespace patchgrip::cli {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* small = "is not small; slopes and strains of that order are outside the half-space theory";

std::vector<std::string> warnings_of(const std::string& text) { return answered(press_scene(text)).answer.warnings; }

TEST(Steepness, OfASocketIsThatOfEachBody) {
  const auto socket = [](double force) {
    return fmt::format(
        "[contact]\nnormal_force = {}\n[[contact.bodies]]\nradius = 0.01\nrigid = true\n"
        "[[contact.bodies]]\nradius = 0.0101\nconcave = true\nyoungs_modulus = 1e6\npoisson_ratio = 0.4\n",
        force);
  };
  EXPECT_THAT(warnings_of(socket(2)), Contains(HasSubstr("a/R = 1.08 of body A is not small; slopes")));
  EXPECT_THAT(warnings_of(socket(1e-3)), Not(Contains(HasSubstr(small))));
  const auto rubbed = [&](double force) {
    return limit_scene(socket(force) + "[friction]\nmu = 0.3\n[[loads]]\nforce = [0.1, 0]\n").contact;
  };
  EXPECT_THAT(rubbed(2).warnings, Contains(HasSubstr("a/R = 1.08 of body A is not small")));
  EXPECT_THAT(rubbed(2).notes, Each(Not(HasSubstr("a/R"))));  // once is enough
  EXPECT_THAT(rubbed(1e-3).notes, Contains(HasSubstr(" of body A (the half-space theory wants it small)")));
  // A socket of two equal directions by their principal radii is the same one.
  const std::string radii = with(with(socket(2), "radius = 0.01\n", "radii = [0.01, 0.0100001]\n"),
                                 "radius = 0.0101\nconcave = true", "radii = [-0.0101, -0.0102]");
  EXPECT_THAT(warnings_of(radii), Contains(HasSubstr("of body A is not small")));
}

TEST(Steepness, WarnsOfEveryLawThatIsTooDeep) {
  const std::string creep =
      with(stamp("radius = 0.02", ""), "youngs_modulus = 50e3", "poynting_thomson = { E1 = 1e4, E2 = 2e4, eta = 1e3 }");
  const std::string mesh = "mesh = \"ellipsoid.off\"\npoint = [0, 0, 10]\nunit = 1e-3";
  const std::string map = "height_map = \"rough_surface.csv\"\ncell = [15.625e-6, 15.625e-6]\nperiodic = true";
  const struct {
    std::string name, gentle, deep;
  } laws[] = {{"ball", stamp("radius = 0.02", "normal_force = 1e-4"), stamp("radius = 0.02", "normal_force = 5")},
              {"adhesion", stamp("radius = 0.02", "normal_force = 1e-4") + "[adhesion]\nwork = 1e-6\n",
               stamp("radius = 0.02", "normal_force = 5") + "[adhesion]\nwork = 1e-6\n"},
              {"ellipse", stamp("radii = [0.02, 0.03]", "normal_force = 1e-4"),
               stamp("radii = [0.02, 0.03]", "normal_force = 5")},
              {"cone", stamp("stamp = \"cone\"\nslope = 0.01"), stamp("stamp = \"cone\"\nslope = 0.3")},
              {"punch", stamp("stamp = \"flat_punch\"\nradius = 0.01", "normal_force = 1e-3"),
               stamp("stamp = \"flat_punch\"\nradius = 0.01", "normal_force = 5")},
              {"creep", creep + "[load]\nnormal_force = [[0, 1e-4]]\ntimes = [1]\n",
               creep + "[load]\nnormal_force = [[0, 5]]\ntimes = [1]\n"},
              {"creep under an approach", creep + "[load]\napproach = [[0, 1e-5]]\ntimes = [1]\n",
               creep + "[load]\napproach = [[0, 5e-3]]\ntimes = [1]\n"},
              {"mesh", stamp(mesh, "normal_force = 1e-4"), stamp(mesh, "normal_force = 100")},
              {"height map", stamp(map, "normal_force = 1e-6"), stamp(map, "normal_force = 1e-2")},
              {"given pressure",
               "[contact]\npatch = \"hertz_disc\"\nradius = 1e-3\nnormal_force = 1e-3\ncontact_modulus = 1e6\n",
               "[contact]\npatch = \"hertz_disc\"\nradius = 1e-3\nnormal_force = 10\ncontact_modulus = 1e6\n"}};
  for (const auto& law : laws) {
    EXPECT_THAT(warnings_of(law.deep), Contains(HasSubstr(small))) << law.name;
    EXPECT_THAT(warnings_of(law.gentle), Each(Not(HasSubstr(small)))) << law.name;
  }
}

TEST(Steepness, LimitAndTabulateWarnOfBodies) {
  const std::string friction = "[friction]\nmu = 0.3\n";
  for (const char* shape : {"radius = 0.02", "radii = [0.02, 0.03]", "stamp = \"cone\"\nslope = 0.3",
                            "stamp = \"flat_punch\"\nradius = 0.01"}) {
    const std::string text = stamp(shape, "normal_force = 5") + friction;
    EXPECT_THAT(limit_scene(text + "[[loads]]\nforce = [0.1, 0]\n").contact.warnings, Contains(HasSubstr(small)))
        << shape;
    const Scene scene = scene_of(text + "[poles]\nlist = [[0, 0]]\n");
    EXPECT_THAT(table_head(scene, "scene.toml"), HasSubstr("# warning: ")) << shape;
  }
  const std::string gentle = stamp("radius = 0.02", "normal_force = 1e-4") + friction;
  EXPECT_TRUE(limit_scene(gentle + "[[loads]]\nforce = [0.1, 0]\n").contact.warnings.empty());
}

// A ball by its principal radii is a ball, whichever way it is turned.
TEST(Steepness, OfAnEllipseIsThatOfTheCircle) {
  const double a = 3e-3;
  const CurvedSurface ball{{0.01, 0.01}, 0.4}, plane{{INFINITY, INFINITY}, 0};
  const auto steep = Steepness::of_ellipse(ball, plane, contact::RelativeRadii::of(0.01, 0.01), 0.9, a, a);
  EXPECT_NEAR(steep.ratio(), 0.3, 1e-15);
  // A cylinder that fits its channel: only its own slope tells, a half-width b across its radius.
  const CurvedSurface cylinder{{INFINITY, 0.01}, 0.7}, channel{{INFINITY, -0.0101}, 0.7};
  const auto fit = Steepness::of_ellipse(cylinder, channel, contact::RelativeRadii::of(1.01, 1e3), 0.7, 1, 5e-3);
  EXPECT_NEAR(fit.ratio(), 0.5, 1e-12);
  EXPECT_EQ(fit.text(), "slope at the edge = 0.5 of body A");
  // Along its axis a cylinder has no slope.
  const auto along = Steepness::of_ellipse(cylinder, plane, contact::RelativeRadii::of(0.01, 1e3), 0.7, 1, 1e-4);
  EXPECT_NEAR(along.ratio(), 0.01, 1e-12);
}

TEST(Steepness, OfHertzsPressureIsThatOfItsCircle) {
  const auto circle = contact::HertzCircle::under_force(2, 0.01, 1e6);
  EXPECT_NEAR(Steepness::of_pressure(circle.peak_pressure, 1e6).ratio() / (circle.radius / 0.01), 1, 1e-14);
  EXPECT_NEAR(Steepness::of_stamp(circle.radius, circle.approach).ratio() / (circle.radius / 0.01), 1, 1e-14);
}

}  // namespace
}  // namespace patchgrip::cli
