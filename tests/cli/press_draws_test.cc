// Errors that press states, drawn at random against fifty digits: adhesion, the fit of a fingertip, the surface around
// an ellipse.
#include <patchgrip/cli/press/pressed.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <patchgrip/contact/adhesion/maugis_curve.h>
#include <patchgrip/contact/ellipse_shape.h>
#include <patchgrip/tests/support/cases.h>

#include "press_bounds.h"

namespace patchgrip::cli {
namespace {

using namespace test;
using contact::MaugisCurve;
using testing::cases;
using testing::log_uniform;
using testing::uniform;

std::string ball(const std::string& load, double radius, double modulus, double nu, const std::string& adhesion) {
  return fmt::format(
      "[contact]\n{}\n[[contact.bodies]]\nradius = {}\nrigid = true\n[[contact.bodies]]\nplane = true\n"
      "youngs_modulus = {}\npoisson_ratio = {}\n[adhesion]\n{}\n",
      load, radius, modulus, nu, adhesion);
}

// R, E*, w of an adhesive ball, and the scales that follow.
struct ExactBall {
  ExactBall(const LawAnswer& answer, double work)
      : R(result(answer, "relative_radius").value),
        E(result(answer, "contact_modulus").value),
        w(work),
        K(4 * E / 3),
        unit(cbrt(Exact(pi * w * R * R / K))) {}

