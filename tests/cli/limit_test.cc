#include <patchgrip/cli/limit/limit.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <patchgrip/cli/scene/place.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

#include "limit_scenes.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::good_limit;
using test::limit_scene;
using test::with;
using ::testing::HasSubstr;

std::vector<LoadAnswer> answers_of(const LimitScene& scene) { return answer_limit(scene).loads; }

LoadAnswer answer_of(const std::string& text) {
  const auto answers = answers_of(limit_scene(text));
  EXPECT_EQ(answers.size(), 1U);
  return answers.front();
}

double number(const json& node) { return std::stod(node.get<std::string>()); }

json reference() { return json::parse(std::ifstream(test::data_folder / "reference" / "friction.json")); }

TEST(Limit, GaugesAndPolesOfTheReferenceTableAreWithinTheErrorsStated) {
  const json table = reference();
  std::size_t rows = 0;
  const auto expect_row = [&](const json& contact, const json& row) {
    const LoadAnswer answer = answer_of(test::contact_table_of(contact) + test::load_of(row["t"]));
    const LimitScene scene = limit_scene(test::contact_table_of(contact));
    const double gauge = number(row["gauge_N"]) * scene.contact.resistance.value_or(1);
    EXPECT_NEAR(answer.gauge.value, gauge, answer.gauge_error) << contact;
    EXPECT_LE(answer.gauge_error, 2e-12 * gauge) << contact;
    const double x = number(row["pole"][0]), y = number(row["pole"][1]);
    const double size = std::hypot(x, y);
    // The table's poles have 16 digits, older ones the accuracy of their dual check.
    const double noise = row.contains("dual_check_rel") ? 1e-7 : 1e-15;
    EXPECT_LE(std::hypot(answer.slip.pole.x - x, answer.slip.pole.y - y), answer.slip.pole_error + noise * size)
        << contact;
    EXPECT_LE(answer.slip.pole_error, 1e-9 * size) << contact;
    ++rows;
  };
  for (const json& entry : table["gauge"]) {
    for (const json& row : entry["rows"]) expect_row(entry["contact"], row);
  }
  for (const json& entry : table["multi_mu"]) {
    for (const json& row : entry["gauge_rows"]) expect_row(entry["contact"], row);
  }
  EXPECT_GE(rows, 25U);
}

TEST(Limit, StickRadiiOfTheReferenceTable) {
  const json table = reference();
  for (const json& entry : table["stick_radius"]) {
    for (const json& row : entry["rows"]) {
      // The table gives phi and theta to a few digits and rho for these numbers.
      const LoadAnswer answer = answer_of(test::contact_table_of(entry["contact"]) +
                                          fmt::format("[[loads]]\nazimuth = {}\npolar = {}\n",
                                                      row["phi"].get<std::string>(), row["theta"].get<std::string>()));
      EXPECT_NEAR(answer.stick_radius.value, number(row["rho_H"]), answer.stick_radius.error + 4e-16);
      EXPECT_LE(answer.stick_radius.error, 4e-12);
    }
  }
}

// f^2 = (pi^2/48)(1 - q)(2 + q)^2, q^2 = 8 m/pi - 1/2 for a pole within the disc.
TEST(Limit, HertzDiscKnowsItsLimitCurve) {
  for (const double moment : {0.23, 0.3, 0.45, 0.58}) {
    const double q = std::sqrt(8 * moment / std::numbers::pi - 0.5);
    const double force = std::numbers::pi / std::sqrt(48) * std::sqrt(1 - q) * (2 + q);
    const LoadAnswer answer = answer_of(with(with(good_limit, "[3, 0.5]", fmt::format("[{}, 0]", 5 * force)), "0.002",
                                             fmt::format("{}", 5 * 0.005 * moment)));
    EXPECT_NEAR(answer.gauge.value, 5, answer.gauge_error + 8e-15);
    EXPECT_NEAR(answer.margin.value, 1, answer.margin.error + 2e-15);
  }
}

