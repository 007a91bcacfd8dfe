// The largest pressure that press states, and that there is none where it is infinite: against fifty digits.
#include <patchgrip/cli/press/pressed.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/contact/power_profile.h>
#include <patchgrip/contact/sphere.h>

#include "press_bounds.h"

namespace patchgrip::cli {
namespace {

using namespace test;
using ::testing::HasSubstr;

TEST(PressPeaks, NoPeakWhereTheSlopeOfAStampJumps) {
  for (const char* shape : {"stamp = \"flat_end\"\nend_radius = 0.00371\nradius = 0.05",
                            "stamp = \"flat_end\"\nend_radius = 0.00371\nslope = 0.1", "stamp = \"cone\"\nslope = 0.1",
                            "stamp = \"points\"\npoints = [[0, 0], [0.00371, 0], [0.0107, 0.002], [0.1, 0.03]]",
                            "stamp = \"power\"\ncoefficient = 0.1\nexponent = 0.7"}) {
    for (const double force : {1e-3, 0.1, 1., 5.}) {
      const Answer answer = press(press_scene(stamp(shape, fmt::format("normal_force = {}", force)))).answer;
      EXPECT_FALSE(has(answer.main, "peak_pressure")) << shape;
      EXPECT_THAT(answer.warnings, ::testing::Contains(HasSubstr("no peak pressure"))) << shape;
    }
  }
}

// The largest p / E*: found by golden section over ln(a - r), where it is flat, and then taken in fifty digits.
template <class Profile>
Exact peak_of(const Profile& profile, const Exact& exact_a) {
  const auto a = static_cast<long double>(exact_a);
  const auto pressure = [&](long double log_inward) {
    return profile.pressure(std::max(a - std::exp(log_inward), 0.L), a);
  };
  const long double part = (std::sqrt(5.L) - 1) / 2;
  long double lo = std::log(1e-11L * a);
  long double hi = std::log(a);
  long double x = hi - part * (hi - lo), y = lo + part * (hi - lo);
  long double at_x = pressure(x), at_y = pressure(y);
  while (hi - lo > 1e-9L) {
    if (at_x > at_y) {
      hi = y, y = x, at_y = at_x;
      x = hi - part * (hi - lo), at_x = pressure(x);
    } else {
      lo = x, x = y, at_x = at_y;
      y = lo + part * (hi - lo), at_y = pressure(y);
    }
  }
  const Exact r = exact_a - exp(Exact((lo + hi) / 2));
  const Exact middle = profile.pressure(Exact(0), exact_a);
  return r > 0 ? std::max(middle, Exact(profile.pressure(r, exact_a))) : middle;
}

void expect_peak(const LawAnswer& answer, const Exact& peak, const std::string& what) {
  expect_within(answer, "peak_pressure", Exact(result(answer, "contact_modulus").value) * peak, what);
}

TEST(PressPeaks, PeakOfASphereCloseToItsRim) {
  const auto sphere = contact::Sphere::of_radius(0.01);
  for (const double ratio : {0.1, 0.5, 0.8, 0.9, 0.99, 0.9999, 0.999999, 0.99999999}) {
    const double a = 0.01 * ratio;
    const std::string shape = "stamp = \"sphere\"\nradius = 0.01";
    const std::string what = fmt::format("a/R = {}", ratio);
    const LawAnswer by_radius = press(press_scene(stamp(shape, fmt::format("contact_radius = {}", a)))).answer.main;
    expect_peak(by_radius, peak_of(sphere, Exact(a)), what);
    const Result& peak = result(by_radius, "peak_pressure");
    EXPECT_LE(peak.error, 1e-13 * peak.value) << what;

    const double force = result(by_radius, "normal_force").value;
    const LawAnswer by_force = press(press_scene(stamp(shape, fmt::format("normal_force = {}", force)))).answer.main;
    Exact low = 0, high = 0.01;
    for (int i = 0; i < 140; ++i) {
      const Exact mid = (low + high) / 2;
      (result(by_force, "contact_modulus").value * sphere.force(mid) < force ? low : high) = mid;
    }
    expect_peak(by_force, peak_of(sphere, low), what + " by force");
  }
}

TEST(PressPeaks, PeakOfAPowerFromTheMiddleToTheRim) {
  for (const double exponent : {1.5, 2., 2.0001, 2.1, 3., 7.5, 30., 100.}) {
    const double coefficient = 1e-3 * std::pow(2, exponent);
    const auto profile = contact::PowerProfile::of_coefficient(coefficient, exponent);
    const LawAnswer answer =
        press(
            press_scene(stamp(fmt::format("stamp = \"power\"\ncoefficient = {}\nexponent = {}", coefficient, exponent),
                              "contact_radius = 0.45")))
            .answer.main;
    expect_peak(answer, peak_of(profile, Exact(0.45)), fmt::format("exponent {}", exponent));
  }
}

TEST(PressPeaks, SphereAtItsEquatorIsRefusedWithTheLimit) {
  for (const double force : {1e4, 1e8, 1e12}) {
    const std::string load = fmt::format("normal_force = {}", force);
    try {
      press(press_scene(stamp("stamp = \"sphere\"\nradius = 0.01", load)));
      ADD_FAILURE() << force;
    } catch (const SceneError& error) {
      EXPECT_THAT(error.what(), HasSubstr(fmt::format("contact.normal_force = {}: press lets", force)));
      EXPECT_THAT(error.what(), HasSubstr("a/R = 1 - 1e-09"));
    }
    // Beside the paraboloid it is a warning, and not one of jumps of the slope.
    const Answer answer = press(press_scene(stamp("radius = 0.01", load))).answer;
    EXPECT_THAT(answer.warnings, ::testing::Contains(HasSubstr("sphere does not reach this load")));
    EXPECT_THAT(answer.warnings, ::testing::Not(::testing::Contains(HasSubstr("slope of the stamp"))));
  }
  for (const double ratio : {0.99, 0.999999, 1 - 1.01e-9}) {
    const PressScene s =
        press_scene(stamp("stamp = \"sphere\"\nradius = 0.01", fmt::format("contact_radius = {}", 0.01 * ratio)));
    const Pressed pressed = press(s);
    ASSERT_EQ(pressed.answer.warnings.size(), 1U);
    EXPECT_THAT(pressed.answer.warnings.front(), HasSubstr("approach / contact radius"));
    for (const auto& row : surface_table(s, pressed).rows) {
      for (const double x : row) ASSERT_FALSE(std::isnan(x)) << ratio;
    }
  }
}

}  // namespace
}  // namespace patchgrip::cli
