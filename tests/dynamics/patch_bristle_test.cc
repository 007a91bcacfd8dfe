// Elastoplastic bristles under a patch: the disc of the seed's figures 4.30 and 4.31, steady sliding, dissipation.
#include <patchgrip/dynamics/patch_bristle.h>

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <patchgrip/dynamics/bristle_motion.h>
#include <patchgrip/dynamics/trajectory.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/tests/dynamics/dynamics_table.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::dynamics {
namespace {

using friction::HertzDisc;
using friction::Law;
using Surface = friction::RoundLimitSurface<HertzDisc>;
using testing::cases;
using testing::uniform;

Vector3 vector(const nlohmann::json& values) {
  return {values[0].get<double>(), values[1].get<double>(), values[2].get<double>()};
}

using Motion = BristleMotion<PatchBristle<Surface>>;

// Figures 4.30 and 4.31: a disc under a steady force, and a moment for ten seconds.
TEST(PatchBristle, TheDiscOfTheFiguresComesToRest) {
  const auto& entry = table()["misc"]["disc_example_fig_4_30"];
  const auto& p = entry["parameters"];
  const double a = p["aK"], on = p["t1"], off = p["t2"], Mz = p["Mz"], force = number(entry["F_x_N"]);
  const Motion disc(
      PatchBristle<Surface>(Surface(HertzDisc::of_radius(a)), {vector(p["K"]), vector(p["D"]), a},
                            Law::stribeck(number(entry["mu_H_F_N"]), number(entry["mu_Gl_F_N"]), p["vS"]), 1),
      p["m"], p["J"]);
  Motion::State y{};
  y[6] = force / p["K"][0].get<double>();
  const double stored = disc.stored_energy(y);
  const auto& states = entry["states_x_y_phi_vx_vy_w_k1_k2_k3"];
  double t = 0, stop = 0;
  for (const auto& [until, moment] : {std::pair{on, 0.}, {off, Mz}, {60., 0.}}) {
    const Vector3 load(force, 0, moment);
    Motion::Flow motion([&](double, const Motion::State& s, Motion::State& r) { r = disc(load, s); }, y, t,
                        {.tolerance = 1e-11});
    motion.watch([&](double, const Motion::State& s) {
      return std::sqrt(s[3] * s[3] + s[4] * s[4] + a * a * s[5] * s[5]) - 1e-3;
    });
    const auto note = [&](double at, const Motion::State&, std::size_t) {
      stop = at;
      return false;
    };
    for (const char* const mark : {"4.9", "6.0", "10.0", "15.0", "20.0", "30.0", "60.0"}) {
      const double at = std::stod(mark);
      if (at <= t || at > until) continue;
      motion.run(at, note);
      for (std::size_t i = 0; i < (at == 60 ? 3 : 9); ++i)
        EXPECT_NEAR(motion.state()[i], number(states[mark][i]), 1e-7) << i << " at " << at;
    }
    motion.run(until, note);
    y = motion.state();
    t = until;
  }
  EXPECT_NEAR(stop, number(entry["last_time_speed_sqrt(v2+(aK w)2)>1e-3"]), 1e-7);
  EXPECT_NEAR(disc.kinetic_energy(y) + disc.stored_energy(y) - stored, y[9] - y[10], 1e-9 * y[9]);
}

PatchBristleParameters parameters(BristleForm form) { return {{1e4, 1e4, 4}, {0, 0, 0}, 0.01, form, 0.99, {1, 1, 1}}; }

// At a fixed twist, kappa small, the springs come to carry the Stribeck wrench; as printed they do not.
TEST(PatchBristle, SlidesWithTheStribeckWrench) {
  const HertzDisc patch = HertzDisc::of_radius(0.02);
  const Law law = Law::stribeck(0.8, 0.5, 0.05);
  for (const BristleForm form : {BristleForm::corrected, BristleForm::printed}) {
    PatchBristleParameters p = parameters(form);
    p.stiffness *= 1e3;
    const PatchBristle<Surface> bristle(Surface(patch), p, law, 2);
    const Vector3 v(0.03, 0.01, 1.5);
    Trajectory<3> motion(
        [&](double, const auto& y, auto& r) {
          const Vector3 rate = bristle({y[0], y[1], y[2]}, v).rate;
          r = {rate[0], rate[1], rate[2]};
        },
        {0, 0, 0}, 0, {.tolerance = 1e-11});
    motion.run(0.05);
    const auto& k = motion.state();
    const friction::Wrench s = spring_wrench(p, {k[0], k[1], k[2]});
    const friction::Wrench t = friction::friction_wrench(law, 2, patch, {v[0], v[1], v[2]}).value;
    const double off = std::hypot(s.fx + t.fx, s.fy + t.fy) + std::fabs(s.m + t.m) / 0.02;
    if (form == BristleForm::corrected) {
      EXPECT_LE(off, 2e-4);
    } else {
      EXPECT_GE(off, 0.1);
    }
  }
}

TEST(PatchBristle, IsTheScalarLawInOneDirection) {
  const HertzDisc patch = HertzDisc::of_radius(0.02);
  const PatchBristle<Surface> bristle(Surface(patch), parameters(BristleForm::corrected), Law::coulomb(0.5), 2);
  const PatchBristle<Surface> printed(Surface(patch), parameters(BristleForm::printed), Law::coulomb(0.5), 2);
  for (const double share : {-0.5, 0.5, 0.993, 0.999, 1.2}) {
    const double kappa = share * 1 / 1e4, v = 0.3;
    const double x = std::clamp((share - 0.99) / 0.01, 0., 1.), beta = x * x * (3 - 2 * x);
    const double expected = v * (1 - beta * share);
    EXPECT_NEAR(bristle({kappa, 0, 0}, {v, 0, 0}).rate[0], expected, 1e-12);
    EXPECT_NEAR(printed({kappa, 0, 0}, {v, 0, 0}).rate[0], expected, 1e-12);
    EXPECT_NEAR(bristle({0, -kappa, 0}, {0, -v, 0}).rate[1], -expected, 1e-12);
  }
}

// Spring and friction together take power from the motion: random states up to the limit, no dampers.
TEST(PatchBristle, DissipatesAtEveryState) {
  std::mt19937_64 engine(1);
  const friction::Rectangle patch = friction::Rectangle::of_sides(0.1, 0.01);
  const friction::LimitSurface surface(patch);
  const double L = patch.gradient({0, 0, 1}).m;
  const PatchBristle bristle(surface, {{1e5, 1e5, 1e5 * L * L}, {0, 0, 0}, L}, Law::coulomb(0.5), 2);
  for (int i = 0; i < cases(2000); ++i) {
    friction::Wrench s{uniform(engine, -1, 1), uniform(engine, -1, 1), L * uniform(engine, -1, 1)};
    const double k = uniform(engine, 0, 1) / surface.gauge(s).value;
    const Vector3 kappa = Vector3(k * s.fx, k * s.fy, k * s.m).cwiseQuotient(bristle.parameters().stiffness);
    const Vector3 v(uniform(engine, -1, 1), uniform(engine, -1, 1), uniform(engine, -1, 1) / L);
    const BristleRates r = bristle(kappa, v);
    const double stored = kappa.cwiseProduct(bristle.parameters().stiffness).dot(r.rate);
    EXPECT_LE(r.wrench.dot(v) + stored, 1e-12);
  }
}

TEST(PatchBristle, BadInputIsRefused) {
  const Surface surface(HertzDisc::of_radius(0.02));
  const auto refused = [&](auto change) {
    PatchBristleParameters p = parameters(BristleForm::corrected);
    change(p);
    EXPECT_THROW(PatchBristle<Surface>(surface, p, Law::coulomb(0.5), 2), std::invalid_argument);
  };
  refused([](auto& p) { p.stiffness[1] = 0; });
  refused([](auto& p) { p.damping[2] = -1; });
  refused([](auto& p) { p.length = 0; });
  refused([](auto& p) { p.elastic_share = 1; });
  refused([](auto& p) { p.nu0[0] = 0; });
  EXPECT_THROW(PatchBristle<Surface>(surface, parameters(BristleForm::corrected), Law::coulomb(0.5), -2),
               std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::dynamics