TEST(Limit, VerdictsFollowTheBracket) {
  EXPECT_EQ(answer_of(good_limit).verdict, Verdict::holds);
  EXPECT_EQ(answer_of(with(good_limit, "mu = 0.5", "mu = 0.3")).verdict, Verdict::slips);
  EXPECT_EQ(answer_of(with(good_limit, "mu = 0.5", "mu = 0")).verdict, Verdict::slips);
  // A pure force of mu F_N is on the surface: rounding decides.
  const std::string edge = with(with(good_limit, "[3, 0.5]", "[5, 0]"), "0.002", "0");
  EXPECT_EQ(answer_of(edge).verdict, Verdict::undecided);
  EXPECT_EQ(answer_of(with(edge, "[5, 0]", "[5.000000001, 0]")).verdict, Verdict::slips);
  EXPECT_EQ(answer_of(with(edge, "[5, 0]", "[4.999999999, 0]")).verdict, Verdict::holds);
}

// With the pole on a line of length L, m = (L / 4)(1 - f^2) per unit mu F_N (friction/line_load.h).
TEST(Limit, ALineHoldsAPushAcrossItAndAMoment) {
  const std::string line = with(with(good_limit, "hertz_disc", "line"), "radius = 0.005", "length = 0.02");
  const LoadAnswer answer = answer_of(with(with(line, "[3, 0.5]", "[0, 3]"), "0.002", "0.016"));
  EXPECT_NEAR(answer.gauge.value, 5, answer.gauge_error + 8e-15);
  const LoadAnswer across = answer_of(with(with(line, "[3, 0.5]", "[0, 3]"), "0.002", "0"));
  EXPECT_EQ(across.gauge.status, friction::GaugeStatus::ridge);
  EXPECT_NEAR(across.gauge.value, 3, across.gauge_error + 4e-15);
}

TEST(Limit, StaticFrictionCounts) {
  const std::string stribeck = "mu_static = 0.6\nmu_kinetic = 0.1\nstribeck_velocity = 0.05";
  EXPECT_EQ(answer_of(with(good_limit, "mu = 0.5", stribeck)).verdict, Verdict::holds);
}

TEST(Limit, NoLoadHolds) {
  const LoadAnswer answer = answer_of(with(with(good_limit, "[3, 0.5]", "[0, 0]"), "0.002", "0"));
  EXPECT_EQ(answer.verdict, Verdict::holds);
  EXPECT_EQ(answer.gauge.value, 0);
  EXPECT_TRUE(std::isinf(answer.margin.value));
}

TEST(Limit, WithoutFrictionItTellsWhatIsNeeded) {
  const LimitScene scene = limit_scene(with(good_limit, "[friction]\nmu = 0.5\n", ""));
  const LimitAnswer answer = answer_limit(scene);
  EXPECT_EQ(answer.loads.front().verdict, Verdict::undecided);
  const json told = json::parse(to_json(answer, scene, "scene.toml"));
  const json& load = told["loads"][0];
  EXPECT_FALSE(load.contains("verdict"));
  EXPECT_FALSE(load["results"].contains("margin"));
  const double gauge = load["results"]["gauge"]["value"];
  EXPECT_DOUBLE_EQ(load["results"]["needed_mu"]["value"], gauge / 10);
}

TEST(Limit, AForceActsWhereItIsSaid) {
  const std::string turned = with(good_limit, "moment = 0.002", "moment = 0.001");
  const LoadAnswer at = answer_of(with(turned, "[3, 0.5]", "[3, 0.5]\nat = [0.001, -0.002]"));
  EXPECT_EQ(at.load.m, 0.001 + (0.001 * 0.5 + 0.002 * 3));
}

TEST(Limit, LoadsRunThroughEveryCombination) {
  const LimitScene scene = limit_scene(with(good_limit, "force = [3, 0.5]\nmoment = 0.002",
                                            "force = { size = [1, 2], angle = [0, 1, 2] }\nmoment = [0.001, "
                                            "0.002]\n[[loads]]\nazimuth = [0, 1]\npolar = [0, 1, 2]"));
  ASSERT_EQ(scene.loads.size(), 18U);
  const friction::Wrench t = scene.loads[7];  // angle 1, size 2, moment 0.002
  EXPECT_EQ(t.fx, 2 * std::cos(1));
  EXPECT_EQ(t.fy, 2 * std::sin(1));
  EXPECT_EQ(t.m, 0.002);
  const friction::Wrench d = scene.loads[16];  // phi 1, theta 1
  EXPECT_DOUBLE_EQ(d.fx, std::sin(1) * std::cos(1));
  EXPECT_DOUBLE_EQ(d.m, 0.005 * std::cos(1));
}

