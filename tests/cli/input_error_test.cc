#include <patchgrip/cli/input_error.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/placed.h>

namespace patchgrip::cli {
namespace {

using friction::HertzDisc;
using friction::HertzEllipse;
using friction::Law;
using friction::Placed;
using friction::PlanarFrame;
using friction::Pole;
using friction::Twist;
using friction::Wrench;

constexpr double normal_force = 7;

double logarithmic(double low, double high) {
  return low * std::pow(high / low, 1e-6 * *rc::gen::inRange(0, 1'000'001));
}

double signed_size(double low, double high) { return (*rc::gen::inRange(0, 2) == 0 ? -1 : 1) * logarithmic(low, high); }

Law any_law() {
  const Law dry = *rc::gen::inRange(0, 2) == 0 ? Law::coulomb(0.5) : Law::stribeck(0.9, 0.4, logarithmic(1e-4, 1e2));
  return *rc::gen::inRange(0, 2) == 0 ? dry : dry.with_viscous(logarithmic(1e-3, 1e3));
}

Wrench wrench_of(const Law& law, double radius, const Pole& centre, const Twist& v) {
  return friction_wrench(law, normal_force, Placed{HertzDisc::of_radius(radius), centre.x, centre.y}, v).value;
}

DiscMotion moving(double radius, const Pole& centre, const Twist& v) {
  return DiscMotion::of(HertzDisc::of_radius(radius), centre, v);
}

// `bound` holds for the change from `a` to `b` and is not idle: checked with errors far above rounding.
void require_bound(const WrenchError& bound, const Wrench& a, const Wrench& b, double rounding_force,
                   double rounding_moment) {
  RC_ASSERT(std::hypot(a.fx - b.fx, a.fy - b.fy) <= 1.001 * bound.force + rounding_force);
  RC_ASSERT(std::fabs(a.m - b.m) <= 1.001 * bound.moment + rounding_moment);
}

RC_GTEST_PROP(InputError, ARadiusThatIsOffChangesTheWrenchByNoMore, ()) {
  constexpr double delta = 1e-6;
  const Law law = any_law();
  const double radius = logarithmic(1e-4, 1);
  const Pole centre{signed_size(1e-5, 10), signed_size(1e-5, 10)};
  const Pole pole{centre.x + radius * signed_size(1e-4, 1e4), centre.y + radius * signed_size(1e-4, 1e4)};
  const Twist v = friction::twist_about(pole, signed_size(1e-3, 1e3));
  const Wrench a = wrench_of(law, radius, centre, v);
  const Wrench b = wrench_of(law, radius * (1 + delta), centre, v);
  const double force = std::hypot(a.fx, a.fy);
  const double arm = radius + std::hypot(centre.x, centre.y);
  const WrenchError bound = error_of_radius(law, normal_force, moving(radius, centre, v), 1.01 * delta);
  require_bound(bound, a, b, 1e-13 * force, 1e-13 * (std::fabs(a.m) + arm * force));
}

TEST(InputError, OfTheRadiusIsReachedAtTheCentre) {
  constexpr double delta = 1e-6;
  const Law law = Law::coulomb(0.5);
  const Twist v{0, 0, 1};
  const double change = wrench_of(law, 1 + delta, {}, v).m - wrench_of(law, 1, {}, v).m;
  EXPECT_NEAR(error_of_radius(law, normal_force, moving(1, {}, v), delta).moment, std::fabs(change), 1e-12);
}

TEST(InputError, OfTheRadiusDoesNotReachATranslation) {
  const WrenchError error = error_of_radius(Law::coulomb(0.5), normal_force, moving(1, {2, 3}, {1, 1, 0}), 1e-6);
  EXPECT_EQ(error.force, 0);
  EXPECT_EQ(error.moment, 0);
}

// An ellipse with wrong axes, that is turned as well: no point moves by more than the share of its distance that is
// told.
RC_GTEST_PROP(InputError, AnEllipseThatIsOffChangesTheWrenchByNoMore, ()) {
  const Law law = any_law();
  const double a = logarithmic(1e-4, 1);
  const double b = a * logarithmic(1e-2, 1);
  const double stretch = 1e-6 * *rc::gen::inRange(-1, 2), squeeze = 1e-6 * *rc::gen::inRange(-1, 2);
  const double turn = 1e-6 * *rc::gen::inRange(0, 2);
  const Pole centre{signed_size(1e-5, 10), signed_size(1e-5, 10)};
  const Pole pole{centre.x + a * signed_size(1e-4, 1e3), centre.y + b * signed_size(1e-4, 1e3)};
  const Twist v = friction::twist_about(pole, signed_size(1e-3, 1e3));
  const Placed given{HertzEllipse::of_semi_axes(a, b), PlanarFrame{centre.x, centre.y, 0.3}};
  const Placed off{HertzEllipse::of_semi_axes(a * (1 + stretch), b * (1 + squeeze)),
                   PlanarFrame{centre.x, centre.y, 0.3 + turn}};
  const Wrench t = friction_wrench(law, normal_force, given, v).value;
  const Wrench u = friction_wrench(law, normal_force, off, v).value;
  const double delta = 1.01 * (1e-6 + (a / b - 1) * turn);
  const WrenchError bound = error_of_shape(law, normal_force, ShapeMotion::of(given, centre, a, v), delta);
  const double force = std::hypot(t.fx, t.fy);
  const double arm = a + std::hypot(centre.x, centre.y);
  require_bound(bound, t, u, 1e-13 * force, 1e-13 * (std::fabs(t.m) + arm * force));
}

TEST(InputError, OfTheShapeIsNotIdle) {
  constexpr double delta = 1e-6;
  const Law law = Law::coulomb(0.5);
  const Twist v{0, 0, 1};
  const auto moment = [&](double scale) {
    return friction_wrench(law, normal_force, HertzEllipse::of_semi_axes(2 * scale, scale), v).value.m;
  };
  const auto motion = ShapeMotion::of(HertzEllipse::of_semi_axes(2, 1), {}, 2, v);
  const double bound = error_of_shape(law, normal_force, motion, delta).moment;
  EXPECT_LE(bound, 10 * std::fabs(moment(1 + delta) - moment(1)));
  EXPECT_GE(bound, std::fabs(moment(1 + delta) - moment(1)));
}

// The twist is wrong by up to 2^-53 of its size: the wrench in extended precision says by how much that matters.
struct Exact {
  long double fx, fy, m;
};

Exact exact_wrench(const Law& law, const friction::PressureMoments& s, const Wrench& g, const Pole& pole, double w) {
  const long double vx = static_cast<long double>(w) * pole.y;
  const long double vy = -static_cast<long double>(w) * pole.x;
  const long double cx = vx - static_cast<long double>(w) * s.y;
  const long double cy = vy + static_cast<long double>(w) * s.x;
  const long double square = cx * cx + cy * cy + static_cast<long double>(w) * w * s.polar;
  const long double v_s = law.stribeck_velocity;
  const long double mu =
      law.mu_kinetic + (static_cast<long double>(law.mu_static) - law.mu_kinetic) * std::exp(-square / (v_s * v_s));
  const long double wet = law.mu_viscous;
  const long double s1 = static_cast<long double>(s.x) * s.x + static_cast<long double>(s.y) * s.y + s.polar;
  return {-normal_force * (mu * g.fx + wet * cx), -normal_force * (mu * g.fy + wet * cy),
          -normal_force * (mu * g.m + wet * (s.x * vy - s.y * vx + w * s1))};
}

RC_GTEST_PROP(InputError, ATwistMadeFromAnExactPoleAndSpeedIsCovered, ()) {
  const Law law = any_law();
  const double radius = logarithmic(1e-4, 1);
  const Pole centre{signed_size(1e-5, 10), signed_size(1e-5, 10)};
  const Placed disc{HertzDisc::of_radius(radius), centre.x, centre.y};
  const Pole pole{centre.x + radius * signed_size(1e-4, 1e4), centre.y + radius * signed_size(1e-4, 1e4)};
  const double w = signed_size(1e-3, 1e3);
  const Twist v = friction::twist_about(pole, w);
  const friction::PressureMoments moments = disc.moments();
  const Wrench g = disc.gradient(friction::twist_about(pole, std::copysign(1.0, w)));

  const friction::BoundedWrench t = friction_wrench(law, normal_force, moments, {g, 0, 0}, v);
  const WrenchError added = error_of_twist(law, normal_force, moments, g, v);
  const Exact exact = exact_wrench(law, moments, g, pole, w);
  RC_ASSERT(std::hypot(exact.fx - t.value.fx, exact.fy - t.value.fy) <= t.force_error + added.force);
  RC_ASSERT(std::fabs(exact.m - t.value.m) <= t.moment_error + added.moment);
}

}  // namespace
}  // namespace patchgrip::cli
