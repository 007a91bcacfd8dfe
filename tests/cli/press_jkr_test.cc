// JKR in press, next to its turning points and its rim: the errors against fifty digits.
#include <patchgrip/cli/press/pressed.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "press_bounds.h"

namespace patchgrip::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

using namespace test;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string adhesive(const std::string& load) {
  return "[contact]\n" + load +
         "\n[[contact.bodies]]\nradius = 10e-3\nyoungs_modulus = 50e3\npoisson_ratio = 0.49\n[[contact.bodies]]\n"
         "plane = true\nmaterial = \"glass\"\n[adhesion]\nwork = 0.096\n";
}

struct ExactJkr {
  explicit ExactJkr(const LawAnswer& answer)
      : R(result(answer, "relative_radius").value), E(result(answer, "contact_modulus").value) {}

  Exact radius_of_force(double force) const {
    const Exact s = Exact(force) + 3 * pi * w * R;
    const Exact q2 = 3 * pi * w * R * (2 * Exact(force) + 3 * pi * w * R);
    return cbrt(Exact(3 * R / (4 * E) * (s + sqrt(q2))));
  }
  Exact radius_of_approach(double approach) const {
    const Exact L = cbrt(Exact(pi * w * R * R / E));
    const Exact g = 3 + 4 * R * Exact(approach) / (L * L);
    Exact t = 1 + sqrt(sqrt(g));
    for (int i = 0; i < 400; ++i) t -= (t * t * (6 + t * (4 + t)) - g) / (4 * t * (3 + t * (3 + t)));
    return L * (1 + t) * (1 + t) / 2;
  }
  void expect(const LawAnswer& answer, const Exact& a, std::string_view given, double load) const {
    const std::string what = fmt::format("{} = {}", given, load);
    const Exact y = sqrt(Exact(2 * pi * w * R * R / (E * a * a * a)));
    const auto computed = [&](std::string_view name, const Exact& exact) {
      if (name != given) return expect_within(answer, name, exact, what);
      EXPECT_EQ(result(answer, name).value, load);
      EXPECT_EQ(result(answer, name).error, 0);
    };
    computed("contact_radius", a);
    computed("normal_force", 4 * E * a * a * a / (3 * R) - sqrt(Exact(8 * pi * w * E * a * a * a)));
    computed("approach", a * a / R - sqrt(Exact(2 * pi * a * w / E)));
    if (has(answer, "stiffness")) computed("stiffness", 2 * E * a * (4 - 3 * y) / (4 - y));
  }

  Exact R, E, w = 0.096;
};

TEST(PressJkr, JkrNextToItsTurningPoints) {
  const LawAnswer some = press(press_scene(adhesive("normal_force = 1e-3"))).answer.main;
  const ExactJkr exact(some);
  const auto given = [](const char* name, double value) { return fmt::format("{} = {}", name, value); };
  std::vector<double> steps{0};
  for (int k = 2; k < 52; k += 5) steps.push_back(std::ldexp(1., -k));
  const double off_force = result(some, "pull_off_force").value;
  const double off_approach = result(some, "pull_off_held_approach").value;
  int with_stiffness = 0;
  for (const double step : steps) {
    for (const double force : {off_force * (1 - step), -4.523893421169302e-3, -off_force * step}) {
      if (2 * Exact(force) + 3 * pi * exact.w * exact.R < 0) continue;  // the limit itself, rounded
      const LawAnswer answer = press(press_scene(adhesive(given("normal_force", force)))).answer.main;
      exact.expect(answer, exact.radius_of_force(force), "normal_force", force);
    }
    for (const double depth : {off_approach * (1 - step), -4.458614072887510e-05, 1e-4 * step}) {
      const Exact L = cbrt(Exact(pi * exact.w * exact.R * exact.R / exact.E));
      if (3 * L * L + 4 * exact.R * Exact(depth) <= 0) continue;
      const LawAnswer answer = press(press_scene(adhesive(given("approach", depth)))).answer.main;
      exact.expect(answer, exact.radius_of_approach(depth), "approach", depth);
      with_stiffness += has(answer, "stiffness");
    }
    for (const double a : {8.0189988345108e-4 * (1 + step), 3.85513254e-4 * (1 + step), 1e-2 * step + 1e-5}) {
      const LawAnswer answer = press(press_scene(adhesive(given("contact_radius", a)))).answer.main;
      exact.expect(answer, Exact(a), "contact_radius", a);
      with_stiffness += has(answer, "stiffness");
    }
  }
  EXPECT_GT(with_stiffness, static_cast<int>(5 * steps.size()));
}