// Turning the patch and the load alike changes nothing.
TEST(Limit, ATurnedRectangleIsTheRectangleUnderATurnedLoad) {
  const std::string rectangle = "[contact]\npatch = \"rectangle\"\nsides = [0.04, 0.02]\nnormal_force = 1\n";
  const double angle = 0.7;
  const double c = std::cos(angle), s = std::sin(angle);
  const LoadAnswer straight = answer_of(rectangle + "[[loads]]\nforce = [0.3, 0.4]\nmoment = 0.003\n");
  const LoadAnswer turned =
      answer_of(with(rectangle, "normal_force", "angle = 0.7\nnormal_force") +
                fmt::format("[[loads]]\nforce = [{}, {}]\nmoment = 0.003\n", 0.3 * c - 0.4 * s, 0.3 * s + 0.4 * c));
  EXPECT_NEAR(turned.gauge.value, straight.gauge.value, turned.gauge_error + straight.gauge_error + 1e-15);
  EXPECT_NEAR(turned.slip.pole.x, c * straight.slip.pole.x - s * straight.slip.pole.y, 1e-12);
}

// The gauges of this L with its moment one way and the other differ by 2.6, 2.2 and 0.3 %.
TEST(Limit, AnLShapeTellsLeftFromRight) {
  const LimitScene scene = limit_scene([] {
    std::ifstream in(test::limit_folder / "l_shape.toml");
    return std::string{std::istreambuf_iterator<char>(in), {}};
  }());
  const auto answers = answers_of(scene);
  ASSERT_EQ(answers.size(), 6U);
  const double differences[] = {0.026, 0.022, 0.003};
  for (std::size_t i = 0; i < 3; ++i) {
    const double ratio = answers[2 * i].gauge.value / answers[2 * i + 1].gauge.value;
    EXPECT_NEAR(std::fabs(ratio - 1), differences[i], 6e-4) << i;
  }
}

TEST(Limit, PartsOfOneCoefficientAreOnePatch) {
  const std::string halves =
      "[[contact.parts]]\npatch = \"rectangle\"\nsides = [0.02, 0.02]\ncentre = [-0.01, 0]\nnormal_force = 0.5\n"
      "[[contact.parts]]\npatch = \"rectangle\"\nsides = [0.02, 0.02]\ncentre = [0.01, 0]\nnormal_force = 0.5\n";
  const std::string rest = "[friction]\nmu = 0.9\n[[loads]]\nforce = [0.3, 0.4]\nmoment = 0.003\n";
  const LoadAnswer two = answer_of(halves + rest);
  const LoadAnswer one = answer_of("[contact]\npatch = \"rectangle\"\nsides = [0.04, 0.02]\nnormal_force = 1\n" + rest);
  EXPECT_NEAR(two.gauge.value, one.gauge.value, two.gauge_error + one.gauge_error);
  EXPECT_NEAR(two.margin.value, one.margin.value, two.margin.error + one.margin.error);
  EXPECT_LE(two.margin.error, 4e-12);
}

TEST(Limit, APartWithoutItsOwnCoefficientTakesTheCommonOne) {
  const std::string part = "[[contact.parts]]\npatch = \"uniform_disc\"\nradius = 1\nnormal_force = 2\n";
  const LimitScene scene = limit_scene(part + "mu = 0.1\n" + part + "[friction]\nmu = 0.4\n");
  EXPECT_DOUBLE_EQ(scene.contact.resistance.value(), 2 * 0.1 + 2 * 0.4);
}

