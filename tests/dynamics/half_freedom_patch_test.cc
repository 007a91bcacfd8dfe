// Half a degree of freedom under a patch: it solves its inclusion, dissipates, sticks exactly and slides by Stribeck.
#include <patchgrip/dynamics/half_freedom_patch.h>

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <patchgrip/dynamics/bristle_motion.h>
#include <patchgrip/dynamics/point_law.h>
#include <patchgrip/dynamics/trajectory.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::dynamics {
namespace {

using friction::HertzDisc;
using friction::Law;
using friction::LimitSurface;
using friction::Rectangle;
using friction::Twist;
using friction::Wrench;
using testing::cases;
using testing::log_uniform;
using testing::uniform;

constexpr double a = 0.02, F_N = 2;
const Law law = Law::stribeck(0.8, 0.5, 0.05);

HalfFreedomParameters parameters(double k, double d) { return {{k, k, k * a * a}, {d, d, d * a * a}}; }

// At random states far beyond and inside of the limit: s is on the limit surface that belongs to the slip, or s* is
// inside and there is none.
template <class P>
void solves_the_inclusion(const P& patch) {
  std::mt19937_64 engine(1);
  const LimitSurface surface(patch);
  int slipping = 0;
  for (int i = 0; i < cases(2000); ++i) {
    const HalfFreedomParameters p = parameters(1e3, log_uniform(engine, 1.01, 10) * least_damping(law, F_N));
    const HalfFreedomPatch<P> zone(patch, p, law, F_N);
    const double most = 0.8 * F_N;
    const Vector3 kappa =
        Vector3(uniform(engine, -most, most), uniform(engine, -most, most), a * uniform(engine, -most, most))
            .cwiseQuotient(p.stiffness);
    const double speed = log_uniform(engine, 1e-4, 10);
    const Vector3 v = speed * Vector3(uniform(engine, -1, 1), uniform(engine, -1, 1), uniform(engine, -1, 1) / a);
    const BristleRates r = zone(kappa, v);
    const Vector3 e = v - r.rate;
    const Wrench s = zone_wrench(kappa, -r.wrench);
    if (r.beta == 0) {
      ASSERT_TRUE(e.isZero(0));
      ASSERT_LE(surface.gauge(s).value, 0.8 * F_N * (1 + 1e-14));
      continue;
    }
    ++slipping;
    const Twist u{e[0] + kappa[1] * e[2], e[1] - kappa[0] * e[2], e[2]};
    const double L = coefficient(law, patch.moments(), u) * F_N;
    const Wrench g = patch.gradient(u);
    // e is a difference of v and dkappa/dt: its rounding counts where it is small.
    const double digits = 1e-11 + 1e-12 * v.norm() / e.norm();
    ASSERT_NEAR(s.fx, L * g.fx, digits * L) << i;
    ASSERT_NEAR(s.fy, L * g.fy, digits * L) << i;
    ASSERT_NEAR(s.m, L * g.m, digits * L * a) << i;
    const double dissipation = -r.wrench.dot(e) + r.rate.dot(p.damping.cwiseProduct(r.rate));
    ASSERT_GE(dissipation, 0);
  }
  EXPECT_GT(slipping, cases(2000) / 4);
}

TEST(HalfFreedomPatch, SolvesTheInclusion) {
  solves_the_inclusion(HertzDisc::of_radius(a));
  solves_the_inclusion(Rectangle::of_sides(0.04, 0.02));
}

// In one direction: dkappa/dt of (4.34), its root found by bisection.
TEST(HalfFreedomPatch, IsTheLawOfAPointInOneDirection) {
  std::mt19937_64 engine(2);
  const double k = 1e3, d = 1.5 * least_damping(law, F_N);
  const HalfFreedomPatch<HertzDisc> zone(HertzDisc::of_radius(a), parameters(k, d), law, F_N);
  for (int i = 0; i < cases(500); ++i) {
    const double kappa = uniform(engine, -1.5, 1.5) / k, v = uniform(engine, -0.5, 0.5);
    const double pull = k * kappa + d * v;
    double slip = 0;
    if (std::fabs(pull) > law.mu_static * F_N) {
      double lo = 0, hi = std::fabs(pull) / d;
      for (int j = 0; j < 200; ++j) {
        const double e = (lo + hi) / 2;
        (d * e - stribeck_force(law, F_N, e) < std::fabs(pull) ? lo : hi) = e;
      }
      slip = std::copysign((lo + hi) / 2, pull);
    }
    ASSERT_NEAR(zone({kappa, 0, 0}, {v, 0, 0}).rate[0], v - slip, 1e-13);
  }
}

// At a steady twist friction comes to that of the rigid patch, less the lever of the bristles.
TEST(HalfFreedomPatch, SlidesWithTheStribeckWrench) {
  const HertzDisc patch = HertzDisc::of_radius(a);
  const HalfFreedomPatch<HertzDisc> zone(patch, parameters(1e8, 1e4), law, F_N);
  const Vector3 v(0.03, 0.01, 1.5);
  Trajectory<3> motion(
      [&](double, const auto& y, auto& r) {
        const Vector3 rate = zone({y[0], y[1], y[2]}, v).rate;
        r = {rate[0], rate[1], rate[2]};
      },
      {0, 0, 0}, 0, {.tolerance = 1e-12});
  motion.run(0.01);
  const auto& y = motion.state();
  const Vector3 t = zone({y[0], y[1], y[2]}, v).wrench;
  const Wrench exact = friction::friction_wrench(law, F_N, patch, {v[0], v[1], v[2]}).value;
  EXPECT_NEAR(t[0], exact.fx, 1e-6);
  EXPECT_NEAR(t[1], exact.fy, 1e-6);
  EXPECT_NEAR(t[2], exact.m, 1e-6 * a);
}

// A puck of 1 kg that slides and spins stops where a rigid patch does, the closer the stiffer; its energy balances.
TEST(HalfFreedomPatch, StopsThePuck) {
  const double R = 0.05, J = R * R / 2;
  for (const double k : {1e4, 1e5, 1e6}) {
    const double d = std::sqrt(k);
    const BristleMotion puck(HalfFreedomPatch<friction::UniformDisc>(friction::UniformDisc::of_radius(R),
                                                                     {{k, k, k * R * R / 2}, {d, d, d * R * R / 2}},
                                                                     Law::coulomb(0.5), 9.81),
                             1, J);
    using Motion = std::decay_t<decltype(puck)>;
    Motion::State y{};
    y[3] = 1, y[5] = 20;
    Motion::Flow flow([&](double, const auto& x, auto& r) { r = puck(Vector3::Zero(), x); }, y, 0,
                      {.tolerance = 1e-10});
    flow.run(0.4);
    y = flow.state();
    EXPECT_NEAR(std::hypot(y[0], y[1]), .12994846567449, 10 / k) << k;
    EXPECT_NEAR(puck.kinetic_energy(y) + puck.stored_energy(y) + y[10], 0.5 + J * 200, 1e-8);
    EXPECT_GE(y[10], 0);
  }
}

// Sticking it is a damped spring: no foot moves, to the rounding of the integration.
TEST(HalfFreedomPatch, DoesNotCreepUnderALoadThatOscillates) {
  const BristleMotion held(HalfFreedomPatch<HertzDisc>(HertzDisc::of_radius(a), parameters(5e3, 100), law, F_N), 1,
                           1e-4);
  using Motion = std::decay_t<decltype(held)>;
  Motion::State y{};
  Motion::Flow flow([&](double t, const auto& x, auto& r) { r = held(Vector3(0.6 * std::sin(6 * t), 0, 0), x); }, y, 0,
                    {.tolerance = 1e-10});
  flow.run(20);
  y = flow.state();
  EXPECT_NEAR(y[0], y[6], 1e-15);
}

TEST(HalfFreedomPatch, BadInputIsRefused) {
  const auto refused = [&](auto change) {
    HalfFreedomParameters p = parameters(1e3, 2 * least_damping(law, F_N));
    change(p);
    EXPECT_THROW(HalfFreedomPatch<HertzDisc>(HertzDisc::of_radius(a), p, law, F_N), std::invalid_argument);
  };
  refused([](auto& p) { p.stiffness[1] = 0; });
  refused([](auto& p) { p.damping[2] = 0; });
  refused([](auto& p) { p.damping *= 0.49; });
  refused([](auto& p) { p.damping[0] = std::nan(""); });
  EXPECT_THROW(HalfFreedomPatch<HertzDisc>(HertzDisc::of_radius(a), parameters(1e3, 100), law, -1),
               std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::dynamics