TEST(PressJkr, JkrSurfaceNextToItsRim) {
  const double a = 8e-4;
  const PressScene s = press_scene(adhesive("contact_radius = 8e-4"));
  const Pressed pressed = press(s);
  const ExactJkr exact(pressed.answer.main);
  const SurfacePoint rim = pressed.surface(a, 0);
  EXPECT_EQ(rim.pressure.value, -infinity);
  EXPECT_EQ(rim.pressure.error, infinity);
  for (const double angle : {0., 0.3, 1.1, 2.9}) {
    for (int k = 1; k < 50; ++k) {
      const double x = a * (1 - std::ldexp(1., -k)) * std::cos(angle);
      const double y = a * (1 - std::ldexp(1., -k)) * std::sin(angle);
      const SurfacePoint point = pressed.surface(x, y);
      const Exact chord = sqrt(Exact(Exact(a) * a - Exact(x) * x - Exact(y) * y));
      const Exact p = exact.E / pi * (2 * chord / exact.R - sqrt(Exact(2 * pi * a * exact.w / exact.E)) / chord);
      expect_within(point.pressure.value, point.pressure.error, p, fmt::format("k = {}", k));
    }
  }
}

TEST(PressJkr, JkrDisplacementAroundTheRim) {
  for (const char* load : {"contact_radius = 8e-4", "normal_force = -4.52e-3", "approach = -4.4586e-05"}) {
    const Pressed pressed = press(press_scene(adhesive(load)));
    const LawAnswer& answer = pressed.answer.main;
    const ExactJkr exact(answer);
    const std::string_view given = std::string_view(load).substr(0, std::string_view(load).find(' '));
    const Exact a = given == "contact_radius" ? Exact(result(answer, given).value)
                    : given == "approach"     ? exact.radius_of_approach(result(answer, given).value)
                                              : exact.radius_of_force(result(answer, given).value);
    const Exact pulled = sqrt(Exact(2 * pi * a * exact.w / exact.E));
    const Exact approach = a * a / exact.R - pulled;
    for (int k = -3; k < 60; ++k) {
      for (const double side : {-1., 1.}) {
        const double r = result(answer, "contact_radius").value * (1 + side * std::ldexp(1., -k));
        if (r < 0) continue;
        const SurfacePoint point = pressed.surface(r, 0);
        const Exact height = Exact(r) * r / (2 * exact.R);
        Exact u = approach - height;
        if (r > a) {
          const Exact chord = sqrt(Exact(Exact(r) * r - a * a));
          u = ((2 * a * a - Exact(r) * r) * asin(Exact(a / r)) + a * chord) / (pi * exact.R) -
              2 / pi * pulled * asin(Exact(a / r));
          const Exact gap = height - approach + u;
          EXPECT_LE(static_cast<double>(abs(Exact(point.gap.value) - gap)), point.gap.error) << load << " k = " << k;
        }
        expect_within(point.displacement.value, point.displacement.error, u, fmt::format("{} k = {}", load, k));
      }
    }
  }
}

TEST(PressJkr, SweepBeyondThePullOffLeavesCellsEmpty) {
  const PressScene scene = press_scene(adhesive("") + "[sweep]\nnormal_force = [-1, -5e-3, -4e-3, 0, 1]\n");
  std::vector<std::string> warnings;
  const Table table = sweep_table(scene, warnings);
  ASSERT_EQ(table.rows.size(), 5U);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    ASSERT_EQ(table.rows[i].size(), table.columns.size());
    EXPECT_EQ(std::isnan(table.rows[i][column(table, "contact_radius_m")]), i < 2);
    EXPECT_EQ(table.rows[i][0], scene.sweep->values[i]);
  }
  ASSERT_GE(warnings.size(), 2U);
  EXPECT_THAT(warnings[0], HasSubstr("no answer at 2 of 5 values; the first: "));
  EXPECT_THAT(warnings[0], HasSubstr("sweep.normal_force[0] = -1: the contact pulls off at "));
  EXPECT_THAT(warnings[1],
              StartsWith("sweep.normal_force[2] = -0.004 to sweep.normal_force[4] = 1, at 3 values: how far"));
}

}  // namespace
}  // namespace patchgrip::cli
