#include <patchgrip/friction/hertz_ellipse.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/tests/friction/ellipse_reference.h>
#include <patchgrip/tests/friction/hessian.h>

namespace patchgrip::friction {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double unit = 0x1p-53;

struct Axes {
  double a, b;
};

const std::vector<Axes> shapes{{2, 1},     {1, 1.0001}, {0.003, 0.002}, {1, 5},      {30, 1},
                               {100, 1.7}, {1, 1000},   {1, 0.001},     {1e-2, 1e4}, {1e6, 1}};

Pole on_ellipse(const Axes& s, double x, double angle) {
  return {x * s.a * std::cos(angle), x * s.b * std::sin(angle)};
}

// Centre, inside, on the rim and next to it, tips, foci, beside the long sides, around, far, at infinity.
std::vector<Twist> twists(const Axes& s) {
  std::vector<Pole> poles{{0, 0}, {s.a, 0}, {0, -s.b}};
  const double major = std::max(s.a, s.b);
  const double focus = std::sqrt(std::fabs(s.a - s.b) * (s.a + s.b));
  poles.push_back(s.a > s.b ? Pole{focus, 0} : Pole{0, focus});
  for (const double angle : {0.0, 1e-6, 0.003, 0.4, 1.57, -0.8, -3.1, std::numbers::pi / 2}) {
    for (const double x : {1e-12, 0.3, 0.9, 1 - 1e-6, 1 - 1e-14, 1.0, 1 + 1e-14, 1 + 1e-6, 1.01, 1.4, 3.0, 30.0}) {
      poles.push_back(on_ellipse(s, x, angle));
    }
    for (const double r : {0.2, 0.9999, 1.0, 1.1, 1.5, 2.0, 6.0, 100.0, 1e8}) {
      poles.push_back({r * major * std::cos(angle), r * major * std::sin(angle)});
    }
  }
  std::vector<Twist> result;
  for (const Pole& pole : poles) result.push_back(twist_about(pole, result.size() % 2 == 0 ? 1 : -0.3));
  for (const double angle : {0.0, 0.7, 2.0, -1.3}) result.push_back({std::cos(angle), std::sin(angle), 0});
  return result;
}

struct Sample {
  Twist twist;
  Wrench50 exact;
};

struct Judged {
  Axes axes;
  std::vector<Sample> samples;
};

// Every shape with its twists and the exact gradient, which takes its time.
const std::vector<Judged>& judged() {
  static const std::vector<Judged> all = [] {
    std::vector<Judged> result;
    for (const Axes& s : shapes) {
      const EllipseReference exact(s.a, s.b);
      Judged judged{s, {}};
      for (const Twist& v : twists(s)) judged.samples.push_back({v, exact.gradient(v)});
      result.push_back(std::move(judged));
    }
    return result;
  }();
  return all;
}

struct Errors {
  double force, moment;
};

Errors errors(const Wrench& g, const Wrench50& exact) {
  return {static_cast<double>(hypot(g.fx - exact.fx, g.fy - exact.fy)), static_cast<double>(abs(g.m - exact.m))};
}

std::string print(const Axes& s, const Twist& v) {
  const auto number = [](double x) { return std::to_string(x) + ' '; };
  return number(s.a) + number(s.b) + number(-v.vy / v.w / s.a) + number(v.vx / v.w / s.b);
}

// Rows of the reference table: I1, I2 and a_K I3.
TEST(HertzEllipse, HasTheReferenceValues) {
  struct Row {
    Axes axes;
    Pole pole;
    double I1, I2, I3;
  };
  for (const auto& [axes, pole, I1, I2, I3] : {
           Row{{2, 1}, {0.6, 0.4}, 0.3526649626644055918643, -0.3839497362234668428174, 0.5147786693294829588690},
           Row{{2, 1}, {0, 0}, 0, 0, 0.6422594471178751316747},
           Row{{5, 1}, {-10, -3}, -0.2988948472980901021030, 0.9508442950603631831634, 0.02942819581889284660959},
           Row{{30, 1}, {30, 0}, 0, -0.9997242209031362335576, 0.002270915632660496559298},
           Row{{1, 0.001},
               {-0.5, -0.003},
               -0.02086198644044370545827,
               0.6874593374209934897481,
               6.670182374574555934444},
       }) {
    const HertzEllipse patch = HertzEllipse::of_semi_axes(axes.a, axes.b);
    const Wrench g = patch.gradient(twist_about(pole, 1));
    EXPECT_NEAR(g.fx, I1, 1e-15);
    EXPECT_NEAR(g.fy, I2, 1e-15);
    EXPECT_NEAR(g.m / patch.area_radius(), I3, 4e-15 * I3);
  }
}

TEST(HertzEllipse, ForceAndMomentAreRelativelyExactAndWithinTheirBounds) {
  double worst_force = 0, worst_moment = 0;
  for (const auto& [s, samples] : judged()) {
    const HertzEllipse patch = HertzEllipse::of_semi_axes(s.a, s.b);
    for (const auto& [v, truth] : samples) {
      const BoundedWrench g = patch.bounded_gradient(v);
      const Errors e = errors(g.value, truth);
      EXPECT_LE(e.force, g.force_error) << print(s, v);
      EXPECT_LE(e.moment, g.moment_error) << print(s, v);
      const Wrench same = patch.gradient(v);
      EXPECT_TRUE(same.fx == g.value.fx && same.fy == g.value.fy && same.m == g.value.m);
      if (e.force > 0) worst_force = std::max(worst_force, e.force / static_cast<double>(hypot(truth.fx, truth.fy)));
      if (e.moment > 0) worst_moment = std::max(worst_moment, e.moment / static_cast<double>(abs(truth.m)));
    }
  }
  RecordProperty("worst_force_units", std::to_string(worst_force / unit));
  RecordProperty("worst_moment_units", std::to_string(worst_moment / unit));
  EXPECT_LE(worst_force, 12 * unit);
  EXPECT_LE(worst_moment, 16 * unit);
}

// Each component by itself: along a slender ellipse one of them is far smaller than the other.
TEST(HertzEllipse, BothComponentsOfTheForceAreRelativelyExact) {
  for (const auto& [s, samples] : judged()) {
    const HertzEllipse patch = HertzEllipse::of_semi_axes(s.a, s.b);
    for (const auto& [v, truth] : samples) {
      const Wrench g = patch.gradient(v);
      EXPECT_LE(abs(g.fx - truth.fx), 16 * unit * abs(truth.fx)) << print(s, v);
      EXPECT_LE(abs(g.fy - truth.fy), 16 * unit * abs(truth.fy)) << print(s, v);
    }
  }
}

TEST(HertzEllipse, DissipationIsThePowerOfTheExactWrench) {
  for (const auto& [s, samples] : judged()) {
    const HertzEllipse patch = HertzEllipse::of_semi_axes(s.a, s.b);
    for (const auto& [v, truth] : samples) {
      const double D = static_cast<double>(truth.fx * v.vx + truth.fy * v.vy + truth.m * v.w);
      EXPECT_NEAR(patch.dissipation(v), D, 16 * unit * D) << print(s, v);
    }
  }
}

// From row to row of the table, from it to the polynomial inside and to the far row: nobody can tell where.
TEST(HertzEllipse, TheRowsAgreeWhereTheyMeet) {
  for (const Axes& s : {Axes{3, 1}, Axes{500, 1}, Axes{1, 1.3}}) {
    const HertzEllipse patch = HertzEllipse::of_semi_axes(s.a, s.b);
    const EllipseReference exact(s.a, s.b);
    const double major = std::max(s.a, s.b), minor = std::min(s.a, s.b);
    for (double l = major; l > minor / 8; l /= 2) {
      for (const double side : {1 - 4 * unit, 1.0, 1 + 4 * unit}) {
        for (const double angle : {0.05, 0.8, 1.5}) {
          const double x = std::hypot(s.a, side * l) * std::cos(angle);
          const double y = std::hypot(s.b, side * l) * std::sin(angle);
          const Twist v = twist_about({x, y}, 1);
          const BoundedWrench g = patch.bounded_gradient(v);
          const Errors e = errors(g.value, exact.gradient(v));
          EXPECT_LE(e.force, g.force_error) << print(s, v);
          EXPECT_LE(e.moment, g.moment_error) << print(s, v);
        }
      }
    }
  }
}

// With equal axes it is the disc, and nothing divides by their difference.
TEST(HertzEllipse, OfEqualAxesIsTheHertzDisc) {
  const HertzEllipse patch = HertzEllipse::of_semi_axes(0.7, 0.7);
  const HertzDisc disc = HertzDisc::of_radius(0.7);
  for (const Twist& v : twists({0.7, 0.7})) {
    const BoundedWrench g = patch.bounded_gradient(v), h = disc.bounded_gradient(v);
    EXPECT_LE(std::hypot(g.value.fx - h.value.fx, g.value.fy - h.value.fy), g.force_error + h.force_error);
    EXPECT_LE(std::fabs(g.value.m - h.value.m), g.moment_error + h.moment_error);
    EXPECT_LE(scaled_difference(patch.hessian(v), disc.hessian(v), v, 0.7),
              40 * unit * scaled_size(disc.hessian(v), v, 0.7));
  }
  EXPECT_DOUBLE_EQ(patch.moments().polar, disc.moments().polar);
  EXPECT_DOUBLE_EQ(patch.area_radius(), disc.area_radius());
}

TEST(HertzEllipse, SwappedAxesSwapTheForce) {
  for (const Axes& s : shapes) {
    const HertzEllipse patch = HertzEllipse::of_semi_axes(s.a, s.b);
    const HertzEllipse swapped = HertzEllipse::of_semi_axes(s.b, s.a);
    for (const Twist& v : twists(s)) {
      const Twist turned{-v.vy, v.vx, v.w};
      const Wrench g = patch.gradient(v), h = swapped.gradient(turned);
      EXPECT_TRUE(h.fx == -g.fy && h.fy == g.fx && h.m == g.m) << print(s, v);
      const Hessian p = patch.hessian(v), q = swapped.hessian(turned);
      EXPECT_TRUE(q.xx == p.yy && q.xy == -p.xy && q.xw == -p.yw && q.yy == p.xx && q.yw == p.xw && q.ww == p.ww);
    }
  }
}

TEST(HertzEllipse, MirroredMotionMirrorsTheForce) {
  for (const Axes& s : shapes) {
    const HertzEllipse patch = HertzEllipse::of_semi_axes(s.a, s.b);
    for (const Twist& v : twists(s)) {
      const Wrench g = patch.gradient(v);
      const Wrench h = patch.gradient({v.vx, -v.vy, v.w}), k = patch.gradient({v.vx, v.vy, -v.w});
      EXPECT_TRUE(h.fx == g.fx && h.fy == -g.fy && h.m == g.m);
      EXPECT_TRUE(k.fx == g.fx && k.fy == g.fy && k.m == -g.m);
    }
  }
}

TEST(HertzEllipse, SizeScalesTheMomentAlone) {
  for (const double k : {0x1p-300, 0x1p-20, 0x1p40, 0x1p300}) {
    for (const Axes& s : shapes) {
      const HertzEllipse patch = HertzEllipse::of_semi_axes(s.a, s.b);
      const HertzEllipse scaled = HertzEllipse::of_semi_axes(k * s.a, k * s.b);
      const Twist v{0.3 * s.a, 2 * s.b, 1.1};
      const Wrench g = patch.gradient(v), h = scaled.gradient({v.vx, v.vy, v.w / k});
      EXPECT_TRUE(h.fx == g.fx && h.fy == g.fy && h.m == k * g.m) << k;
    }
  }
}

TEST(HertzEllipse, AnySpeedThatADoubleHolds) {
  const HertzEllipse patch = HertzEllipse::of_semi_axes(0.02, 0.001);
  const Twist v{0.03, 0.04, 5};
  const Wrench g = patch.gradient(v);
  const double D = patch.dissipation(v);
  for (const double k : {0x1p-1000, 0x1p-110, 0x1p-90, 0x1p90, 0x1p110, 0x1p1000}) {
    const Twist u{k * v.vx, k * v.vy, k * v.w};
    const Wrench h = patch.gradient(u);
    EXPECT_TRUE(h.fx == g.fx && h.fy == g.fy && h.m == g.m) << k;
    EXPECT_EQ(patch.dissipation(u), k * D);
    EXPECT_NEAR(patch.hessian(u).xy * k, patch.hessian(v).xy, 4 * unit * std::fabs(patch.hessian(v).xy));
  }
}

// The linear first term of a pole near infinity: <(e . P)^2> w / V, e towards the pole.
TEST(HertzEllipse, ATranslationHasTheForceOfAPointAndNoMoment) {
  for (const Axes& s : shapes) {
    const HertzEllipse patch = HertzEllipse::of_semi_axes(s.a, s.b);
    for (const double angle : {0.0, 0.3, 1.5, 2.9}) {
      const double c = std::cos(angle), d = std::sin(angle);
      const Wrench g = patch.gradient({3 * c, 3 * d, 0});
      EXPECT_NEAR(g.fx, c, 4 * unit);
      EXPECT_NEAR(g.fy, d, 4 * unit);
      EXPECT_EQ(g.m, 0);
      const double spread = (s.a * s.a * c * c + s.b * s.b * d * d) / 5;  // of the arm across the pole's direction
      EXPECT_NEAR(patch.hessian({3 * c, 3 * d, 0}).ww, spread / 3, 16 * unit * spread);
    }
  }
}

TEST(HertzEllipse, HessianEqualsDifferencesOfTheExactGradient) {
  double worst = 0;
  for (const Axes& s : shapes) {
    const HertzEllipse patch = HertzEllipse::of_semi_axes(s.a, s.b);
    const EllipseReference exact(s.a, s.b);
    const auto gradient = [&](const Real50& vx, const Real50& vy, const Real50& w) {
      return exact.gradient(vx, vy, w);
    };
    const double length = std::max(s.a, s.b), narrow = std::min(s.a, s.b) / length;
    for (const double x : {0.8, 1.1, 6.0, 1e3}) {
      for (const double angle : {0.02, 0.7, 1.56}) {
        const Twist v = twist_about(on_ellipse(s, x, angle), 1);
        const Hessian reference = hessian_by_differences(gradient, v, length, 1e-10 * narrow);
        const double error =
            scaled_difference(patch.hessian(v), reference, v, length) / scaled_size(reference, v, length);
        EXPECT_LE(error, 1e-14) << print(s, v);
        worst = std::max(worst, error);
      }
    }
  }
  RecordProperty("worst", std::to_string(worst * 1e15) + "e-15");
}

TEST(HertzEllipse, HessianIsFlatAlongTheTwistAndNowhereConcave) {
  for (const Axes& s : shapes) {
    const HertzEllipse patch = HertzEllipse::of_semi_axes(s.a, s.b);
    const double length = std::max(s.a, s.b);
    for (const Twist& v : twists(s)) {
      const Hessian h = patch.hessian(v);
      const double size = scaled_size(h, v, length);
      EXPECT_TRUE(std::isfinite(size));
      EXPECT_LE(along_itself(h, v, length), 1e-14 * size) << print(s, v);
      EXPECT_GE(least_curvature(h, v, length), -1e-14 * size) << print(s, v);
    }
  }
}

TEST(HertzEllipse, AtRestThereIsNoForceAndNoHessian) {
  const HertzEllipse patch = HertzEllipse::of_semi_axes(2, 1);
  const Wrench g = patch.gradient({0, 0, 0});
  EXPECT_TRUE(g.fx == 0 && g.fy == 0 && g.m == 0);
  EXPECT_EQ(patch.dissipation({0, 0, 0}), 0);
  EXPECT_EQ(patch.bounded_gradient({0, 0, 0}).force_error, 0);
  EXPECT_THAT([&] { patch.hessian({0, 0, 0}); }, ThrowsMessage<std::domain_error>(HasSubstr("twist = 0")));
}

TEST(HertzEllipse, ATwistThatIsNoNumberGivesNone) {
  const HertzEllipse patch = HertzEllipse::of_semi_axes(2, 1);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const Twist& v : {Twist{bad, 1, 1}, Twist{1, bad, 1}, Twist{1, 1, bad}, Twist{bad, 0, 0}}) {
      const Wrench g = patch.gradient(v);
      EXPECT_TRUE(std::isnan(g.fx) && std::isnan(g.fy) && std::isnan(g.m));
      EXPECT_TRUE(std::isnan(patch.dissipation(v)));
      EXPECT_TRUE(std::isnan(patch.bounded_gradient(v).moment_error));
    }
  }
}

