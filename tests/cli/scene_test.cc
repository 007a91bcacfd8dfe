#include <patchgrip/cli/scene/scene.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include <patchgrip/cli/scene/scene_error.h>

#include "scenes.h"
#include "scratch_folder.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;

using test::good_bodies;
using test::good_disc;
using test::good_polygon;
using test::scene_of;
using test::with;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct BadScene {
  std::string name;
  std::string text;
  std::size_t line;
  std::string message;  // part of what the user reads
};

std::ostream& operator<<(std::ostream& out, const BadScene& scene) { return out << scene.name; }

std::string disc(std::string_view from, std::string_view to) { return with(good_disc, from, to); }
std::string bodies(std::string_view from, std::string_view to) { return with(good_bodies, from, to); }
std::string polygon(std::string_view from, std::string_view to) { return with(good_polygon, from, to); }
std::string poles(std::string_view to) { return with(good_disc, "list = [[0.001, 0.002], [0, 0]]", to); }

const std::vector<BadScene>& bad_scenes() {
  static const std::vector<BadScene> scenes{
      // numbers
      {"NegativeRadius", disc("0.005", "-0.005"), 3, "contact.radius = -0.005: a radius in m, from 1e-60 to 1e+60"},
      {"ZeroRadius", disc("0.005", "0"), 3, "contact.radius = 0: a radius in m"},
      {"NanRadius", disc("0.005", "nan"), 3, "contact.radius = nan: a radius in m"},
      {"InfiniteRadius", disc("0.005", "inf"), 3, "contact.radius = inf: a radius in m"},
      {"MinusInfiniteForce", disc("= 10", "= -inf"), 4, "contact.normal_force = -inf: a force in N"},
      {"OverflowingRadius", disc("0.005", "1e999"), 3, "radius = 1e999: 1e999 is beyond the range of a double"},
      {"UnderflowingRadius", disc("0.005", "1e-999"), 3, "radius = 1e-999: 1e-999 is beyond the range of a double"},
      {"UnderflowingPole", disc("0.001", "1e-400"), 8, "1e-400 is beyond the range of a double"},
      {"OverflowingInteger", disc("= 10", "= 99999999999999999999"), 4, "not representable in 64 bits"},
      {"HugeRadius", disc("0.005", "1e61"), 3, "contact.radius = 1e61: a radius in m, from 1e-60 to 1e+60"},
      {"TinyRadius", disc("0.005", "1e-61"), 3, "contact.radius = 1e-61: a radius in m"},
      {"TinyPole", disc("0.001", "1e-300"), 8,
       "poles.list[0] = 1e-300: a coordinate in m, of size from 1e-60 to 1e+60, or 0"},
      {"NegativeForce", disc("= 10", "= -10"), 4, "contact.normal_force = -10: a force in N"},
      {"NegativeMu", disc("0.5", "-0.5"), 6,
       "friction.mu = -0.5: a coefficient of friction, from 1e-60 to 1e+60, or 0"},
      {"NanPole", disc("0.001", "nan"), 8, "poles.list[0] = nan: a coordinate in m"},
      // types
      {"TextForNumber", disc("0.005", "\"5 mm\""), 3, "contact.radius = \"5 mm\": a radius in m"},
      {"ListForNumber", disc("0.005", "[0.005]"), 3, "contact.radius = [0.005]: a radius in m"},
      {"EmptyListForNumber", disc("0.005", "[]"), 3, "contact.radius = []: a radius in m"},
      {"TruthForNumber", disc("0.005", "true"), 3, "contact.radius = true: a radius in m"},
      {"DateForNumber", disc("0.005", "2020-01-01"), 3, "contact.radius = 2020-01-01: a radius in m"},
      {"TableForNumber", disc("0.005", "{ value = 1 }"), 3, "contact.radius = { value = 1 }: a radius in m"},
      {"NumberForText", disc("\"hertz_disc\"", "1"), 2, "contact.patch = 1: a text in quotes"},
      {"NumberForTable", "friction = 1\n" + disc("[friction]\nmu = 0.5\n", ""), 1, "friction = 1: a table"},
      {"TablesForTable", with(good_disc, "[friction]", "[[friction]]"), 5, "friction: a table"},
      {"NumberForTitle", "title = 1\n" + good_disc, 1, "title = 1: a text in quotes"},
      {"TitleOfTwoLines", "title = \"a\\nb\"\n" + good_disc, 1, "title = \"a\\nb\": a text on one line"},
      // keys
      {"MisspeltKey", disc("normal_force", "normal_forse"), 4,
       "contact.normal_forse = 10: unknown key; did you mean 'normal_force'?"},
      {"SwappedLetters", disc("mu =", "um ="), 6, "friction.um = 0.5: unknown key; did you mean 'mu'?"},
      {"MisspeltTable", disc("[friction]", "[fricton]"), 5, "fricton: unknown key; did you mean 'friction'?"},
      {"FarOffKey", disc("mu =", "temperature ="), 6,
       "friction.temperature = 0.5: unknown key; known are 'mu', 'mu_static'"},
      {"MisspeltPatch", disc("hertz_disc", "herz_disc"), 2,
       "contact.patch = \"herz_disc\": unknown name; did you mean 'hertz_disc'?"},
      {"DuplicateKey", disc("radius = 0.005", "radius = 0.005\nradius = 0.006"), 4, "cannot redefine existing"},
      {"DuplicateTable", good_disc + "[contact]\n", 9, "cannot redefine existing table 'contact'"},
      {"MissingContact", "[friction]\nmu = 1\n", 1, "contact: missing"},
      {"MissingFriction", disc("[friction]\nmu = 0.5\n", ""), 1, "friction: missing"},
      {"MissingPoles", with(good_disc, "[poles]\nlist = [[0.001, 0.002], [0, 0]]\n", ""), 1, "poles: missing"},
      {"MissingRadius", disc("radius = 0.005\n", ""), 1, "contact.radius: missing: a radius in m"},
      {"MissingForce", disc("normal_force = 10\n", ""), 1, "contact.normal_force: missing: a force in N"},
      {"MissingPatch", disc("patch = \"hertz_disc\"\n", ""), 1, "contact: needs 'patch'"},
      {"EmptyFile", "", 1, "contact: missing"},
      {"CommentOnly", "# nothing\n", 1, "contact: missing"},
      // patches
      {"KeyOfAnotherPatch", disc("radius", "sides = [1, 1]\nradius"), 3,
       "contact.sides = [1, 1]: not used by a hertz_disc, which takes 'radius'"},
      {"ExponentMissing", disc("hertz_disc", "power_disc"), 1, "contact.exponent: missing: the exponent n"},
      {"ExponentTooLow", disc("\"hertz_disc\"", "\"power_disc\"\nexponent = -0.5"), 3,
       "contact.exponent = -0.5: the exponent n"},
      {"AlphaNegative", disc("\"hertz_disc\"", "\"xydas_kao_disc\"\nalpha = -2"), 3,
       "contact.alpha = -2: the exponent alpha"},
      {"UnknownModel", disc("radius", "model = \"exakt\"\nradius"), 3,
       "contact.model = \"exakt\": unknown name; did you mean 'exact'?"},
      {"ModelOfRing", disc("\"hertz_disc\"", "\"ring\"\nmodel = \"exact\""), 3,
       "contact.model = \"exact\": not used by a ring"},
      {"ThreeSides", disc("\"hertz_disc\"\nradius = 0.005", "\"rectangle\"\nsides = [1, 2, 3]"), 3,
       "contact.sides = [1, 2, 3]: two lengths in m"},
      {"NegativeSide", disc("\"hertz_disc\"\nradius = 0.005", "\"rectangle\"\nsides = [1, -2]"), 3,
       "contact.sides = -2: a length in m"},
      {"LengthMissing", disc("\"hertz_disc\"\nradius = 0.005", "\"line\""), 1,
       "contact.length: missing: a length in m"},
      {"LengthNegative", disc("\"hertz_disc\"\nradius = 0.005", "\"line\"\nlength = -2"), 3,
       "contact.length = -2: a length in m"},
      {"LengthOfADisc", disc("radius", "length = 1\nradius"), 3, "contact.length = 1: not used by a hertz_disc"},
      {"CentreOfOneNumber", disc("radius", "centre = [1]\nradius"), 3, "contact.centre = [1]: a point [x, y] in m"},
      {"CentreOfPolygon", polygon("normal_force", "centre = [0, 0]\nnormal_force"), 5,
       "contact.centre = [0, 0]: not used by a polygon"},
      {"TwoVertices", polygon("[[0, 0], [3, 0], [3, 3], [0, 3]]", "[[0, 0], [3, 0]]"), 3, "at least 3 points"},
      {"VertexOfThree", polygon("[3, 0]", "[3, 0, 1]"), 3, "contact.vertices[1] = [3, 0, 1]: a point [x, y] in m"},
      {"FlatPolygon", polygon("[[0, 0], [3, 0], [3, 3], [0, 3]]", "[[0, 0], [1, 0], [2, 0]]"), 3,
       "contact.vertices = "},
      {"BowTie", polygon("[3, 3], [0, 3]", "[0, 3], [3, 3]"), 3, "contact.vertices = "},
      {"HoleOutside", polygon("[2, 2]]]", "[5, 5]]]"), 3, "contact.vertices = "},
      {"HolesNotNested", polygon("[[[1, 1], [2, 1], [2, 2]]]", "[[1, 1], [2, 1], [2, 2]]"), 4,
       "contact.holes[0][0] = 1: a point [x, y] in m"},
      // bodies
      {"OneBody", bodies("[[contact.bodies]]\nplane = true\nmaterial = \"glass\"\n", ""), 3,
       "contact.bodies: two bodies, each under [[contact.bodies]], not 1"},
      {"BodiesNotTables", disc("patch = \"hertz_disc\"\nradius = 0.005", "bodies = [1, 2]"), 2,
       "contact.bodies = [1, 2]: tables"},
      {"PatchAndBodies", bodies("normal_force", "patch = \"ring\"\nnormal_force"), 2,
       "contact.patch = \"ring\": not used beside 'bodies'"},
      {"NegativeBodyRadius", bodies("radius = 0.01", "radius = -0.01"), 4,
       "contact.bodies[0].radius = -0.01: a radius in m ('concave = true' for a hollow)"},
      {"BodyWithoutShape", bodies("radius = 0.01\n", ""), 3, "contact.bodies[0]: needs 'radius'"},
      {"PlaneWithRadius", bodies("plane = true", "plane = true\nradius = 1"), 8,
       "contact.bodies[1].radius = 1: not used by a plane"},
      {"PlaneAsText", bodies("plane = true", "plane = \"yes\""), 7, "contact.bodies[1].plane = \"yes\": true or false"},
      {"TwoPlanes", bodies("radius = 0.01", "plane = true"), 3, "contact.bodies: relative_radius"},
      {"HollowTooSmall", bodies("plane = true", "radius = 0.009\nconcave = true"), 3,
       "contact.bodies: relative_radius"},
      {"TwoRigidBodies", with(bodies("material = \"rubber\"", "rigid = true"), "material = \"glass\"", "rigid = true"),
       3, "contact.bodies: both bodies are rigid"},
      {"StampWithAKink", bodies("radius = 0.01", "stamp = \"flat_end\"\nend_radius = 1e-3\nslope = 0.1"), 3,
       "a stamp with a flat end or kinks is pressed, but not rubbed"},
      {"StampsOnBallsAreNotRubbed",
       with(bodies("radius = 0.01", "stamp = \"cone\"\nslope = 0.1"), "plane = true", "radius = 1"), 3,
       "contact.bodies: a stamp presses on a plane"},
      {"CreepIsNotRubbed", bodies("material = \"rubber\"", "maxwell = { E1 = 1e6, eta = 1e6 }\npoisson_ratio = 0.5"), 3,
       "friction acts between elastic bodies"},
      {"LoadOverTime", bodies("[friction]", "[load]\nnormal_force = [[0, 1]]\ntimes = [1]\n[friction]"), 9,
       "load: not used by 'tabulate'"},
      {"MisspeltMaterial", bodies("rubber", "ruber"), 5,
       "contact.bodies[0].material = \"ruber\": unknown material; did you mean 'rubber'?"},
      {"MaterialIsAPath", bodies("rubber", "../materials/rubber"), 5, "unknown material"},
      {"MaterialAndModulus", bodies("material = \"rubber\"", "material = \"rubber\"\nyoungs_modulus = 1e6"), 5,
       "give one of 'material'"},
      {"ModulusWithoutPoisson", bodies("material = \"rubber\"", "youngs_modulus = 1e6"), 3,
       "contact.bodies[0].poisson_ratio: missing: a Poisson ratio"},
      {"PoissonAboveHalf", bodies("material = \"rubber\"", "youngs_modulus = 1e6\npoisson_ratio = 0.5000001"), 6,
       "contact.bodies[0].poisson_ratio = 0.5000001: a Poisson ratio, above -1 to 0.5"},
      {"PoissonMinusOne", bodies("material = \"rubber\"", "youngs_modulus = 1e6\npoisson_ratio = -1"), 6,
       "contact.bodies[0].poisson_ratio = -1: a Poisson ratio"},
      {"BodyWithoutMaterial", bodies("material = \"rubber\"\n", ""), 3, "contact.bodies[0]: give one of 'material'"},
      {"UnknownKeyOfBody", bodies("plane = true", "plain = true"), 7,
       "contact.bodies[1].plain = true: unknown key; did you mean 'plane'?"},
      // friction
      {"MuAndMuStatic", disc("mu = 0.5", "mu = 0.5\nmu_static = 0.6"), 6, "friction.mu = 0.5: give either 'mu' or"},
      {"StribeckWithoutVelocity", disc("mu = 0.5", "mu_static = 0.5\nmu_kinetic = 0.4"), 5,
       "friction.stribeck_velocity: missing: a speed in m/s"},
      {"ZeroStribeckVelocity", disc("mu = 0.5", "mu_static = 0.5\nmu_kinetic = 0.4\nstribeck_velocity = 0"), 8,
       "friction.stribeck_velocity = 0: a speed"},
      {"StribeckSomewhereElse",
       disc("mu = 0.5", "mu_static = 0.5\nmu_kinetic = 0.4\nstribeck_velocity = 1\nstribeck = \"locally\""), 9,
       "friction.stribeck = \"locally\""},
      {"StribeckOfCoulomb", disc("mu = 0.5", "mu = 0.5\nstribeck = \"local\""), 7,
       "friction.stribeck = \"local\": used with 'mu_static'"},
      {"LocalStribeckOfXydasAndKao",
       with(disc("mu = 0.5", "mu_static = 0.5\nmu_kinetic = 0.4\nstribeck_velocity = 1\nstribeck = \"local\""),
            "\"hertz_disc\"\nradius", "\"xydas_kao_disc\"\nalpha = 3\nradius"),
       10, "friction.stribeck = \"local\": \"mean\" with this contact"},
      {"LocalStribeckOfAStamp",
       with(bodies("mu = 0.8", "mu_static = 0.5\nmu_kinetic = 0.4\nstribeck_velocity = 1\nstribeck = \"local\""),
            "radius = 0.01", "stamp = \"cone\"\nslope = 0.1"),
       14, "friction.stribeck = \"local\": \"mean\" with this contact"},
      {"EmptyFriction", disc("mu = 0.5\n", ""), 5, "friction: needs 'mu'"},
      {"NegativeViscosity", disc("mu = 0.5", "mu_viscous = -1"), 6, "friction.mu_viscous = -1: a viscous coefficient"},
      // poles
      {"EmptyPoles", poles(""), 7, "poles: needs one or several of 'grid'"},
      {"EmptyPoleList", poles("list = []"), 8, "poles.list = []: at least one point"},
      {"PoleOfThree", poles("list = [[1, 2, 3]]"), 8, "poles.list[0] = [1, 2, 3]: a point [x, y] in m"},
      {"PoleOfText", poles("list = [\"origin\"]"), 8, "poles.list[0] = \"origin\": a point [x, y] in m"},
      {"GridWithoutY", poles("grid = { x = [0] }"), 8, "poles.grid.y: missing"},
      {"CountMissing", poles("grid = { x = { from = 0, to = 1 }, y = 0 }"), 8,
       "poles.grid.x.count: missing: a whole number from 2"},
      {"CountOfOne", poles("grid = { x = { from = 0, to = 1, count = 1 }, y = 0 }"), 8,
       "poles.grid.x.count = 1: a whole number from 2"},
      {"CountNegative", poles("grid = { x = { from = 0, to = 1, count = -5 }, y = 0 }"), 8,
       "poles.grid.x.count = -5: a whole number"},
      {"CountFractional", poles("grid = { x = { from = 0, to = 1, count = 2.5 }, y = 0 }"), 8,
       "poles.grid.x.count = 2.5: a whole number"},
      {"CountHuge", poles("grid = { x = { from = 0, to = 1, count = 100000001 }, y = 0 }"), 8,
       "a whole number from 2 to 100000000"},
      {"TooManyRows",
       poles("grid = { x = { from = 0, to = 1, count = 20000 }, y = { from = 0, to = 1, count = 20000 } }"), 8,
       "that makes 400000000 rows, but a table may have at most 100000000"},
      {"TooManyRowsBySpin",
       poles("spin = [1, -1]\nray = { angle = 0, distance = { from = 0, to = 1, count = 60000000 } }"), 9,
       "that makes 120000000 rows"},
      {"EmptyRange", poles("grid = { x = { from = 1, to = 1, count = 5 }, y = 0 }"), 8,
       "poles.grid.x.to = 1: an end other than 'from'"},
      {"LogFromZero", poles("ray = { angle = 0, distance = { from = 0, to = 1, count = 5, spacing = \"log\" } }"), 8,
       "poles.ray.distance.spacing = \"log\": \"log\" needs ends of the same sign"},
      {"UnknownSpacing", poles("ray = { angle = 0, distance = { from = 0, to = 1, count = 5, spacing = \"lin\" } }"), 8,
       "unknown name"},
      {"NegativeDistance", poles("ray = { angle = 0, distance = [1, -1] }"), 8,
       "poles.ray.distance[1] = -1: a distance in m"},
      {"RayWithoutDirection", poles("ray = { distance = [1, 2] }"), 8, "poles.ray: needs either 'angle'"},
      {"RayWithAngleAndDirection", poles("ray = { angle = 0, direction = [1, 0], distance = 1 }"), 8,
       "poles.ray: needs either 'angle'"},
      {"ZeroDirection", poles("ray = { direction = [0, 0], distance = 1 }"), 8,
       "poles.ray.direction = [0, 0]: a vector"},
      {"EmptyDirection", poles("translation = { direction = [] }"), 8, "poles.translation.direction = []: a vector"},
      {"SpinOfTwo", poles("spin = 2\nlist = [[0, 0]]"), 8,
       "poles.spin = 2: 1 (counterclockwise), -1 (clockwise) or both"},
      {"SpinOfZero", poles("spin = 0\nlist = [[0, 0]]"), 8, "poles.spin = 0: 1 (counterclockwise)"},
      {"SpinTwice", poles("spin = [1, 1]\nlist = [[0, 0]]"), 8, "poles.spin = [1, 1]: 1 (counterclockwise)"},
      {"SpinOfReal", poles("spin = 1.0\nlist = [[0, 0]]"), 8, "poles.spin = 1.0: 1 (counterclockwise)"},
      {"SpinOfTranslation", poles("spin = 1\ntranslation = { angle = 0 }"), 8, "poles.spin = 1: only used with"},
      {"SpeedOfRotation", poles("speed = 1\nlist = [[0, 0]]"), 8, "poles.speed = 1: only used with 'translation'"},
      {"NegativeAngularSpeed", poles("angular_speed = -1\nlist = [[0, 0]]"), 8,
       "poles.angular_speed = -1: an angular speed in rad/s"},
      {"ZeroSpeed", poles("speed = 0\ntranslation = { angle = 0 }"), 8, "poles.speed = 0: a speed in m/s"},
      {"HugeAngle", poles("translation = { angle = 1e6 }"), 8, "poles.translation.angle = 1e6: an angle in rad"},
      // text that is not TOML
      {"NotToml", "this is no scene\n", 1, "this is no scene: "},
      {"BinaryFile",
       std::string("\x7f"
                   "ELF\x02\x01\x00\x00",
                   8),
       1, "\\x7fELF"},
      {"NulCharacter", std::string("a = \"\0\"", 7), 1, "\\x00"},
      {"BrokenUtf8", disc("hertz_disc", "hertz\xff\xfe"), 2, "invalid utf-8"},
      {"BrokenUtf8InComment", "# \xc3\x28\n" + good_disc, 1, "invalid utf-8"},
      {"TruncatedString", disc("\"hertz_disc\"", "\"hertz"), 2, "Error while parsing"},
      {"TruncatedList", disc("[0, 0]]", "[0,"), 8, "Error while parsing"},
      {"MissingValue", disc("0.005", ""), 3, "Error while parsing"},
      {"OpenHeader", "[+\n", 1, "Error while parsing"},
      {"DeepList", "a = " + std::string(100'000, '['), 1, "maximum nested value depth"},
      {"DeepDottedKey",
       [] {
         std::string key = "a";
         for (int i = 0; i < 100'000; ++i) key += ".a";
         return key + " = 1";
       }(),
       1, "a key may have at most 16 dots"},
      {"DeepKeyBehindAString",
       [] {
         std::string key = "s = { t = \"\"\"x\"\"\"\", u.a";
         for (int i = 0; i < 100'000; ++i) key += " . a";
         return key + " = 1 }";
       }(),
       1, "a key may have at most 16 dots"},
  };
  return scenes;
}

class BadScenes : public ::testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, AreRefusedWithLineKeyValueAndWhatIsAllowed) {
  const BadScene& scene = GetParam();
  try {
    scene_of(scene.text);
    FAIL() << "accepted:\n" << scene.text.substr(0, 500);
  } catch (const SceneError& error) {
    EXPECT_EQ(error.line(), scene.line) << error.what();
    EXPECT_THAT(error.what(), StartsWith("scene.toml:" + std::to_string(scene.line) + ": "));
    EXPECT_THAT(error.what(), HasSubstr(scene.message));
    EXPECT_LT(std::string(error.what()).size(), 700U) << "too long to read";
  }
}

INSTANTIATE_TEST_SUITE_P(Scene, BadScenes, ::testing::ValuesIn(bad_scenes()),
                         [](const auto& scene) { return scene.param.name; });

TEST(Scene, WholeNumbersStandForRealOnes) {
  const Scene scene = scene_of(good_disc);
  EXPECT_EQ(scene.contact.normal_force, 10.0);
  EXPECT_EQ(std::get<friction::HertzDisc>(scene.contact.patch).radius(), 0.005);
  EXPECT_EQ(scene.law.mu_kinetic, 0.5);
  EXPECT_EQ(scene.motions.size(), 2U);
}

TEST(Scene, BodiesGiveTheHertzRadius) {
  const Scene scene = scene_of(good_bodies);
  const double compliance = (1 - 0.49 * 0.49) / 50e6 + (1 - 0.25 * 0.25) / 70e9;
  const double radius = std::cbrt(0.75 * 5.0 * 0.01 * compliance);
  EXPECT_NEAR(std::get<friction::HertzDisc>(scene.contact.patch).radius(), radius, 1e-15 * radius);
  EXPECT_GT(scene.contact.radius_error, 0);
  EXPECT_EQ(scene_of(good_disc).contact.radius_error, 0);
}

double hertz_radius(const std::string& text) {
  return std::get<friction::HertzDisc>(scene_of(text).contact.patch).radius();
}

TEST(Scene, AHollowAroundTheBallWidensTheContact) {
  const double ratio =
      hertz_radius(bodies("plane = true", "radius = 0.02\nconcave = true")) / hertz_radius(good_bodies);
  EXPECT_NEAR(ratio, std::cbrt(2.0), 1e-15);
}

TEST(Scene, AMaterialIsTheSameAsItsNumbers) {
  EXPECT_EQ(hertz_radius(good_bodies),
            hertz_radius(bodies("material = \"rubber\"", "youngs_modulus = 50e6\npoisson_ratio = 0.49")));
}

TEST(Scene, ARigidBodyDoesNotYield) {
  EXPECT_LT(hertz_radius(bodies("material = \"glass\"", "rigid = true")), hertz_radius(good_bodies));
}

TEST(Scene, AParaboloidAsAStampRubsLikeTheBall) {
  const Scene ball = scene_of(good_bodies);
  const Scene stamp = scene_of(bodies("radius = 0.01", "stamp = \"power\"\ncoefficient = 50\nexponent = 2"));
  const auto gradient = [](const Scene& scene, const friction::Twist& v) {
    return std::visit([&](const auto& patch) { return patch.gradient(v); }, scene.contact.patch);
  };
  EXPECT_TRUE(std::holds_alternative<friction::StampDisc>(stamp.contact.patch));
  for (const double x : {1e-5, 5e-4, 2e-3, 1e-2}) {
    const friction::Twist v = friction::twist_about({x, 0}, 1);
    const auto a = gradient(ball, v), b = gradient(stamp, v);
    EXPECT_NEAR(a.fy / b.fy, 1, 1e-14);
    EXPECT_NEAR(a.m / b.m, 1, 1e-14);
  }
}

TEST(Scene, AFlatPunchHasItsOwnRadius) {
  const Scene scene = scene_of(bodies("radius = 0.01", "stamp = \"flat_punch\"\nradius = 0.01"));
  EXPECT_EQ(std::get<friction::FlatPunchDisc>(scene.contact.patch).radius(), 0.01);
  EXPECT_EQ(scene.contact.radius_error, 0);
}

TEST(Scene, ThePolynomialModelIsAnotherPatch) {
  const Scene scene = scene_of(disc("radius", "model = \"seed_polynomial\"\nradius"));
  EXPECT_TRUE(std::holds_alternative<friction::SeedHertzDisc>(scene.contact.patch));
}

TEST(Scene, StribeckAndViscousFrictionAddUp) {
  const Scene scene =
      scene_of(disc("mu = 0.5", "mu_static = 0.6\nmu_kinetic = 0.4\nstribeck_velocity = 0.05\nmu_viscous = 2"));
  EXPECT_EQ(scene.law.mu_static, 0.6);
  EXPECT_EQ(scene.law.mu_kinetic, 0.4);
  EXPECT_EQ(scene.law.stribeck_velocity, 0.05);
  EXPECT_EQ(scene.law.mu_viscous, 2);
}

TEST(Scene, ViscousFrictionStandsAlone) {
  const Scene scene = scene_of(disc("mu = 0.5", "mu_viscous = 2"));
  EXPECT_EQ(scene.law.mu_kinetic, 0);
  EXPECT_EQ(scene.law.mu_viscous, 2);
}

TEST(Scene, ByteOrderMarkWindowsLinesAndMissingFinalNewlineAreFine) {
  std::string text = "\xef\xbb\xbf";
  for (const char c : good_disc) text += c == '\n' ? "\r\n" : std::string(1, c);
  text.resize(text.size() - 2);
  EXPECT_EQ(scene_of(text).motions.size(), 2U);
}

TEST(Scene, EverySceneInTheRepositoryLoads) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(test::data_folder / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    EXPECT_FALSE(load_scene(entry.path()).title.empty()) << entry.path();
  }
  EXPECT_GE(scenes, 16);
}

TEST(Scene, TheReadmeKnowsEverySceneInTheRepository) {
  std::ifstream readme(test::data_folder / "scenes" / "README.md");
  const std::string text{std::istreambuf_iterator<char>(readme), {}};
  for (const auto& entry : fs::directory_iterator(test::data_folder / "scenes")) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".toml" || name.starts_with("discs_")) continue;
    EXPECT_THAT(text, HasSubstr("`" + name + "`"));
  }
}

class SceneFile : public test::ScratchFolder {
 protected:
  static std::string refusal(const fs::path& file) {
    try {
      load_scene(file);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "accepted";
  }
};

TEST_F(SceneFile, AMissingFileIsAnError) {
  EXPECT_THAT(refusal(folder_ / "no.toml"), HasSubstr("no.toml: cannot be read: No such file or directory"));
}

TEST_F(SceneFile, AFolderIsAnError) { EXPECT_THAT(refusal(folder_), HasSubstr("is a directory, not a TOML file")); }

TEST_F(SceneFile, AnUnreadableFileIsAnError) {
  std::ofstream(folder_ / "secret.toml") << good_disc;
  fs::permissions(folder_ / "secret.toml", fs::perms::none);
  // No permission stops root: the test runs for every other user.
  if (::geteuid() == 0) GTEST_SKIP() << "root reads everything";
  EXPECT_THAT(refusal(folder_ / "secret.toml"), HasSubstr("cannot be read: Permission denied"));
}

TEST_F(SceneFile, AnEndlessFileIsAnError) {
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("/dev/zero: is larger than 16 MiB"));
}

TEST_F(SceneFile, ATooLargeFileIsAnError) {
  std::ofstream(folder_ / "large.toml") << "title = \"" << std::string(17U << 20U, 'x') << "\"\n";
  EXPECT_THAT(refusal(folder_ / "large.toml"), HasSubstr("is larger than 16 MiB"));
}

TEST_F(SceneFile, ControlCharactersInAFileNameDoNotReachTheTerminal) {
  EXPECT_THAT(refusal(folder_ / "no\x1b[2J.toml"), HasSubstr("no\\x1b[2J.toml"));
}

}  // namespace
}  // namespace patchgrip::cli