  Exact R, E, w, K;
  Exact unit;  // of a
};

TEST(PressDraws, Dmt) {
  std::mt19937_64 engine(20061101);
  for (int i = 0; i < cases(150); ++i) {
    const double R = log_uniform(engine, 1e-6, 1), modulus = log_uniform(engine, 1e3, 1e11);
    const double work = log_uniform(engine, 1e-3, 10), tension = 2 * M_PI * work * R;
    const double force = i % 3 == 0   ? tension * log_uniform(engine, 1e-6, 1e6)
                         : i % 3 == 1 ? -tension * uniform(engine, 0, 0.7)
                                      : -tension * 0.75 * (1 - log_uniform(engine, 1e-15, 1));
    const std::string load = fmt::format("normal_force = {}", force);
    const Answer answer =
        press(press_scene(ball(load, R, modulus, uniform(engine, 0, 0.5), fmt::format("work = {}", work)))).answer;
    const ExactBall exact(answer.main, work);
    const LawAnswer& dmt = beside(answer, "dmt");
    const Exact pull = 2 * pi * exact.w * exact.R;
    const Exact a = cbrt(Exact((Exact(force) + pull) * exact.R / exact.K));
    const Exact free = cbrt(Exact(pull * exact.R / exact.K));
    expect_within(dmt, "contact_radius", a, load);
    expect_within(dmt, "approach", a * a / exact.R, load);
    expect_within(dmt, "stiffness", 2 * exact.E * a, load);
    expect_within(dmt, "pull_off_force", -pull, load);
    expect_within(dmt, "no_load_radius", free, load);
    expect_within(dmt, "no_load_approach", free * free / exact.R, load);
    const double depth = static_cast<double>(a * a / exact.R);
    if (!(depth > 1e-50)) continue;
    const Answer held =
        press(press_scene(ball(fmt::format("approach = {}", depth), R, modulus, 0.3, fmt::format("work = {}", work))))
            .answer;
    const ExactBall other(held.main, work);
    const Exact b = sqrt(Exact(depth * other.R));
    expect_within(beside(held, "dmt"), "contact_radius", b, load);
    expect_within(beside(held, "dmt"), "normal_force", other.K * b * b * b / other.R - 2 * pi * other.w * other.R,
                  load);
  }
}

// The root of f next to n, by secants.
template <class F>
Exact root_near(const F& f, const Exact& n) {
  Exact before = n, here = n * (1 + Exact(1e-12));
  Exact at_before = f(before), at_here = f(here);
  for (int i = 0; i < 100 && at_here != at_before && at_here != 0; ++i) {
    const Exact next = here - at_here * (here - before) / (at_here - at_before);
    before = here, at_before = at_here;
    here = next, at_here = f(here);
    if (abs(Exact(here / before - 1)) < 1e-45) break;
  }
  return here;
}

TEST(PressDraws, MaugisDugdale) {
  std::mt19937_64 engine(20061102);
  for (int i = 0; i < cases(60); ++i) {
    const double R = log_uniform(engine, 1e-4, 0.1), modulus = log_uniform(engine, 1e4, 1e10);
    const double work = log_uniform(engine, 1e-2, 1), nu = uniform(engine, 0, 0.5);
    const double K = 4 * modulus / (3 * (1 - nu * nu));
    const double stress = log_uniform(engine, 1e-3, 50) * std::cbrt(M_PI * work * K * K / R) / 2;
    const double tension = M_PI * work * R;
    const double force = i % 3 == 0   ? tension * log_uniform(engine, 1e-6, 1e4)
                         : i % 3 == 1 ? tension * uniform(engine, -1.45, 0)
                                      : 0;
    const bool by_radius = i % 3 == 2;
    const std::string load =
        by_radius ? fmt::format("contact_radius = {}", std::cbrt(tension * R / K) * log_uniform(engine, 0.3, 1e3))
                  : fmt::format("normal_force = {}", force);
    const LawAnswer answer =
        press(press_scene(ball(load, R, modulus, nu, fmt::format("work = {}\nstress = {}", work, stress)))).answer.main;
    const ExactBall exact(answer, work);
    const Exact lambda = 2 * Exact(stress) * cbrt(Exact(exact.R / (pi * exact.w * exact.K * exact.K)));
    const MaugisCurve<Exact> curve{lambda};
    const double a = result(answer, "contact_radius").value;
    const Exact start = Exact(result(answer, "outer_radius").value) / a - 1;
    if (start < 1e-6) continue;  // n is lost in c / a
    const Exact load_unit = pi * exact.w * exact.R;
    const Exact n = by_radius ? root_near([&](const Exact& x) { return curve.at(x).A - a / exact.unit; }, start)
                              : root_near([&](const Exact& x) { return curve.at(x).force - force / load_unit; }, start);
    const auto point = curve.at(n);
    const std::string what = fmt::format("{}, lambda = {}", load, static_cast<double>(lambda));
    expect_within(answer, "maugis_parameter", lambda, what);
    if (by_radius) {
      expect_within(answer, "normal_force", point.force * load_unit, what);
    } else {
      EXPECT_EQ(result(answer, "normal_force").value, force) << what;
      expect_within(answer, "contact_radius", point.A * exact.unit, what);
    }
    expect_within(answer, "outer_radius", point.A * exact.unit * (1 + n), what);
    expect_within(answer, "approach", point.approach * exact.unit * exact.unit / exact.R, what);
  }
}

TEST(PressDraws, FitOfAFingertip) {
  std::mt19937_64 engine(20061103);
  for (int i = 0; i < cases(150); ++i) {
    const double lo = log_uniform(engine, 1e-9, 1e6), span = log_uniform(engine, 1.01, 1e3);
    const double c = log_uniform(engine, 1e-6, 1), gamma = uniform(engine, 0.05, 0.34);
    const double scatter = i % 4 == 0 ? 0 : log_uniform(engine, 1e-12, 1e-2) * std::log(span) * gamma;
    std::vector<std::array<double, 2>> points;
    std::string list;
    const int count = 3 + i % 7;
    for (int k = 0; k < count; ++k) {
      const double F = k == 0 ? lo : k == 1 ? lo * span : lo * log_uniform(engine, 1, span);
      points.push_back({F, c * std::pow(F, gamma) * (1 + uniform(engine, -scatter, scatter))});
      list += fmt::format("[{}, {}], ", points.back()[0], points.back()[1]);
    }
    const double force = lo * log_uniform(engine, 0.1, 10 * span);
    const LawAnswer answer =
        press(press_scene(
                  fmt::format("[contact]\nnormal_force = {}\n[contact.fingertip]\nmeasured = [{}]\n", force, list)))
            .answer.main;
    Exact x = 0, y = 0, xx = 0, xy = 0, squares = 0;
    for (const auto& [F, a] : points) x += log(Exact(F)) / count, y += log(Exact(a)) / count;
    for (const auto& [F, a] : points) {
      const Exact dx = log(Exact(F)) - x;
      xx += dx * dx, xy += dx * (log(Exact(a)) - y);
    }
    const Exact slope = xy / xx, log_c = y - slope * x;
    for (const auto& [F, a] : points) {
      const Exact left = log(Exact(a)) - log_c - slope * log(Exact(F));
      squares += left * left;
    }
    const std::string what = fmt::format("points {}", list);
    expect_within(answer, "gamma", slope, what);
    expect_within(answer, "c", exp(log_c), what);
    expect_within(answer, "rms_log", sqrt(Exact(squares / count)), what);
    expect_within(answer, "contact_radius", exp(Exact(log_c + slope * log(Exact(force)))), what);
    const long double student = boost::math::quantile(boost::math::complement(
        boost::math::students_t_distribution<long double>(count - 2), (1 - static_cast<long double>(0.95)) / 2));
    const Exact variance = squares / (count - 2);
    const Exact half = student * sqrt(Exact(variance / xx));
    const Exact factor = exp(Exact(student * sqrt(Exact(variance * (Exact(1) / count + x * x / xx)))));
    expect_within(answer, "gamma_low", slope - half, what);
    expect_within(answer, "gamma_high", slope + half, what);
    expect_within(answer, "c_low", exp(log_c) / factor, what);
    expect_within(answer, "c_high", exp(log_c) * factor, what);
  }
}

TEST(PressDraws, SurfaceAroundAnEllipse) {
  std::mt19937_64 engine(20061104);
  for (int i = 0; i < cases(60); ++i) {
    const double large = log_uniform(engine, 1e-3, 10),
                 ratio = i % 3 == 0 ? 1 - log_uniform(engine, 1e-9, 0.5) : log_uniform(engine, 1e-3, 1);
    const double turn = uniform(engine, -3, 3), force = log_uniform(engine, 1e-3, 1e3);
    const Pressed pressed =
        press(press_scene(stamp(fmt::format("radii = [{}, {}]\ndirection = {}", large, ratio * large, turn),
                                fmt::format("normal_force = {}", force))));
    const LawAnswer& answer = pressed.answer.main;
    const Exact E = result(answer, "contact_modulus").value, F = force;
    const Exact R1 = result(answer, "radius_large").value, R2 = result(answer, "radius_small").value;
    const Exact apart = result(answer, "one_minus_radius_ratio").value;
    const auto shape = contact::EllipseShape<Exact>::of(apart < 0.5 ? Exact(1 - apart) : Exact(R2 / R1),
                                                        apart < 0.5 ? apart : Exact(1 - R2 / R1));
    // a^3 = 3 F D R_large / (pi E*), and p_0 = 3 F / (2 pi a b) (hertz_ellipse.h)
    const Exact a = cbrt(Exact(3 * F * shape.integrals.D * R1 / (pi * E))), b = shape.k * a;
    const Exact p0 = 3 * F / (2 * pi * a * b);
    expect_within(answer, "semi_axis_a", a, "a");
    for (int k = 0; k < 6; ++k) {
      const double reach =
          static_cast<double>(a) * (k % 2 == 0 ? 1 + log_uniform(engine, 1e-9, 1) : log_uniform(engine, 1, 1e3));
      const double at = uniform(engine, -3, 3), px = reach * std::cos(at), py = reach * std::sin(at);
      const Exact x = px * cos(Exact(turn)) + py * sin(Exact(turn)), y = py * cos(Exact(turn)) - px * sin(Exact(turn));
      const Exact x2 = x * x, y2 = y * y, a2 = a * a, b2 = b * b;
      const Exact level = 1 - x2 / a2 - y2 / b2;
      if (level >= 0) continue;
      const Exact P = a2 + b2 - x2 - y2, root = sqrt(Exact(P * P - 4 * a2 * b2 * level));
      const Exact shift = P > 0 ? Exact(-2 * a2 * b2 * level / (P + root)) : Exact((root - P) / 2);
      const Exact A = a2 + shift, B = b2 + shift;
      const Exact potential = boost::math::ellint_rf(shift, B, A) - x2 / 3 * boost::math::ellint_rd(B, shift, A) -
                              y2 / 3 * boost::math::ellint_rd(A, shift, B);
      const SurfacePoint point = pressed.surface(px, py);
      expect_within(point.displacement.value, point.displacement.error, p0 * a * b / E * potential,
                    fmt::format("ratio {} r/a {}", ratio, reach / static_cast<double>(a)));
    }
  }
}

}  // namespace
}  // namespace patchgrip::cli
