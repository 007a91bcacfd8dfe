// What `patchgrip limit` refuses, with file, line, key and reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <patchgrip/cli/scene/scene_error.h>

#include "bad_scene.h"
#include "limit_scenes.h"

namespace patchgrip::cli {
namespace {

using test::BadScene;
using test::expect_refused;
using test::good_limit;
using test::limit_scene;
using test::with;

class BadLimit : public ::testing::TestWithParam<BadScene> {};

TEST_P(BadLimit, IsRefusedWithLineAndReason) {
  expect_refused(GetParam(), [](const std::string& text) { return limit_scene(text); });
}

const std::string parts = R"([[contact.parts]]
patch = "uniform_disc"
radius = 0.005
normal_force = 2
mu = 0.5
[[contact.parts]]
patch = "rectangle"
sides = [0.01, 0.02]
centre = [0.03, 0]
angle = 0.3
normal_force = 3
mu = 0.4
[[loads]]
moment = 0.01
)";

std::string load(const std::string& keys) { return with(good_limit, "force = [3, 0.5]\nmoment = 0.002", keys); }

std::string points(const std::string& keys, const std::string& vertices = "[[-1, -1], [1, -1], [0, 1]]") {
  return "[contact]\npatch = \"pressure_points\"\n" + keys + "\nvertices = " + vertices + "\nnormal_force = 1\n";
}

std::vector<BadScene> bad_scenes() {
  return {
      {"NoContact", "[friction]\nmu = 1\n", 1, "contact: missing"},
      {"NothingTouches", "[contact]\nnormal_force = 1\n", 1, "contact: needs 'patch'"},
      {"Adhesion", good_limit + "[adhesion]\nwork = 1\n", 10, "adhesion: not used by 'limit'"},
      {"LoadOverTime", good_limit + "[load]\ntimes = 1\n", 10, "load: not used by 'limit'"},
      {"MisspeltLoads", with(good_limit, "[[loads]]", "[[laods]]"), 7, "unknown key; did you mean 'loads'?"},
      {"LoadsAsOneTable", with(good_limit, "[[loads]]", "[loads]"), 7, "loads: tables, each headed [[loads]]"},
      {"EmptyLoad", load(""), 7, "loads[0]: needs 'force' or 'moment'"},
      {"ForceOfThree", load("force = [1, 2, 3]"), 8, "loads[0].force = [1, 2, 3]: a force [x, y] in N"},
      {"ForceAsText", load("force = \"big\""), 8, "loads[0].force = \"big\": a force [x, y] in N"},
      {"ForceNotFinite", load("force = [nan, 0]"), 8, "loads[0].force[0] = nan: a component of a force in N"},
      {"ForceTooLarge", load("force = [1e70, 0]"), 8, "loads[0].force[0] = 1e70: a component of a force in N"},
      {"SizeNegative", load("force = { size = -1, angle = 0 }"), 8, "loads[0].force.size = -1: the size of a force"},
      {"AngleMissing", load("force = { size = 1 }"), 8, "loads[0].force.angle: missing"},
      {"AtWithoutForce", load("moment = 1\nat = [0, 0]"), 9, "loads[0].at = [0, 0]: where the force acts"},
      {"PolarBesideForce", load("force = [1, 0]\npolar = 1"), 8, "loads[0].force = [1, 0]: not used beside 'azimuth'"},
      {"PolarBeyondPi", load("polar = 4"), 8, "loads[0].polar = 4: an angle from the axis of moments"},
      {"TooManyLoads", load("polar = { from = 0, to = 1, count = 2000 }\nazimuth = { from = 0, to = 1, count = 2000 }"),
       7, "loads[0]: that makes 4000000 loads, but a scene may have at most 1000000"},
      {"LengthOfALine", with(with(load("polar = 1"), "hertz_disc", "line"), "radius", "length"), 7,
       "loads[0].length: missing: a length in m that makes a force of the moment"},
      {"FewMeridians", good_limit + "[surface]\nmeridians = 3\n", 11,
       "surface.meridians = 3: a whole number from 4 to 4000"},
      {"HalfAParallel", good_limit + "[surface]\nparallels = 7.5\n", 11, "surface.parallels = 7.5: a whole number"},
      {"ElevationBeyondUpright", good_limit + "[surface]\nview = { elevation = 2 }\n", 11,
       "surface.view.elevation = 2: an elevation in rad"},
      {"ManyMeridians", good_limit + "[surface]\nmeridians = 4001\n", 11,
       "surface.meridians = 4001: a whole number from 4 to 4000"},
      {"MeridiansOfText", good_limit + "[surface]\nmeridians = \"many\"\n", 11,
       "surface.meridians = \"many\": a whole number from 4 to 4000"},
      {"FewParallels", good_limit + "[surface]\nparallels = -48\n", 11,
       "surface.parallels = -48: a whole number from 4 to 4000"},
      {"UnknownInSurface", good_limit + "[surface]\nmeridian = 48\n", 11,
       "surface.meridian = 48: unknown key; did you mean 'meridians'?"},
      {"UnknownInView", good_limit + "[surface.view]\nelevatoin = 1\n", 11,
       "surface.view.elevatoin = 1: unknown key; did you mean 'elevation'?"},
      {"AzimuthNotANumber", good_limit + "[surface]\nview = { azimuth = nan }\n", 11,
       "surface.view.azimuth = nan: an angle in rad, of size from"},
      {"SurfaceNotATable", "surface = 3\n" + good_limit, 1, "surface = 3: a table"},
      {"LengthOfNothing", good_limit + "[surface]\nlength = 0\n", 11, "surface.length = 0: a length in m"},
      {"LengthWithoutEnd", good_limit + "[surface]\nlength = inf\n", 11, "surface.length = inf: a length in m"},
      {"NegativeLength", good_limit + "[surface]\nlength = -1\n", 11, "surface.length = -1: a length in m"},
      // contacts
      {"AxesOfADisc", with(good_limit, "radius = 0.005", "radius = 0.005\nsemi_axes = [1, 2]"), 4,
       "contact.semi_axes = [1, 2]: not used by a hertz_disc"},
      {"AxisNegative", with(with(good_limit, "hertz_disc", "hertz_ellipse"), "radius = 0.005", "semi_axes = [1, -2]"),
       3, "contact.semi_axes = -2: a length in m"},
      {"AxesTooUnlike",
       with(with(good_limit, "hertz_disc", "hertz_ellipse"), "radius = 0.005", "semi_axes = [1, 1e-7]"), 3,
       "contact.semi_axes = [1, 1e-7]: "},
      {"AngleOfText", with(good_limit, "radius", "angle = \"30\"\nradius"), 3,
       "contact.angle = \"30\": an angle against the x-axis in rad"},
      {"WinklerFingertip",
       with(good_limit, "patch = \"hertz_disc\"\nradius = 0.005", "fingertip = { radius = 0.02, bed_modulus = 1e5 }"),
       2, "contact.fingertip: a Winkler bed is pressed, but not rubbed"},
      {"FingertipAndRadius",
       with(good_limit, "patch = \"hertz_disc\"", "fingertip = { coefficient = 1, exponent = 0.3 }"), 3,
       "contact.radius = 0.005: not used beside 'fingertip'"},
      {"AngleInDegrees", with(good_limit, "radius", "angle = 45\nradius"), 3,
       "contact.angle = 45: an angle against the x-axis in rad, of size from 1e-60 to 6.2832"},
      {"NoPoints", points(""), 1, "contact.points: missing: this key is needed"},
      {"NoSuchPoints", points("points = \"no.csv\""), 3, "contact.points = \"no.csv\": no such file"},
      {"PointsOfManyColumns", points("points = \"tactile.csv\""), 3,
       "contact.points = \"tactile.csv\": needs 3 columns, x, y and pressure, not 16"},
      {"PointsOutside", points("points = \"pad.csv\""), 3,
       "contact.points = \"pad.csv\": points[0] = [-19.3, -5.5] is not allowed: must lie within the vertices"},
      {"PointsOfNoUnit", points("points = \"pad.csv\"\nunit = 0"), 4,
       "contact.unit = 0: the unit of x and y in the file in m"},
      {"PointsWithoutOutline", "[contact]\npatch = \"pressure_points\"\npoints = \"pad.csv\"\n", 1,
       "contact.vertices: missing: points [[x, y], ...] in m"},
      {"PointsWithACentre", points("points = \"pad.csv\"\ncentre = [0, 0]"), 4,
       "contact.centre = [0, 0]: not used by a pressure_points"},
      {"PointsInALoop", points("points = \"pad.csv\"\nunit = 1e-3", "[[0, 0], [1, 1], [1, 0], [0, 1]]"), 3,
       "contact.points = \"pad.csv\": vertices crosses or touches itself"},
      {"MuOfTheContact", with(good_limit, "radius", "mu = 0.4\nradius"), 3, "contact.mu = 0.4: unknown key"},
      {"PartsAndForce", "[contact]\nnormal_force = 3\n" + parts, 2,
       "contact.normal_force = 3: not used beside 'parts'"},
      {"PartWithoutForce", with(parts, "normal_force = 2\n", ""), 1, "contact.parts[0].normal_force: missing"},
      {"PartOfNoKind", with(parts, "uniform_disc", "uniform_disk"), 2,
       "contact.parts[0].patch = \"uniform_disk\": unknown name; did you mean 'uniform_disc'?"},
      {"PartWithAnothersKey", with(parts, "radius = 0.005", "radius = 0.005\nsides = [1, 1]"), 4,
       "contact.parts[0].sides = [1, 1]: not used by a uniform_disc"},
      {"PartNeedsMu", with(parts, "mu = 0.4\n", ""), 6, "contact.parts[1].mu: missing: needed here"},
      {"PartsOfStribeck",
       with(parts, "mu = 0.4\n", "") + "[friction]\nmu_static = 1\nmu_kinetic = 0.5\nstribeck_velocity = 1\n", 14,
       "friction: parts with their own 'mu' rub by Coulomb's law"},
      {"NoFrictionAtAll", with(with(parts, "mu = 0.5", "mu = 0"), "mu = 0.4", "mu = 0"), 1,
       "contact.parts: parts of which at least one has mu > 0"},
      {"SinglePoint", with(good_limit, "\"hertz_disc\"\nradius = 0.005", "\"point\""), 1,
       "a single point, which holds no moment"},
      {"OnePointThatRubs",
       with(with(with(parts, "uniform_disc", "point"), "radius = 0.005\n", ""), "mu = 0.4", "mu = 0"), 1,
       "a single point, which holds no moment"},
      {"NegativeMu", with(parts, "mu = 0.4", "mu = -0.4"), 12, "contact.parts[1].mu = -0.4: a coefficient of friction"},
      {"PartsNotTables", "[contact]\nparts = [1]\n", 2, "contact.parts = [1]: tables"},
  };
}

INSTANTIATE_TEST_SUITE_P(Limit, BadLimit, ::testing::ValuesIn(bad_scenes()),
                         [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace patchgrip::cli
