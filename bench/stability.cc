// Where fixed steps of a law of friction are right, wrong or diverge: step against stiffness and damping of bristles.
//
//     stability [--output CSV] [--short]
//
// Example 4.7 of Keppler 2006: 1 kg, 4 m/s, F_N = 10 N, mu_s = 1, mu_k = 1/3, v_S = 0.1 m/s, damping ratio zeta of the
// stick 0.0707 as there, 0.5 and 2, at every stiffness. "right" is a place at t = 3 s within 5 mm of what the law
// itself gives: by adaptive steps, or SDIRK2 of 0.1 ms, up to 2e5 N/m; stiffer by the rigid stop, from which bristles
// differ by less. "diverged" is beyond 10 m.
// Explicit steps of Runge and Kutta are stable up to 2.785 S / (c_0 v) while it slides, and in stick up to 2.93, 2.62
// and 0.75 sqrt(m / c_0) with these three zeta.
// --short takes every other step.
#include <fmt/ostream.h>

#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/dynamics/bristle_body.h>
#include <patchgrip/dynamics/point_bristle.h>
#include <patchgrip/dynamics/point_motion.h>
#include <patchgrip/dynamics/trajectory.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::dynamics;

constexpr double m = 1, v0 = 4, F_N = 10, end = 3, stiff = 2e5;
const Law law = Law::stribeck(1, 1. / 3, 0.1);

struct Bristle {
  double c0, zeta;

  double damping() const { return 2 * zeta * std::sqrt(c0 * m); }
  PointBristle of_point() const { return {c0, damping()}; }
};

using State = std::array<double, 3>;  // x, v, kappa
using Rate = double (*)(const PointBristle&, const Law&, double, double, double) noexcept;

double place_by_rk4(Rate rate, const Bristle& bristle, double h) {
  const PointBristle b = bristle.of_point();
  const auto rates = [&](const State& y) {
    const double dk = rate(b, law, F_N, y[2], y[1]);
    return State{y[1], bristle_force(b, law, F_N, y[2], dk, y[1]) / m, dk};
  };
  const auto moved = [](State x, double step, const State& dx) {
    for (std::size_t i = 0; i < 3; ++i) x[i] += step * dx[i];
    return x;
  };
  State y{0, v0, 0};
  const auto steps = static_cast<long>(std::ceil(end / h));
  for (long n = 0; n < steps; ++n) {
    const State a = rates(y), k2 = rates(moved(y, h / 2, a)), k3 = rates(moved(y, h / 2, k2)),
                k4 = rates(moved(y, h, k3));
    for (std::size_t i = 0; i < 3; ++i) y[i] += h / 6 * (a[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    if (!(std::fabs(y[0]) < 100)) break;
  }
  return y[0];
}

double place_by_return_mapping(Method method, const Bristle& b, double h) {
  const BristleBody body(patchgrip::friction::HertzDisc::of_radius(0.01), {m, 1e-4, {b.c0, 1}, b.damping(), 0});
  PlanarState s;
  s.twist[0] = v0;
  const auto steps = static_cast<long>(std::ceil(end / h));
  for (long n = 0; n < steps; ++n) {
    s = body.step(
                s, h * static_cast<double>(n), h, method, [](double) { return Vector3(Vector3::Zero()); },
                [](double, const Vector3& v) {
                  return v[0] == 0 ? law.mu_static * F_N : std::fabs(stribeck_force(law, F_N, v[0]));
                })
            .state;
  }
  return s.place[0];
}

double place_by_adaptive_steps(Rate rate, const Bristle& bristle) {
  const PointBristle b = bristle.of_point();
  Trajectory<3> motion(
      [&](double, const State& y, State& dy) {
        const double dk = rate(b, law, F_N, y[2], y[1]);
        dy = {y[1], bristle_force(b, law, F_N, y[2], dk, y[1]) / m, dk};
      },
      {0, v0, 0}, 0, {.tolerance = 1e-8});
  motion.run(end);
  return motion.state()[0];
}

double rigid_place() {
  return PointMotion({m}, law)({[](double) { return 0.; }, [](double) { return F_N; }}, {0, v0}, 0, end).state.x;
}

const char* verdict(double x, double truth) {
  if (!(std::fabs(x) < 10)) return "diverged";
  return std::fabs(x - truth) < 5e-3 ? "right" : "wrong";
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("stability", "Where fixed steps of a law of friction are right, wrong or diverge.",
                                     "take every other step");
  line.read(argc, argv);
  struct Run {
    const char* law;
    const char* integrator;
    std::function<double(const Bristle&, double)> place;
    std::function<double(const Bristle&)> truth;
  };
  const auto by_sdirk2 = [](const Bristle& b) { return place_by_return_mapping(Method::sdirk2, b, 1e-4); };
  const std::vector<Run> runs{
      {"lugre", "rk4", [](const Bristle& b, double h) { return place_by_rk4(dahl_rate, b, h); },
       [](const Bristle& b) { return place_by_adaptive_steps(dahl_rate, b); }},
      {"elastoplastic", "rk4", [](const Bristle& b, double h) { return place_by_rk4(elastoplastic_rate, b, h); },
       [](const Bristle& b) { return place_by_adaptive_steps(elastoplastic_rate, b); }},
      {"return_mapping", "implicit_euler",
       [](const Bristle& b, double h) { return place_by_return_mapping(Method::implicit_euler, b, h); }, by_sdirk2},
      {"return_mapping", "sdirk2",
       [](const Bristle& b, double h) { return place_by_return_mapping(Method::sdirk2, b, h); }, by_sdirk2}};
  std::ostringstream csv;
  fmt::print(csv, "# patchgrip {} stability\n", patchgrip::version);
  fmt::print(csv, "law,integrator,damping_ratio,stiffness_N_per_m,step_s,place_m,verdict\n");
  const int stride = line.is_short ? 2 : 1;
  for (const Run& run : runs) {
    for (const double zeta : {0.0707, 0.5, 2.}) {
      fmt::print("{}, {}, zeta = {}: longest step of those that are right with all below, against c_0\n", run.law,
                 run.integrator, zeta);
      for (int i = 0; i <= 12; ++i) {
        const Bristle bristle{50 * std::pow(10, i / 2.), zeta};
        const double truth = bristle.c0 < stiff ? run.truth(bristle) : rigid_place();
        double longest = 0;
        bool all = true;
        for (int j = 0; j <= 16; j += stride) {
          const double h = 1e-5 * std::pow(10, j / 4.), x = run.place(bristle, h);
          const std::string is = verdict(x, truth);
          all = all && is == "right";
          if (all) longest = h;
          fmt::print(csv, "{},{},{},{:e},{:e},{:e},{}\n", run.law, run.integrator, zeta, bristle.c0, h, x, is);
        }
        fmt::print("  {:>8.1e} N/m  {}\n", bristle.c0, longest > 0 ? fmt::format("{:.1e} s", longest) : "none");
      }
    }
  }
  return line.write([&](std::ostream& file) { file << csv.str(); });
}
