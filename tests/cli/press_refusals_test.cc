// What press refuses: each time with file, line, key, value and what is allowed.
#include <patchgrip/cli/press/run_press.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/cli/scene/scene_error.h>

#include <patchgrip/tests/support/cases.h>

#include "far_off.h"
#include "press_scenes.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;
using namespace test;
using ::testing::HasSubstr;

struct Bad {
  std::string name;
  std::string text;
  std::string message;
};

class BadPressScene : public ::testing::TestWithParam<Bad> {};

TEST_P(BadPressScene, IsRefusedWithFileLineKeyAndWhatIsAllowed) {
  try {
    answered(press_scene(GetParam().text));
    ADD_FAILURE() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_GE(error.line(), 1U);
    EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
  }
}

std::vector<Bad> bad_scenes() {
  const std::string creep =
      with(stamp("radius = 0.02", ""), "youngs_modulus = 50e3", "poynting_thomson = { E1 = 1e4, E2 = 2e4, eta = 1e3 }");
  const std::string load = "[load]\nnormal_force = [[0, 1]]\ntimes = [1]\n";
  return {
      {"NoLoad", stamp("radius = 0.02", ""), "contact: needs 'normal_force', 'approach' or 'contact_radius'"},
      {"TwoLoads", stamp("radius = 0.02", "normal_force = 1\napproach = 1e-3"),
       "contact.approach = 1e-3: one of 'normal_force', 'approach' and 'contact_radius'"},
      {"NegativeForce", stamp("radius = 0.02", "normal_force = -1"), "contact.normal_force = -1: a force in N, from"},
      {"UnknownStamp", stamp("stamp = \"kone\"\nslope = 1"), "stamp = \"kone\": unknown name; did you mean 'cone'?"},
      {"ConeWithRadius", stamp("stamp = \"cone\"\nslope = 1\nradius = 1"), "radius = 1: not used by a cone"},
      {"ConeWithoutSlope", stamp("stamp = \"cone\""), "slope: missing: a slope"},
      {"FractionOfATerm", stamp("stamp = \"sphere\"\nradius = 1\nterms = 2.5"), "terms = 2.5: a whole number"},
      {"FlatEndOfBoth", stamp("stamp = \"flat_end\"\nend_radius = 1\nradius = 1\nslope = 1"),
       "a flat end goes on with either 'radius' (paraboloid) or 'slope' (cone)"},
      {"FallingPoints", stamp("stamp = \"points\"\npoints = [[0, 0], [1e-3, 1e-4], [2e-3, 0]]"), "is not allowed"},
      {"TwoStamps", with(stamp("stamp = \"cone\"\nslope = 1"), "plane = true", "radius = 1"),
       "bodies: a stamp presses on a plane"},
      {"SphereBeyondItsEquator", stamp("stamp = \"sphere\"\nradius = 1e-3", "contact_radius = 2e-3"),
       "contact_radius = 0.002 is not allowed"},
      {"Saddle", stamp("radii = [0.02, -0.01]"), "is not allowed"},
      {"RadiiOfThree", stamp("radii = [1, 2, 3]"), "two principal radii [R1, R2]"},
      {"RadiusOfAnEllipse", stamp("radii = [0.02, 0.01]", "contact_radius = 1e-3"),
       "contact.contact_radius = 1e-3: an ellipse has two"},
      {"NoSuchMesh", stamp("mesh = \"no.off\"\npoint = [0, 0, 0]"), "no.off"},
      {"NoSuchMap", stamp("height_map = \"no.csv\"\ncell = [1e-3, 1e-3]"), "no.csv\": no such file"},
      {"MapWithoutCells", stamp("height_map = \"rough_surface.csv\""), "cell: missing: two lengths in m"},
      {"MapIsNoGrid", stamp("height_map = \"ellipsoid.off\"\ncell = [1e-3, 1e-3]"), "ellipsoid.off"},
      {"StaticCreep", with(creep, "[contact]\n", "[contact]\nnormal_force = 1\n"),
       "a viscoelastic body needs its load over time"},
      {"LoadTwice", with(creep, "[contact]\n", "[contact]\nnormal_force = 1\n") + load,
       "contact: the load is under [load]"},
      {"TimesBackwards", creep + "[load]\nnormal_force = [[0, 1]]\ntimes = [2, 1]\n",
       "load.times = [2, 1]: times in s"},
      {"PointsBackwards", creep + "[load]\nnormal_force = [[1, 1], [0, 1]]\ntimes = [2]\n",
       "t_1 = 0 is not allowed: must not be less than the time before it"},
      {"TimesBeforeTheLoad", creep + "[load]\nnormal_force = [[1, 1]]\ntimes = [0.5, 2]\n",
       "load.times = [0.5, 2]: times from 1 s on, where the force starts"},
      {"ProfileTimesBeforeTheLoad", creep + "[load]\nnormal_force = [[1, 1]]\ntimes = [2]\n[profile]\ntimes = [0.5]\n",
       "profile.times = [0.5]: time = 0.5 is not allowed"},
      {"LoadWithoutHistory", creep + "[load]\ntimes = [1]\n", "load: needs one of 'normal_force', 'approach', 'sine'"},
      {"NegativeViscosity", with(creep, "eta = 1e3", "eta = -1") + load, "eta = -1: a viscosity in Pa s"},
      {"TwoModels", with(creep, "poisson_ratio", "maxwell = { E1 = 1, eta = 1 }\npoisson_ratio") + load,
       "maxwell: not used beside 'poynting_thomson'"},
      {"CreepWithoutPoisson", with(creep, "poisson_ratio = 0.5", "") + load, "poisson_ratio: missing"},
      {"PullBelowPullOff", stamp("radius = 0.01", "normal_force = -1") + "[adhesion]\nwork = 0.1\n",
       "normal_force = -1: the contact pulls off at -0.00471239 N"},
      {"PullBelowPullOffOfMaugis",
       stamp("radius = 0.01", "normal_force = -1") + "[adhesion]\nwork = 0.1\nstress = 1e3\n",
       ": the contact pulls off at -0.0"},
      {"SurfaceOfMaugis", stamp("radius = 0.01", "normal_force = 0") + "[adhesion]\nwork = 0.1\nstress = 1e3\n",
       "adhesion: maugis_dugdale says nothing about the surface: its table is that of a [sweep]"},
      {"TwoRigidBodies", with(stamp("radius = 0.01"), "youngs_modulus = 50e3\npoisson_ratio = 0.5", "rigid = true"),
       "contact.bodies: both bodies are rigid"},
      {"AdhesionOfAStamp", stamp("stamp = \"cone\"\nslope = 1") + "[adhesion]\nwork = 0.1\n",
       "adhesion: covered between balls, hollows and planes"},
      {"ApproachWithAStressOfAdhesion",
       stamp("radius = 0.01", "approach = 1e-4") + "[adhesion]\nwork = 0.1\nstress = 1e3\n",
       "contact.approach = 1e-4: with a stress of adhesion give normal_force"},
      {"StressOfAdhesionOutOfRange", stamp("radius = 0.01") + "[adhesion]\nwork = 0.1\nstress = 1e30\n",
       "adhesion: maugis_parameter = "},
      {"SweepOffTheProfile", stamp("stamp = \"sphere\"\nradius = 1e-3") + "[sweep]\ncontact_radius = [2e-3, 3e-3]\n",
       "sweep.contact_radius[0] = 0.002: contact_radius = 0.002 is not allowed"},
      {"SweepOfTwo", stamp("radius = 0.01") + "[sweep]\nmu = [1, 2]\napproach = [1e-3]\n",
       "one quantity is swept at a time"},
      {"RatioOfBalls", stamp("radius = 0.01") + "[sweep]\nradii_ratio = [1, 0.5]\n",
       "'radii_ratio' varies the smaller"},
      {"FingertipOfNothing", "[contact]\nnormal_force = 1\n[contact.fingertip]\nalpha = 2\n",
       "contact.fingertip: needs 'coefficient' and 'exponent', 'measured'"},
      {"ApproachOfAFingertip", "[contact]\napproach = 1e-3\n[contact.fingertip]\ncoefficient = 4e-3\nexponent = 0.3\n",
       "contact.approach = 1e-3: the power law says nothing of it"},
      {"PatchWithoutModulus", "[contact]\npatch = \"hertz_disc\"\nradius = 1e-3\nnormal_force = 1\n",
       "contact.contact_modulus: missing"},
      {"PolygonAsPressure",
       "[contact]\npatch = \"rectangle\"\nsides = [1, 1]\nnormal_force = 1\ncontact_modulus = 1e6\n",
       "press makes stamps of round pressures"},
      {"UnknownTable", stamp("radius = 0.01") + "[lode]\n", "lode: unknown key; did you mean 'load'?"},
  };
}

INSTANTIATE_TEST_SUITE_P(Press, BadPressScene, ::testing::ValuesIn(bad_scenes()),
                         [](const auto& given) { return given.param.name; });

class FarOffScene : public ::testing::TestWithParam<std::string> {};

TEST_P(FarOffScene, IsAnsweredOrRefusedAtItsPlace) {
  const MaterialLibrary materials({data_folder / "materials"});
  expect_far_off_numbers_answered_or_refused(
      "press/" + GetParam(), text_of(press_folder / (GetParam() + ".toml")), std::max(1, 70 / testing::cases(10)),
      "contact|load|adhesion|profile|sweep|friction", [&](const std::string& scene, const fs::path& folder) {
        run_press({scene, (folder / "answer.json").string(), (folder / "table.csv").string()}, materials);
      });
}

INSTANTIATE_TEST_SUITE_P(Press, FarOffScene, ::testing::ValuesIn(committed_scenes()),
                         [](const auto& given) { return given.param; });

}  // namespace
}  // namespace patchgrip::cli
