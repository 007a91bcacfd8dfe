// What `patchgrip grasp` refuses, with file, line, key and reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include <patchgrip/cli/scene/scene_error.h>

#include "bad_scene.h"
#include "grasp_scenes.h"

namespace patchgrip::cli {
namespace {

using test::BadScene;
using test::expect_refused;
using test::good_grasp;
using test::grasp_scene;
using test::with;

class BadGrasp : public ::testing::TestWithParam<BadScene> {};

TEST_P(BadGrasp, IsRefusedWithLineAndReason) {
  expect_refused(GetParam(), [](const std::string& text) { return grasp_scene(text); });
}

std::string contact(const std::string& from, const std::string& to) { return with(good_grasp, from, to); }
std::string more(const std::string& text) { return good_grasp + text; }

const std::string worst = "[question]\nask = \"worst_grip\"\n";

INSTANTIATE_TEST_SUITE_P(
    Scenes, BadGrasp,
    ::testing::Values(
        BadScene{"no contacts", "[[loads]]\nforce = [0, 0, 1]\n", 1, "contacts: missing"},
        BadScene{"no load", good_grasp.substr(good_grasp.find("[[contacts]]")), 1,
                 "loads: missing: 'least_grip' needs a load"},
        BadScene{"a table of another question", more("[friction]\nmu = 1\n"), 19, "not used by 'grasp'"},
        BadScene{"no normal", contact("normal = [1, 0, 0]\n", ""), 5, "contacts[0].normal: missing"},
        BadScene{"normal 0", contact("normal = [1, 0, 0]", "normal = [0, 0, 0]"), 7, "not 0"},
        BadScene{"tangent along the normal", contact("tangent = [0, 1, 0]\npatch", "tangent = [2, 0, 0]\npatch"), 8,
                 "contacts[0].tangent"},
        BadScene{"two numbers", contact("position = [0.03, 0, 0]", "position = [0.03, 0]"), 6,
                 "a place [x, y, z] in m"},
        BadScene{"negative mu", contact("mu = 0.5\n[[contacts]]", "mu = -0.5\n[[contacts]]"), 11,
                 "contacts[0].mu = -0.5"},
        BadScene{"no model", contact("patch = \"hertz_disc\"\nradius = 0.005\n", ""), 5, "needs one of 'model'"},
        BadScene{"unknown model", contact("soft_elliptic", "soft_eliptic"), 16, "soft_elliptic"},
        BadScene{"a point with a moment", contact("soft_elliptic", "point"), 17, "not used by a point contact"},
        BadScene{"a point load as a patch", contact("\"hertz_disc\"\nradius = 0.005", "\"point\""), 9,
                 "contacts[0].patch"},
        BadScene{"limit 0", contact("radius = 0.005\n", "radius = 0.005\nlimit = 0\n"), 11, "contacts[0].limit"},
        BadScene{"near without a mesh", contact("position = [0.03, 0, 0]\nnormal = [1, 0, 0]", "near = [0, 0, 0]"), 6,
                 "give its 'mesh' in [object]"},
        BadScene{"unknown key", contact("mu = 0.5\n[[contacts]]", "mu = 0.5\nlimt = 3\n[[contacts]]"), 12, "limit"},
        BadScene{"an empty load", more("[[loads]]\nat = [0, 0, 0]\n"), 19, "needs 'force' or 'moment'"},
        BadScene{"a load that is no vector", contact("force = [0, 0, -4.905]", "force = 3"), 2,
                 "a force [x, y, z] in N"},
        BadScene{"unknown question", more("[question]\nask = \"least_gripp\"\n"), 20, "least_grip"},
        BadScene{"limits are needed", more("[question]\nask = \"load_factor\"\n"), 5, "needs a 'limit'"},
        BadScene{"growing without bodies", more("[question]\nask = \"growing_grip\"\n"), 5,
                 "asked of contacts between 'bodies'"},
        BadScene{"length 0", more("[question]\nlength = 0\n"), 20, "question.length = 0"},
        BadScene{"a family of two", more("[family]\nturn = [0]\nmu = [0.1]\n"), 21, "a family has one parameter"},
        BadScene{"a family of none", more("[family]\naxis = [1, 0, 0]\n"), 19, "needs 'turn' or 'offset'"},
        BadScene{"a family of another question", more("[question]\nask = \"distance\"\n[family]\nmu = [0.1]\n"), 21,
                 "not used with another question"},
        BadScene{"an axis without a turn", more("[family]\nmu = [0.1]\naxis = [1, 0, 0]\n"), 21,
                 "used with 'turn' and 'offset'"},
        BadScene{"a disturbance of another question", more("[disturbance]\nforce = 1\n"), 19,
                 "disturbance: used with 'worst_grip' and 'worst_load_factor'"},
        BadScene{"a disturbance of none", more(worst + "[disturbance]\n"), 21, "needs 'force', 'moment' or 'axes'"},
        BadScene{"a disturbance of size 0", more(worst + "[disturbance]\nforce = 0\n"), 22, "disturbance.force = 0"},
        BadScene{"a disturbance somewhere", more(worst + "[disturbance]\nmoment = 1\nat = [0, 0, 0]\n"), 23,
                 "it needs 'force'"},
        BadScene{"axes and a force", more(worst + "[disturbance]\naxes = [[0, 0, 1, 0, 0, 0]]\nforce = 1\n"), 23,
                 "'axes' say all of an ellipsoid"},
        BadScene{"no axes", more(worst + "[disturbance]\naxes = []\n"), 22, "1 to 6 semi-axes"},
        BadScene{"an axis of three numbers", more(worst + "[disturbance]\naxes = [[0, 0, 1]]\n"), 22,
                 "1 to 6 semi-axes"},
        BadScene{"a worst factor without limits", more("[question]\nask = \"worst_load_factor\"\n"), 5,
                 "needs a 'limit'"},
        BadScene{"a worst load of none", good_grasp.substr(good_grasp.find("[[contacts]]")) + worst, 1,
                 "'worst_grip' needs loads"},
        BadScene{"gravity without mass", more("[object]\ngravity = [0, 0, -9.81]\n"), 20, "used with 'mass'"},
        BadScene{"mass 0", more("[object]\nmass = 0\n"), 20, "object.mass = 0"},
        BadScene{"a turn without inertia", more("[object]\nmass = 1\n[carried]\nturn_rate = [0, 0, 1]\n"), 19,
                 "object.inertia: missing"},
        BadScene{"carried without an object", more("[carried]\nturn_rate = [0, 0, 1]\n"), 19, "needs [object]"}));

TEST(GraspQuestion, OnTheCommandLineHasToBeKnown) {
  EXPECT_NO_THROW(grasp_scene(good_grasp, "distance"));
  try {
    grasp_scene(good_grasp, "distanse");
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("distance"));
  }
}

}  // namespace
}  // namespace patchgrip::cli
