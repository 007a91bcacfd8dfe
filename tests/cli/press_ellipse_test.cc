// Ellipses in press, of two bodies or of a mesh: the errors against fifty digits.
#include <patchgrip/cli/press/pressed.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "press_bounds.h"

namespace patchgrip::cli {
namespace {

using namespace test;

std::string cylinders(double R1, double R2, double first, double second) {
  return fmt::format(
      "[contact]\nnormal_force = 1\n[[contact.bodies]]\ncylinder = {}\ndirection = {}\nmaterial = \"steel\"\n"
      "[[contact.bodies]]\ncylinder = {}\ndirection = {}\nmaterial = \"steel\"\n",
      R1, first, R2, second);
}

TEST(PressEllipse, DirectionOfTheEllipseOfCrossedCylinders) {
  const double quarter = std::acos(0.);
  for (const double apart : {0., 0x1p-52, 1e-13, 1e-7, 0.1}) {
    for (const double turn : {0.3, 1.1, quarter * (1 - 1e-15), quarter * (1 - 1e-12), quarter, quarter + 1e-6}) {
      for (const double first : {0., 0.7, -1.9}) {
        const double second = first + turn;
        const double R2 = 0.01 * (1 + apart);
        const std::string what = fmt::format("apart {} turn {} first {}", apart, turn, first);
        const Pressed pressed = press(press_scene(cylinders(0.01, R2, first, second)));
        const LawAnswer& answer = pressed.answer.main;
        // A cylinder is curved across its direction: d = k1 - k2 is -1/R along it.
        const Exact alpha = Exact(second) - Exact(first);
        const Exact dp = -1 / Exact(0.01), dm = -1 / Exact(R2);
        const Exact cosine = dp + dm * cos(Exact(2 * alpha)), sine = dm * sin(Exact(2 * alpha));
        const Exact D = sqrt(Exact(cosine * cosine + sine * sine));
        const Exact sum = -dp - dm;
        expect_within(answer, "one_minus_radius_ratio", 2 * D / (sum + D), what);
        expect_within(answer, "radius_small", 2 / (sum + D), what);
        // Of the larger curvature, a quarter turn off a; directions are the same by half turns.
        const Exact angle = first + atan2(sine, cosine) / 2 + pi / 2;
        const Result& told = result(answer, "angle_of_a");
        Exact off = Exact(told.value) - angle;
        off -= pi * round(Exact(off / pi));
        EXPECT_LE(static_cast<double>(abs(off)), told.error) << what << ' ' << told.value;

        const Exact a = result(answer, "semi_axis_a").value, b = result(answer, "semi_axis_b").value;
        const Exact p0 = result(answer, "peak_pressure").value;
        for (int k = 0; k < 24; ++k) {
          const double reach = (1 - std::ldexp(1., -2 * k - 1));
          const double c = std::cos(told.value), s = std::sin(told.value);
          const double at_a = static_cast<double>(a) * reach * std::cos(k);
          const double at_b = static_cast<double>(b) * reach * std::sin(k);
          const double x = c * at_a - s * at_b, y = s * at_a + c * at_b;
          const Exact exact_a = (x * cos(angle) + y * sin(angle)) / a, exact_b = (y * cos(angle) - x * sin(angle)) / b;
          const Exact level = 1 - exact_a * exact_a - exact_b * exact_b;
          const SurfacePoint point = pressed.surface(x, y);
          expect_within(point.pressure.value, point.pressure.error, level > 0 ? Exact(p0 * sqrt(level)) : Exact(0),
                        fmt::format("{} k = {}", what, k));
        }
      }
    }
  }
}

TEST(PressEllipse, MeshHasNoPressureOutsideItsZone) {
  const std::string text =
      "[contact]\nnormal_force = 1.0\n[[contact.bodies]]\nmesh = \"ellipsoid.off\"\nunit = 1e-3\npoint = [0, 0, "
      "10]\nmaterial = \"rubber\"\n[[contact.bodies]]\nplane = true\nmaterial = \"glass\"\n";
  const Pressed pressed = press(press_scene(text));
  const Result& a = result(pressed.answer.main, "semi_axis_a");
  const Result& b = result(pressed.answer.main, "semi_axis_b");
  const Result& p0 = result(pressed.answer.main, "peak_pressure");
  const double spread = 1 + 4 * std::max(a.error / a.value, b.error / b.value);
  EXPECT_EQ(pressed.surface(spread * a.value, 0).pressure.error, 0);
  EXPECT_EQ(pressed.surface(0, spread * b.value).pressure.error, 0);
  EXPECT_NEAR(pressed.surface(0, 0).pressure.error, p0.error, 1e-12 * p0.value);
  // Every ellipse within the errors of the answer.
  for (const double da : {-1., 0., 1.}) {
    for (const double db : {-1., 1.}) {
      for (int i = 0; i <= 60; ++i) {
        const double x = a.value * i / 55 * std::cos(i), y = b.value * i / 55 * std::sin(i);
        const double level = 1 - std::pow(x / (a.value + da * a.error), 2) - std::pow(y / (b.value + db * b.error), 2);
        const SurfacePoint point = pressed.surface(x, y);
        for (const double dp : {-1., 1.}) {
          const double p = level > 0 ? (p0.value + dp * p0.error) * std::sqrt(level) : 0;
          EXPECT_LE(std::fabs(point.pressure.value - p), point.pressure.error) << i << ' ' << da << ' ' << db;
        }
      }
    }
  }
}

}  // namespace
}  // namespace patchgrip::cli