// Sums of forces and of products mu_i F_i against 50 digits; in the second scene the parts share one coefficient.
TEST(Limit, SumsOverPartsAreWithinTheirErrors) {
  using patchgrip::testing::Exact;
  std::mt19937_64 engine(20061127);
  int rounded = 0;
  for (const int parts : {2, 3, 10, 100, 1000}) {
    std::string own, common;
    Exact force = 0, resistance = 0;
    for (int i = 0; i < parts; ++i) {
      const double F = patchgrip::testing::log_uniform(engine, 1e-3, 1e3),
                   mu = patchgrip::testing::uniform(engine, 0, 2);
      const std::string part = fmt::format(
          "[[contact.parts]]\npatch = \"ring\"\nradius = 1e-3\ncentre = [{}, 0]\nnormal_force = {}\n", 0.01 * i, F);
      own += part + fmt::format("mu = {}\n", mu);
      common += part;
      force += F;
      resistance += Exact(mu) * F;
    }
    common += "[friction]\nmu = 0.7\n";
    const auto check = [&](const std::vector<Result>& results, const char* name, const Exact& exact) {
      const auto told = std::ranges::find(results, name, &Result::name);
      ASSERT_NE(told, results.end());
      const double off = static_cast<double>(abs(told->value - exact));
      EXPECT_LE(off, told->error) << name;
      EXPECT_LE(told->error, 2.6 * 0x1p-53 * told->value) << name;
      if (off > 0.2 * told->error) ++rounded;
    };
    const auto by_parts = answer_limit(limit_scene(own)).contact,
               by_friction = answer_limit(limit_scene(common)).contact;
    check(by_parts, "normal_force", force);
    check(by_parts, "greatest_force", resistance);
    check(by_friction, "normal_force", force);
    check(by_friction, "greatest_force", Exact(0.7) * force);
  }
  EXPECT_GE(rounded, 5);
  EXPECT_EQ(answer_limit(limit_scene(good_limit)).contact.front().error, 0);  // a number of the scene
}

// What the radius owes to the bodies moves the gauge by no more than is told.
TEST(Limit, TheErrorOfARadiusCounts) {
  const std::string loads = "[[loads]]\nforce = [0.01, 0]\nmoment = 0.002\n";
  const LoadAnswer from_bodies = answer_of(with(test::good_bodies, "[poles]\nlist = [[0.001, 0.002]]\n", loads));
  EXPECT_GE(from_bodies.gauge_error - (from_bodies.gauge.upper - from_bodies.gauge.value),
            7 * 0x1p-53 * from_bodies.gauge.value);
  constexpr double delta = 1e-6;
  const friction::LimitSurface small{friction::HertzDisc::of_radius(1e-3)};
  const friction::LimitSurface large{friction::HertzDisc::of_radius(1e-3 * (1 + delta))};
  for (const double force : {0., 0.1, 1., 10.}) {
    const friction::Wrench load{force, 0.2 * force, 1e-3};
    const LoadAnswer answer = answer_load(small, {.value = 1, .shape_error = delta}, load);
    EXPECT_LE(std::fabs(large.gauge(load).value - answer.gauge.value), answer.gauge_error);
  }
  // A pure moment needs the whole of it.
  const LoadAnswer turn = answer_load(small, {.value = 1, .shape_error = delta}, {0, 0, 1e-3});
  EXPECT_GE(turn.gauge.value - large.gauge({0, 0, 1e-3}).value, 0.99 * turn.gauge_error);
}

// The greatest moment is the margin of any load that is a moment alone.
TEST(Limit, TheGreatestMomentAloneHasTheErrorOfTheGrid) {
  LimitScene scene = read_limit_scene(TomlDocument::read(test::limit_folder / "wavy_cap.toml"),
                                      MaterialLibrary({test::data_folder / "materials"}));
  ASSERT_TRUE(scene.contact.coarse);
  const friction::LimitSurface fine{any_patch(scene.contact)};
  const friction::LimitSurface coarse{placed(*scene.contact.coarse, scene.contact.frame)};
  const LoadAnswer turn = answer_load(fine, coarse, capacity_of(scene), {0, 0, 1});
  const auto results = answer_limit(scene).contact;
  const auto told = std::ranges::find(results, "greatest_moment_alone", &Result::name);
  ASSERT_NE(told, results.end());
  EXPECT_EQ(told->value, turn.margin.value);
  EXPECT_EQ(told->error, turn.margin.error);
  EXPECT_GT(turn.margin.error, 1e-4 * turn.margin.value);
}

