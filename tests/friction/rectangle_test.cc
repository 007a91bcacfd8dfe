#include <patchgrip/friction/rectangle.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/friction/law.h>
#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {
namespace {

using ::testing::ThrowsMessage;

// The corner sums of the header in 50 digits; they lose 3 digits per decade of the pole's distance.
class Corners {
 public:
  Corners(double l_xi, double l_eta) : l_xi_(l_xi), l_eta_(l_eta) {}

  Wrench50 gradient(const Real50& vx, const Real50& vy, const Real50& w) const {
    const Real50 X = -vy / w, Y = vx / w;
    Real50 S = 0, I1 = 0, I2 = 0;
    for (const int sx : {-1, 1}) {
      for (const int sy : {-1, 1}) {
        const Real50 x = sx * Real50(l_xi_) / 2 - X;
        const Real50 y = sy * Real50(l_eta_) / 2 - Y;
        const Real50 d = sqrt(x * x + y * y);
        const int sign = sx * sy;
        S += sign * (x * y * d / 3 + x * x * x_asinh(x, y) / 6 + y * y * x_asinh(y, x) / 6);
        I1 -= sign * (x * d + y * x_asinh(y, x)) / 2;
        I2 += sign * (y * d + x * x_asinh(x, y)) / 2;
      }
    }
    const Real50 k = (w < 0 ? -1 : 1) / (Real50(l_xi_) * l_eta_);
    return {k * I1, k * I2, k * (S + X * I2 - Y * I1)};
  }
  Wrench50 gradient(const Twist& v) const { return gradient(v.vx, v.vy, v.w); }

 private:
  static Real50 x_asinh(const Real50& x, const Real50& y) {
    return x == 0 ? Real50(0) : x * asinh(y / abs(x));
  }  // x asinh(y / |x|)

