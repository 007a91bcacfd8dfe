// Creep of a held point against the step: 3 N (1 + sin 2 pi t) under a limit of 10 N, for every law and integrator.
//
//     hold [--output CSV] [--short]
//
// 1 kg, mu_s = 1, mu_k = 0.5, v_S = 0.1 m/s, F_N = 10 N; bristles of 5000 N/m and 10 N s/m (Dahl: none), a of tanh
// 100 s/m. The rate is the way from t = 20 s to 60 s, at the same phase, per second; "diverged" where it leaves 1 m.
// Explicit steps of a bristle are stable up to 2.8 sqrt(m / c_0) = 0.04 s at most, of tanh up to 2.8 m / (a mu_s F_N) =
// 0.0028 s. --short leaves out the finest steps.
#include <fmt/ostream.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/dynamics/bristle_body.h>
#include <patchgrip/dynamics/point_bristle.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::dynamics;

constexpr double m = 1, F_N = 10, c0 = 5000, c1 = 10, steepness = 100, first = 20, last = 60;
const Law law = Law::stribeck(1, 0.5, 0.1);

double load(double t) { return 3 + 3 * std::sin(2 * std::numbers::pi * t); }

using State = std::array<double, 3>;  // x, v, kappa

State with_bristle(const PointBristle& b, double t, const State& y, double rate) {
  return {y[1], (load(t) + bristle_force(b, law, F_N, y[2], rate, y[1])) / m, rate};
}

State lugre(double t, const State& y) {
  const PointBristle b{c0, c1};
  return with_bristle(b, t, y, dahl_rate(b, law, F_N, y[2], y[1]));
}
State dahl(double t, const State& y) {
  const PointBristle b{c0};
  return with_bristle(b, t, y, dahl_rate(b, law, F_N, y[2], y[1]));
}
State elastoplastic(double t, const State& y) {
  const PointBristle b{c0, c1};
  return with_bristle(b, t, y, elastoplastic_rate(b, law, F_N, y[2], y[1]));
}
State regularised(double t, const State& y) { return {y[1], (load(t) + tanh_force(law, F_N, steepness, y[1])) / m, 0}; }

// [m/s]; infinite where it diverged.
double creep_of(double before, double after) {
  const double way = std::fabs(after - before);
  return way < 1 ? way / (last - first) : std::numeric_limits<double>::infinity();
}

double creep_rk4(const std::function<State(double, const State&)>& rates, bool has_bristle, int per_second) {
  const double h = 1. / per_second;
  State y{0, 0, has_bristle ? -load(0) / c0 : 0};
  const auto moved = [](State x, double step, const State& dx) {
    for (std::size_t i = 0; i < 3; ++i) x[i] += step * dx[i];
    return x;
  };
  double before = 0;
  for (long n = 0; n < static_cast<long>(last) * per_second; ++n) {
    const double t = h * static_cast<double>(n);
    if (n == static_cast<long>(first) * per_second) before = y[0];
    const State a = rates(t, y), b = rates(t + h / 2, moved(y, h / 2, a)), c = rates(t + h / 2, moved(y, h / 2, b)),
                d = rates(t + h, moved(y, h, c));
    for (std::size_t i = 0; i < 3; ++i) y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }
  return creep_of(before, y[0]);
}

double creep_of_return_mapping(Method method, int per_second) {
  const double h = 1. / per_second, a = 0.01;
  const BristleBody body(patchgrip::friction::HertzDisc::of_radius(a), {m, 1e-4, {c0, c0 * a * a}, c1, c1 * a * a});
  PlanarState s;
  s.anchor[0] = -load(0) / c0;
  double before = 0;
  for (long n = 0; n < static_cast<long>(last) * per_second; ++n) {
    if (n == static_cast<long>(first) * per_second) before = s.anchor[0];
    s = body.step(
                s, h * static_cast<double>(n), h, method, [](double t) { return Vector3(load(t), 0, 0); },
                [](double, const Vector3& v) { return std::fabs(stribeck_force(law, F_N, std::max(v[0], 1e-300))); })
            .state;
  }
  return creep_of(before, s.anchor[0]);
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("hold", "Creep of a held point against the step, for every law and integrator.",
                                     "leave out the finest steps");
  line.read(argc, argv);
  std::vector<int> per_second{10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000};
  if (!line.is_short) per_second.push_back(100000);

  struct Run {
    const char* law;
    const char* integrator;
    std::function<double(int)> creep;
  };
  const std::vector<Run> runs{
      {"return_mapping", "sdirk2", [](int n) { return creep_of_return_mapping(Method::sdirk2, n); }},
      {"return_mapping", "implicit_euler", [](int n) { return creep_of_return_mapping(Method::implicit_euler, n); }},
      {"elastoplastic", "rk4", [](int n) { return creep_rk4(elastoplastic, true, n); }},
      {"lugre", "rk4", [](int n) { return creep_rk4(lugre, true, n); }},
      {"dahl", "rk4", [](int n) { return creep_rk4(dahl, true, n); }},
      {"tanh", "rk4", [](int n) { return creep_rk4(regularised, false, n); }}};
  std::ostringstream csv;
  fmt::print(csv, "# patchgrip {} hold\n", patchgrip::version);
  fmt::print(csv, "law,integrator,step_s,creep_m_per_s\n");
  fmt::print("law             integrator         step [s]  creep [m/s]\n");
  for (const Run& run : runs) {
    for (const int n : per_second) {
      const double creep = run.creep(n);
      fmt::print("{:<15} {:<15} {:>11.0e}  {}\n", run.law, run.integrator, 1. / n,
                 std::isfinite(creep) ? fmt::format("{:.1e}", creep) : "diverged");
      fmt::print(csv, "{},{},{:e},{:e}\n", run.law, run.integrator, 1. / n, creep);
    }
  }
  return line.write([&](std::ostream& file) { file << csv.str(); });
}