TEST(Limit, AFrictionThatNoPartTakesIsTold) {
  const std::string part = "[[contact.parts]]\npatch = \"uniform_disc\"\nradius = 1e-3\nnormal_force = 1\nmu = 0.1\n";
  EXPECT_TRUE(limit_scene(part).contact.warnings.empty());
  EXPECT_THAT(limit_scene(part + "[friction]\nmu = 0.9\n").contact.warnings,
              ::testing::ElementsAre(HasSubstr("[friction] is not used")));
}

TEST(Limit, PolesAreWithinTheirErrors) {
  const friction::LimitSurface exact{friction::HertzDisc::of_radius(1)};
  friction::GaugeSettings settings;
  settings.relative_gap = 1e-4;
  const friction::LimitSurface loose{friction::HertzDisc::of_radius(1), settings};
  int moved = 0;
  for (const double force : {0.01, 0.1, 0.5, 0.9, 3.}) {
    for (const double moment : {0.001, 0.01, 0.3, 0.5, -0.2}) {
      const friction::Wrench load{force, -0.3 * force, moment};
      const LoadAnswer a = answer_load(exact, {}, load);
      const LoadAnswer b = answer_load(loose, {}, load);
      const double apart = std::hypot(a.slip.pole.x - b.slip.pole.x, a.slip.pole.y - b.slip.pole.y);
      EXPECT_LE(apart, a.slip.pole_error + b.slip.pole_error);
      if (apart > 1e-8) ++moved;
    }
  }
  EXPECT_GT(moved, 0);  // the loose one is loose
}

// alpha = 2 is the pressure of Hertz; the law says the radius.
TEST(Limit, AFingertipRubsAsTheDiscOfItsLaw) {
  const double a = 4.04e-3 * std::pow(10, 0.295);
  const LoadAnswer disc = answer_of(with(good_limit, "radius = 0.005", fmt::format("radius = {}", a)));
  const auto tip = [](const std::string& keys) {
    return with(good_limit, "patch = \"hertz_disc\"\nradius = 0.005", "fingertip = { " + keys + " }");
  };
  const std::string points = fmt::format("measured = [[1, 4.04e-3], [10, {}]]", a);
  for (const std::string& keys : {std::string("coefficient = 4.04e-3, exponent = 0.295"), points}) {
    const LoadAnswer answer = answer_of(tip(keys));
    EXPECT_NEAR(answer.gauge.value, disc.gauge.value, answer.gauge_error + disc.gauge_error) << keys;
    EXPECT_LE(answer.gauge_error, 1e-12) << keys;
    EXPECT_GT(answer_of(tip(keys + ", alpha = 4")).gauge.value, 0) << keys;
    EXPECT_LT(answer_of(tip(keys + ", alpha = 4")).gauge.value, disc.gauge.value) << keys;  // more towards the rim
  }
}

class CommittedLimit : public ::testing::TestWithParam<std::string> {};

TEST_P(CommittedLimit, IsAnswered) {
  const LimitScene scene = read_limit_scene(TomlDocument::read(test::limit_folder / (GetParam() + ".toml")),
                                            MaterialLibrary({test::data_folder / "materials"}));
  EXPECT_FALSE(scene.title.empty());
  const LimitAnswer answer = answer_limit(scene);
  ASSERT_GE(answer.loads.size(), 1U);
  for (const LoadAnswer& load : answer.loads) {
    EXPECT_TRUE(std::isfinite(load.gauge.value));
    EXPECT_LE(load.gauge.lower, load.gauge.upper);
    EXPECT_NE(load.verdict, Verdict::undecided);
    EXPECT_NE(load.gauge.status, friction::GaugeStatus::stalled);
  }
  EXPECT_NO_THROW(to_json(answer, scene, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Limit, CommittedLimit, ::testing::ValuesIn(test::committed_limit_scenes()),
                         [](const auto& given) { return given.param; });

TEST(Limit, TheReadmeKnowsEveryScene) {
  std::ifstream readme(test::data_folder / "scenes" / "README.md");
  const std::string text{std::istreambuf_iterator<char>(readme), {}};
  for (const std::string& name : test::committed_limit_scenes()) EXPECT_THAT(text, HasSubstr("`" + name + "`"));
}

}  // namespace
}  // namespace patchgrip::cli