TEST(HertzEllipse, IsCentredWithThePolarMomentOfItsPressure) {
  const HertzEllipse patch = HertzEllipse::of_semi_axes(3, 1);
  EXPECT_EQ(patch.moments().x, 0);
  EXPECT_EQ(patch.moments().y, 0);
  EXPECT_DOUBLE_EQ(patch.moments().polar, 2);  // (a^2 + b^2) / 5
  EXPECT_DOUBLE_EQ(patch.area_radius(), std::sqrt(3));
  EXPECT_EQ(patch.a(), 3);
  EXPECT_EQ(patch.b(), 1);
}

TEST(HertzEllipse, AxesOutsideTheDomainAreRefused) {
  const auto of = [](double a, double b) { return [a, b] { HertzEllipse::of_semi_axes(a, b); }; };
  EXPECT_THAT(of(-1, 1), ThrowsMessage<std::invalid_argument>("a = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT(of(1, 0), ThrowsMessage<std::invalid_argument>("b = 0 is not allowed: must be positive and finite"));
  EXPECT_THROW(of(std::numeric_limits<double>::infinity(), 1)(), std::invalid_argument);
  EXPECT_THROW(of(1, std::numeric_limits<double>::quiet_NaN())(), std::invalid_argument);
  for (const auto& [a, b] : {Axes{1e7, 1}, Axes{1, 1e7}}) {
    EXPECT_THAT(of(a, b), ThrowsMessage<std::invalid_argument>(HasSubstr("must lie in [1, 1e+06]")));
  }
}

}  // namespace
}  // namespace patchgrip::friction
