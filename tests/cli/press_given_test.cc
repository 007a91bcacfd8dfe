// Given pressures, fingertips and the zone of stick in press: the errors against fifty digits.
#include <patchgrip/cli/press/pressed.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <boost/math/special_functions/gamma.hpp>

#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/contact/stick_radius.h>

#include "press_bounds.h"

namespace patchgrip::cli {
namespace {

using namespace test;
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
