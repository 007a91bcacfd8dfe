// The errors that press states, against fifty digits where they are tight: at rims, peaks, turning points.
#include <patchgrip/cli/press/pressed.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <patchgrip/cli/press/press_scene.h>
#include <patchgrip/cli/press/press_tables.h>
#include <patchgrip/contact/power_profile.h>
#include <patchgrip/contact/sphere.h>
#include <patchgrip/contact/stick_radius.h>
#include <patchgrip/tests/support/exact.h>

#include "scenes.h"

namespace patchgrip::cli {
namespace {

using testing::Exact;
using ::testing::HasSubstr;

const Exact pi = boost::math::constants::pi<Exact>();
constexpr double infinity = std::numeric_limits<double>::infinity();

PressScene scene(const std::string& text) {
  return read_press_scene(TomlDocument::parse(text, (test::data_folder / "scenes/press/scene.toml").string()),
                          MaterialLibrary({test::data_folder / "materials"}));
}

std::string stamp(const std::string& shape, const std::string& load) {
  return "[contact]\n" + load + "\n[[contact.bodies]]\n" + shape +
         "\nrigid = true\n[[contact.bodies]]\nplane = true\nyoungs_modulus = 50e3\npoisson_ratio = 0.5\n";
}

const Result& result(const LawAnswer& law, std::string_view name) {
  const auto found = std::ranges::find(law.results, name, &Result::name);
  if (found == law.results.end()) throw std::logic_error("no result " + std::string(name));
  return *found;
}

bool has(const LawAnswer& law, std::string_view name) {
  return std::ranges::find(law.results, name, &Result::name) != law.results.end();
}

std::size_t column(const Table& table, std::string_view name) {
  const auto found = std::ranges::find(table.columns, name);
  if (found == table.columns.end()) throw std::logic_error("no column " + std::string(name));
  return static_cast<std::size_t>(found - table.columns.begin());
}

void expect_within(double value, double error, const Exact& exact, const std::string& what) {
  EXPECT_TRUE(std::isfinite(value) && std::isfinite(error)) << what;
  EXPECT_LE(static_cast<double>(abs(Exact(value) - exact)), error) << what << " = " << value << " for " << exact;
}

void expect_within(const LawAnswer& law, std::string_view name, const Exact& exact, const std::string& what) {
  const Result& r = result(law, name);
  expect_within(r.value, r.error, exact, std::string(name) + ", " + what);
}

TEST(PressBounds, GivenPressureOfXydasAndKaoFromTheMiddleToTheRim) {
  for (const double alpha : {0.5, 0.8, 1., 1.8, 2., 7., 50.}) {
    const double a = 0.007;
    const double force = 3;
    const PressScene s = scene(fmt::format(
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

TEST(PressBounds, NoPeakWhereTheSlopeOfAStampJumps) {
  for (const char* shape : {"stamp = \"flat_end\"\nend_radius = 0.00371\nradius = 0.05",
                            "stamp = \"flat_end\"\nend_radius = 0.00371\nslope = 0.1", "stamp = \"cone\"\nslope = 0.1",
                            "stamp = \"points\"\npoints = [[0, 0], [0.00371, 0], [0.0107, 0.002], [0.1, 0.03]]",
                            "stamp = \"power\"\ncoefficient = 0.1\nexponent = 0.7"}) {
    for (const double force : {1e-3, 0.1, 1., 5.}) {
      const Answer answer = press(scene(stamp(shape, fmt::format("normal_force = {}", force)))).answer;
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

TEST(PressBounds, PeakOfASphereCloseToItsRim) {
  const auto sphere = contact::Sphere::of_radius(0.01);
  for (const double ratio : {0.1, 0.5, 0.8, 0.9, 0.99, 0.9999, 0.999999, 0.99999999}) {
    const double a = 0.01 * ratio;
    const std::string shape = "stamp = \"sphere\"\nradius = 0.01";
    const std::string what = fmt::format("a/R = {}", ratio);
    const LawAnswer by_radius = press(scene(stamp(shape, fmt::format("contact_radius = {}", a)))).answer.main;
    expect_peak(by_radius, peak_of(sphere, Exact(a)), what);
    const Result& peak = result(by_radius, "peak_pressure");
    EXPECT_LE(peak.error, 1e-13 * peak.value) << what;

    const double force = result(by_radius, "normal_force").value;
    const LawAnswer by_force = press(scene(stamp(shape, fmt::format("normal_force = {}", force)))).answer.main;
    Exact low = 0, high = 0.01;
    for (int i = 0; i < 140; ++i) {
      const Exact mid = (low + high) / 2;
      (result(by_force, "contact_modulus").value * sphere.force(mid) < force ? low : high) = mid;
    }
    expect_peak(by_force, peak_of(sphere, low), what + " by force");
  }
}

TEST(PressBounds, PeakOfAPowerFromTheMiddleToTheRim) {
  for (const double exponent : {1.5, 2., 2.0001, 2.1, 3., 7.5, 30., 100.}) {
    const double coefficient = 1e-3 * std::pow(2, exponent);
    const auto profile = contact::PowerProfile::of_coefficient(coefficient, exponent);
    const LawAnswer answer =
        press(scene(stamp(fmt::format("stamp = \"power\"\ncoefficient = {}\nexponent = {}", coefficient, exponent),
                          "contact_radius = 0.45")))
            .answer.main;
    expect_peak(answer, peak_of(profile, Exact(0.45)), fmt::format("exponent {}", exponent));
  }
}

TEST(PressBounds, SphereAtItsEquatorIsRefusedWithTheLimit) {
  for (const double force : {1e4, 1e8, 1e12}) {
    const std::string load = fmt::format("normal_force = {}", force);
    try {
      press(scene(stamp("stamp = \"sphere\"\nradius = 0.01", load)));
      ADD_FAILURE() << force;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr(fmt::format("normal_force = {} is not allowed", force)));
      EXPECT_THAT(error.what(), HasSubstr("a/R = 1 - 1e-09"));
    }
    // Beside the paraboloid it is a warning, and not one of jumps of the slope.
    const Answer answer = press(scene(stamp("radius = 0.01", load))).answer;
    EXPECT_THAT(answer.warnings, ::testing::Contains(HasSubstr("sphere does not reach this load")));
    EXPECT_THAT(answer.warnings, ::testing::Not(::testing::Contains(HasSubstr("slope of the stamp"))));
  }
  for (const double ratio : {0.99, 0.999999, 1 - 1.01e-9}) {
    const PressScene s =
        scene(stamp("stamp = \"sphere\"\nradius = 0.01", fmt::format("contact_radius = {}", 0.01 * ratio)));
    const Pressed pressed = press(s);
    EXPECT_TRUE(pressed.answer.warnings.empty());
    for (const auto& row : surface_table(s, pressed).rows) {
      for (const double x : row) ASSERT_FALSE(std::isnan(x)) << ratio;
    }
  }
}

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

TEST(PressBounds, JkrNextToItsTurningPoints) {
  const LawAnswer some = press(scene(adhesive("normal_force = 1e-3"))).answer.main;
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
      const LawAnswer answer = press(scene(adhesive(given("normal_force", force)))).answer.main;
      exact.expect(answer, exact.radius_of_force(force), "normal_force", force);
    }
    for (const double depth : {off_approach * (1 - step), -4.458614072887510e-05, 1e-4 * step}) {
      const Exact L = cbrt(Exact(pi * exact.w * exact.R * exact.R / exact.E));
      if (3 * L * L + 4 * exact.R * Exact(depth) <= 0) continue;
      const LawAnswer answer = press(scene(adhesive(given("approach", depth)))).answer.main;
      exact.expect(answer, exact.radius_of_approach(depth), "approach", depth);
      with_stiffness += has(answer, "stiffness");
    }
    for (const double a : {8.0189988345108e-4 * (1 + step), 3.85513254e-4 * (1 + step), 1e-2 * step + 1e-5}) {
      const LawAnswer answer = press(scene(adhesive(given("contact_radius", a)))).answer.main;
      exact.expect(answer, Exact(a), "contact_radius", a);
      with_stiffness += has(answer, "stiffness");
    }
  }
  EXPECT_GT(with_stiffness, static_cast<int>(5 * steps.size()));
}

TEST(PressBounds, JkrSurfaceNextToItsRim) {
  const double a = 8e-4;
  const PressScene s = scene(adhesive("contact_radius = 8e-4"));
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

std::string cylinders(double R1, double R2, double first, double second) {
  return fmt::format(
      "[contact]\nnormal_force = 1\n[[contact.bodies]]\ncylinder = {}\ndirection = {}\nmaterial = \"steel\"\n"
      "[[contact.bodies]]\ncylinder = {}\ndirection = {}\nmaterial = \"steel\"\n",
      R1, first, R2, second);
}

TEST(PressBounds, DirectionOfTheEllipseOfCrossedCylinders) {
  const double quarter = std::acos(0.);
  for (const double apart : {0., 0x1p-52, 1e-13, 1e-7, 0.1}) {
    for (const double turn : {0.3, 1.1, quarter * (1 - 1e-15), quarter * (1 - 1e-12), quarter, quarter + 1e-6}) {
      for (const double first : {0., 0.7, -1.9}) {
        const double second = first + turn;
        const double R2 = 0.01 * (1 + apart);
        const std::string what = fmt::format("apart {} turn {} first {}", apart, turn, first);
        const Pressed pressed = press(scene(cylinders(0.01, R2, first, second)));
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

TEST(PressBounds, JkrDisplacementAroundTheRim) {
  for (const char* load : {"contact_radius = 8e-4", "normal_force = -4.52e-3", "approach = -4.4586e-05"}) {
    const Pressed pressed = press(scene(adhesive(load)));
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

TEST(PressBounds, MeshHasNoPressureOutsideItsZone) {
  const std::string text =
      "[contact]\nnormal_force = 1.0\n[[contact.bodies]]\nmesh = \"ellipsoid.off\"\nunit = 1e-3\npoint = [0, 0, "
      "10]\nmaterial = \"rubber\"\n[[contact.bodies]]\nplane = true\nmaterial = \"glass\"\n";
  const Pressed pressed = press(scene(text));
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

TEST(PressBounds, FlatPunchPressureIsInfiniteAtItsEdge) {
  const Pressed pressed = press(
      scene("[contact]\npatch = \"flat_punch_disc\"\nradius = 0.005\nnormal_force = 2\ncontact_modulus = 66666.0\n"));
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

TEST(PressBounds, WinklerNextToItsLargestForce) {
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
  EXPECT_THROW(press(scene(text(most * (1 + 1e-14)))), std::invalid_argument);
  for (const double share : {1e-12, 1e-3, 0.5, 0.9, 1 - 1e-4, 1 - 1e-8, 1 - 1e-12, 1 - 1e-14}) {
    const double F = most * share;
    Exact low = 0, high = deepest;
    for (int i = 0; i < 200; ++i) {
      const Exact mid = (low + high) / 2;
      (force(mid) < F ? low : high) = mid;
    }
    const LawAnswer answer = press(scene(text(F))).answer.main;
    const std::string what = fmt::format("1 - F/F_max = {}", 1 - share);
    expect_within(answer, "approach", low, what);
    expect_within(answer, "contact_radius", sqrt(Exact(low * (2 * R - low))), what);
    const Exact g = (R - low) / R;
    expect_within(answer, "peak_pressure", g > 0.5 ? Exact(bed * g * (1 - g)) : Exact(bed) / 4, what);
    EXPECT_EQ(result(answer, "normal_force").error, 0);
  }
}

TEST(PressBounds, StickOfNearlySimilarBodies) {
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
        const LawAnswer answer = press(scene(text(E, nu, E2, nu, mu))).answer.main;
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

TEST(PressBounds, FingertipByItsRadiusTellsTheErrorOfTheForce) {
  const LawAnswer answer = press(scene("[contact]\ncontact_radius = 7e-3\n[contact.fingertip]\ncoefficient = "
                                       "4.1e-3\nexponent = 0.13\nalpha = 1.8\n"))
                               .answer.main;
  EXPECT_EQ(result(answer, "contact_radius").value, 7e-3);
  EXPECT_EQ(result(answer, "contact_radius").error, 0);
  EXPECT_GT(result(answer, "normal_force").error, 0);
  expect_within(answer, "normal_force", pow(Exact(Exact(7e-3) / 4.1e-3), Exact(1 / Exact(0.13))), "power law");
}

}  // namespace
}  // namespace patchgrip::cli