  double l_xi_, l_eta_;
};

std::vector<Twist> twists(double l_xi, double l_eta) {
  std::vector<Twist> result;
  const double half_xi = l_xi / 2, half_eta = l_eta / 2;
  for (const Pole& pole :
       {Pole{0, 0}, Pole{half_xi, 0}, Pole{0, -half_eta}, Pole{half_xi, half_eta}, Pole{-half_xi, 0.3 * half_eta},
        Pole{1.5 * half_xi, half_eta}, Pole{half_xi * (1 + 1e-13), 0.1 * half_eta}, Pole{0.3 * half_xi, 0.8 * half_eta},
        Pole{l_xi, -l_eta}, Pole{3 * l_xi, 2 * l_eta}, Pole{-40 * l_xi, 30 * l_xi}, Pole{1e6 * l_xi, 1e5 * l_xi}}) {
    result.push_back(twist_about(pole, 1));
    result.push_back(twist_about(pole, -0.3));
  }
  return result;
}

TEST(Rectangle, HasTheCornerSumsOfItsHeader) {
  for (const auto& [l_xi, l_eta] : {std::pair{2.0, 1.0}, {0.03, 0.03}, {1.0, 50.0}, {100.0, 1.0}}) {
    const Rectangle patch = Rectangle::of_sides(l_xi, l_eta);
    const Corners exact(l_xi, l_eta);
    for (const Twist& v : twists(l_xi, l_eta)) {
      const BoundedWrench g = patch.bounded_gradient(v);
      const Wrench50 e = exact.gradient(v);
      const double force = static_cast<double>(hypot(g.value.fx - e.fx, g.value.fy - e.fy));
      const double moment = static_cast<double>(abs(g.value.m - e.m));
      EXPECT_LE(force, std::min(g.force_error, 1e-13)) << l_xi << ' ' << l_eta;
      EXPECT_LE(moment, std::min(g.moment_error, 1e-13 * patch.area_radius())) << l_xi << ' ' << l_eta;
      const bool far = std::hypot(v.vx, v.vy) > 3 * std::fabs(v.w) * std::hypot(l_xi, l_eta);  // 6 radii
      if (far) {
        EXPECT_LE(moment, 1e-12 * static_cast<double>(abs(e.m))) << l_xi << ' ' << l_eta;
      }
    }
  }
}

TEST(Rectangle, HessianEqualsDifferencesOfTheCornerSums) {
  const Rectangle patch = Rectangle::of_sides(2, 1);
  const Corners exact(2, 1);
  const auto gradient = [&](const Real50& vx, const Real50& vy, const Real50& w) { return exact.gradient(vx, vy, w); };
  for (const Pole& pole : {Pole{0.3, 0.2}, Pole{-0.9, 0.7}, Pole{3, 3}, Pole{-30, 40}}) {
    const Twist v = twist_about(pole, 0.5);
    const Hessian h = hessian_by_differences(gradient, v, 1);
    EXPECT_LE(scaled_difference(patch.hessian(v), h, v, 1), 1e-15 * scaled_size(h, v, 1));
  }
}

// On the sides differences fail; the second derivatives of S are elementary: [[x asinh(y/|x|)]], [[d]], [[y
// asinh(x/|y|)]].
TEST(Rectangle, HessianIsFiniteOnSidesAndAtCorners) {
  const Rectangle patch = Rectangle::of_sides(2, 1);
  for (const Pole& pole : {Pole{1, 0.5}, Pole{1, 0.2}, Pole{0.3, -0.5}, Pole{2, 0.5}}) {
    double xx = 0, xy = 0, yy = 0;
    for (const int sx : {-1, 1}) {
      for (const int sy : {-1, 1}) {
        const double x = sx - pole.x, y = sy * 0.5 - pole.y;
        if (x != 0) xx += sx * sy * x * std::asinh(y / std::fabs(x)) / 2;
        if (y != 0) yy += sx * sy * y * std::asinh(x / std::fabs(y)) / 2;
        xy += sx * sy * std::hypot(x, y) / 2;
      }
    }
    const Hessian h = patch.hessian(twist_about(pole, 1));
    EXPECT_NEAR(h.xx, yy, 2e-15);
    EXPECT_NEAR(h.xy, -xy, 2e-15);
    EXPECT_NEAR(h.yy, xx, 2e-15);
  }
}

// Keppler 2006, Example 4.8: a block on a turntable, pressed on at the distance L from its axis.
TEST(Rectangle, OfExample48LosesForceAndGainsMomentAgainstAPoint) {
  for (const double L : {1.0, 0.04}) {
    const Rectangle block = Rectangle::of_sides(2 * L, L);
    const Twist v = twist_about({0, L}, 1);
    const Wrench g = block.gradient(v);
    EXPECT_NEAR(g.fx, 0.8652046470004173799544, 1e-15);
    EXPECT_NEAR(g.fy, 0, 1e-16);
    EXPECT_NEAR(g.m / L, 0.2903377951656492827193, 1e-15);
    EXPECT_NEAR(100 * (1 - g.fx), 13.4795, 5e-5);                  // percent less force than a point
    EXPECT_NEAR(100 * ((g.m + L * g.fx) / L - 1), 15.5542, 5e-5);  // percent more moment on the turntable
    EXPECT_NEAR(mean_square_speed(block.moments(), v) / (L * L), 17.0 / 12, 1e-15);
  }
}

TEST(Rectangle, MirroredPolesHaveMirroredWrenches) {
  const Rectangle patch = Rectangle::of_sides(0.3, 0.7);
  for (const Pole& pole : {Pole{0.1, 0.2}, Pole{0.15, 0.35}, Pole{0.6, -1.1}, Pole{5, 9}}) {
    const Wrench g = patch.gradient(twist_about(pole, 1));
    const Wrench h = patch.gradient(twist_about({-pole.x, pole.y}, 1));
    EXPECT_NEAR(h.fx, g.fx, 2e-15);
    EXPECT_NEAR(h.fy, -g.fy, 2e-15);
    EXPECT_NEAR(h.m, g.m, 2e-15);
  }
}

TEST(Rectangle, TurnedByARightAngleItIsTheOneWithItsSidesSwapped) {
  const Rectangle upright = Rectangle::of_sides(0.3, 0.7), lying = Rectangle::of_sides(0.7, 0.3);
  const Wrench g = upright.gradient({0.2, -0.1, 1});
  const Wrench h = lying.gradient({0.1, 0.2, 1});  // the twist turned by 90 degrees
  EXPECT_NEAR(h.fx, -g.fy, 2e-15);
  EXPECT_NEAR(h.fy, g.fx, 2e-15);
  EXPECT_NEAR(h.m, g.m, 2e-15);
}

TEST(Rectangle, TellsItsSidesAreaAndMoments) {
  const Rectangle patch = Rectangle::of_sides(3, 0.5);
  EXPECT_EQ(patch.l_xi(), 3);
  EXPECT_EQ(patch.l_eta(), 0.5);
  EXPECT_EQ(patch.edges(), 4U);
  EXPECT_DOUBLE_EQ(patch.area_radius(), std::sqrt(1.5 / std::numbers::pi));
  const PressureMoments s = patch.moments();
  EXPECT_EQ(s.x, 0);
  EXPECT_EQ(s.y, 0);
  EXPECT_DOUBLE_EQ(s.polar, (9 + 0.25) / 12);
}

TEST(Rectangle, SidesThatAreNotPositiveAndFiniteAreRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto of = [](double l_xi, double l_eta) { return [=] { Rectangle::of_sides(l_xi, l_eta); }; };
  EXPECT_THAT(of(-1, 1), ThrowsMessage<std::invalid_argument>("l_xi = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT(of(1, 0), ThrowsMessage<std::invalid_argument>("l_eta = 0 is not allowed: must be positive and finite"));
  EXPECT_THROW(of(nan, 1)(), std::invalid_argument);
  EXPECT_THROW(of(1, infinity)(), std::invalid_argument);
  EXPECT_THROW(of(1e-200, 1e-200)(), std::invalid_argument);  // its moments underflow
}

}  // namespace
}  // namespace patchgrip::friction
