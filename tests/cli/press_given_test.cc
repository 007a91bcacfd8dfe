// Given pressures, fingertips and the zone of stick in press: the errors against fifty digits.
#include <patchgrip/cli/press/pressed.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <boost/math/special_functions/gamma.hpp>

#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/contact/fingertip/xydas_kao.h>
#include <patchgrip/contact/stick_radius.h>
#include <patchgrip/tests/support/cases.h>

#include "press_bounds.h"

namespace patchgrip::cli {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(PressGiven, GivenPressureOfXydasAndKaoFromTheMiddleToTheRim) {
  for (const double alpha : {0.5, 0.8, 1., 1.8, 2., 7., 50.}) {
    const double a = 0.007;
    const double force = 3;
    const PressScene s = press_scene(fmt::format(
        "[contact]\npatch = \"xydas_kao_disc\"\nradius = {}\nalpha = {}\nnormal_force = {}\ncontact_modulus = 66666.0\n"
        "[profile]\ndistance = {{ from = 0, to = {}, count = 14 }}\n",
        a, alpha, force, a));
    const Table table = surface_table(s, press(s));
    const Exact step = 1 / Exact(alpha);
    const Exact peak = Exact(force) / (pi * Exact(a) * Exact(a)) * boost::math::tgamma(Exact(1 + 3 * step)) /
                       (boost::math::tgamma(Exact(1 + step)) * boost::math::tgamma(Exact(1 + 2 * step)));
    for (const auto& row : table.rows) {
      const Exact ratio = Exact(row[column(table, "x_m")]) / Exact(a);
      const Exact level = 1 - pow(ratio, Exact(alpha));
      expect_within(row[column(table, "pressure_Pa")], row[column(table, "pressure_error_Pa")],
                    level > 0 ? Exact(peak * pow(level, step)) : Exact(0), fmt::format("alpha = {}", alpha));
    }
  }
}

std::string measured(double force, const char* points, double confidence = 0.95) {
  return fmt::format("[contact]\nnormal_force = {}\n[contact.fingertip]\nmeasured = {}\nconfidence = {}\n", force,
                     points, confidence);
}

// Of a law with a scatter of 2 %, the numbers that follow from the fit hold their errors as often as they say.
TEST(PressGiven, MeasuredFingertipCarriesTheScatterOfItsFit) {
  std::mt19937_64 engine(41);
  std::normal_distribution<double> noise(0, 0.02);
  const int experiments = std::max(1000, patchgrip::testing::cases(1000));
  const auto truth = [](double force) { return 0.004 * std::pow(force, 0.28); };
  int radius_held = 0, peak_held = 0, pressure_held = 0;
  for (int i = 0; i < experiments; ++i) {
    std::string points;
    for (const double force : {0.1, 0.4, 1., 3., 8.}) {
      points +=
          fmt::format("{}[{}, {:.17g}]", points.empty() ? "[" : ", ", force, truth(force) * std::exp(noise(engine)));
    }
    const double force = patchgrip::testing::log_uniform(engine, 0.05, 16);
    const Pressed pressed = press(press_scene(measured(force, (points + "]").c_str())));
    const auto exact = contact::XydasKaoPressure::of(force, truth(force), 2);
    const auto holds = [&](const Result& r, double value) { return std::fabs(r.value - value) <= r.error; };
    radius_held += holds(result(pressed.answer.main, "contact_radius"), exact.contact_radius);
    peak_held += holds(result(pressed.answer.main, "peak_pressure"), exact.peak_pressure);
    const double r = patchgrip::testing::uniform(engine, 0, 1.1) * exact.contact_radius;
    const Estimate p = pressed.surface(r, 0).pressure;
    pressure_held += std::fabs(p.value - exact.pressure(r)) <= p.error;
  }
  // 0.95 but for one in 1e4 of such tests: 4 standard deviations.
  EXPECT_GE(radius_held, 0.95 * experiments - 4 * std::sqrt(0.0475 * experiments));
  EXPECT_LE(radius_held, 0.99 * experiments);
  EXPECT_GE(peak_held, radius_held);
  EXPECT_GE(pressure_held, 0.95 * experiments - 4 * std::sqrt(0.0475 * experiments));
}

TEST(PressGiven, MeasuredFingertipWarnsBeyondItsMeasurements) {
  const char* points = "[[0.2, 3.1e-3], [0.5, 4e-3], [1, 4.9e-3], [2, 6.1e-3], [8, 9e-3]]";
  const auto warnings = [&](double force, const char* of) {
    return press(press_scene(measured(force, of))).answer.warnings;
  };
  EXPECT_TRUE(warnings(15, points).empty());
  EXPECT_TRUE(warnings(0.11, points).empty());
  EXPECT_THAT(warnings(200, points), ElementsAre(HasSubstr("outside of the measured 0.2 .. 8 N by a factor of 25")));
  EXPECT_THAT(warnings(0.02, points), ElementsAre(HasSubstr("by a factor of 10")));
  EXPECT_THAT(warnings(2, "[[1, 4], [2, 5], [3, 5.5]]"), ElementsAre(HasSubstr("radii are in m")));
}

TEST(PressGiven, FlatPunchPressureIsInfiniteAtItsEdge) {
  const Pressed pressed = press(press_scene(
      "[contact]\npatch = \"flat_punch_disc\"\nradius = 0.005\nnormal_force = 2\ncontact_modulus = 66666.0\n"));
  EXPECT_EQ(pressed.surface(0.005, 0).pressure.value, infinity);
  EXPECT_EQ(pressed.surface(0.005, 0).pressure.error, infinity);
  for (int k = 1; k < 49; ++k) {
    const double r = 0.005 * (1 - std::ldexp(1., -k));
    const SurfacePoint point = pressed.surface(r, 0);
    expect_within(point.pressure.value, point.pressure.error,
                  2 / (2 * pi * Exact(0.005) * sqrt(Exact(Exact(0.005) * 0.005 - Exact(r) * r))), fmt::format("{}", k));
  }
  EXPECT_EQ(pressed.surface(0.0051, 0).pressure.value, 0);
}

TEST(PressGiven, WinklerNextToItsLargestForce) {
  const double R = 0.01;
  const double bed = 5e4;
  const auto force = [&](const Exact& delta) -> Exact {
    const Exact h = R - delta;
    return 2 * pi * Exact(bed) * (h * delta - h * h * log(Exact(R / h)));
  };
  Exact lo = 0.6 * R, hi = 0.9 * R;
  for (int i = 0; i < 150; ++i) {  // F' = 0
    const Exact mid = (lo + hi) / 2;
    (2 * (R - mid) * log(Exact(R / (R - mid))) > mid ? lo : hi) = mid;
  }
  const Exact deepest = lo;
  const auto text = [&](double F) {
    return fmt::format("[contact]\nnormal_force = {}\n[contact.fingertip]\nradius = {}\nbed_modulus = {}\n", F, R, bed);
  };
  const double most = static_cast<double>(force(deepest));
  EXPECT_THROW(press(press_scene(text(most * (1 + 1e-14)))), SceneError);
  for (const double share : {1e-12, 1e-3, 0.5, 0.9, 1 - 1e-4, 1 - 1e-8, 1 - 1e-12, 1 - 1e-14}) {
    const double F = most * share;
    Exact low = 0, high = deepest;
    for (int i = 0; i < 200; ++i) {
      const Exact mid = (low + high) / 2;
      (force(mid) < F ? low : high) = mid;
    }
    const LawAnswer answer = press(press_scene(text(F))).answer.main;
    const std::string what = fmt::format("1 - F/F_max = {}", 1 - share);
    expect_within(answer, "approach", low, what);
    expect_within(answer, "contact_radius", sqrt(Exact(low * (2 * R - low))), what);
    const Exact g = (R - low) / R;
    expect_within(answer, "peak_pressure", g > 0.5 ? Exact(bed * g * (1 - g)) : Exact(bed) / 4, what);
    EXPECT_EQ(result(answer, "normal_force").error, 0);
  }
}

TEST(PressGiven, FingertipByItsRadiusTellsTheErrorOfTheForce) {
  const LawAnswer answer = press(press_scene("[contact]\ncontact_radius = 7e-3\n[contact.fingertip]\ncoefficient = "
                                             "4.1e-3\nexponent = 0.13\nalpha = 1.8\n"))
                               .answer.main;
  EXPECT_EQ(result(answer, "contact_radius").value, 7e-3);
  EXPECT_EQ(result(answer, "contact_radius").error, 0);
  EXPECT_GT(result(answer, "normal_force").error, 0);
  expect_within(answer, "normal_force", pow(Exact(Exact(7e-3) / 4.1e-3), Exact(1 / Exact(0.13))), "power law");
}

TEST(PressGiven, StickOfNearlySimilarBodies) {
  const auto text = [](double E1, double nu1, double E2, double nu2, double mu) {
    return fmt::format(
        "[contact]\nnormal_force = 1\n[[contact.bodies]]\nradius = 0.01\nyoungs_modulus = {}\npoisson_ratio = "
        "{}\n[[contact.bodies]]\nplane = true\nyoungs_modulus = {}\npoisson_ratio = {}\n[friction]\nmu = {}\n",
        E1, nu1, E2, nu2, mu);
  };
  const double E = 3.7e6;
  for (const double apart : {0x1p-50, 3 * 0x1p-50, 0x1p-40, 0x1p-20, 0.3}) {
    for (const double nu : {0.31, 0.43}) {
      for (const double chi : {0.1, 1., 5.}) {
        const double E2 = E * (1 + apart);
        const Exact first = (1 - Exact(nu) * nu) / E, second = (1 - Exact(nu) * nu) / E2;
        const Exact factor = (1 - 2 * Exact(nu)) * (1 + Exact(nu));
        const Exact beta = abs(Exact((factor / E2 - factor / E) / (2 * (first + second))));
        const double mu = static_cast<double>(beta / chi);
        const LawAnswer answer = press(press_scene(text(E, nu, E2, nu, mu))).answer.main;
        // The library's ratio is good to two units for a double, and chi itself to half a unit.
        const double exact_chi = static_cast<double>(beta / mu);
        const auto s = contact::StickRatio::of(exact_chi);
        const std::string what = fmt::format("apart {} nu {} chi {}", apart, nu, chi);
        expect_within(answer, "dundurs_beta", beta, what);
        expect_within(answer, "stick_radius_ratio", s.stick, what);
        expect_within(answer, "one_minus_stick_radius_ratio", s.slip, what);
      }
    }
  }
}

}  // namespace
}  // namespace patchgrip::cli
