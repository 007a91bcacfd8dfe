// Beside SUNDIALS, in one run: smooth laws of scenes in data/scenes/simulate, error of the last place and of
// the time of an event against CPU time.
//
//     beside_sundials [--output CSV] [--short]
//
// example_4_7         elastoplastic point; its first stop
// figure_4_30         elastoplastic disc, corrected; the last time at 1 mm/s
// block_half_freedom  half a degree of freedom by its root; the first stop
// oscillation_lugre   LuGre under a load that oscillates; the last time at rest
// figure_4_15_tanh    Stribeck friction smoothed by tanh; the last time at rest
//
// Ours: Dormand and Prince with events on its dense output (dynamics/trajectory.h). SUNDIALS, with its root finding:
// BDF with Newton's method and Adams with functional iteration of CVODE, Dormand and Prince and Kvaerno's diagonally
// implicit method of ARKODE; and IDA for half a degree of freedom, a law that is implicit. It solves, of x, v, kappa
// and their rates, with u = v + dkappa/dt,
//
//     dx/dt = v,   dv/dt = c_0 kappa + c_1 dkappa/dt,   c_0 kappa + c_1 dkappa/dt = S(u) + V(u), or u = 0   (seed 4.34)
//
// where all others are given dkappa/dt by its root. The error is the difference from ours at a tolerance of 1e-14; how
// far Adams at 1e-13 is from that is told. --short repeats less.
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/bench/cpu_time.h>
#include <patchgrip/bench/sundials.h>
#include <patchgrip/dynamics/bristle_motion.h>
#include <patchgrip/dynamics/point_bristle.h>
#include <patchgrip/dynamics/trajectory.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::dynamics;
using patchgrip::bench::least_cpu_time;
using patchgrip::bench::SundialsFlow;
using patchgrip::bench::SundialsMethod;
using patchgrip::friction::HertzDisc;
using patchgrip::friction::RoundLimitSurface;

template <std::size_t n>
struct Problem {
  using State = std::array<double, n>;

  std::string name;
  State start;
  std::vector<double> ends;  // of the pieces between jumps of the load
  std::function<void(double t, const State&, State& rates)> rates;
  std::function<double(const State&)> watched;
  bool first;            // of its sign changes, else the last
  std::size_t at, size;  // the place in the state
  std::function<void(double t, const State&, const State& rates, State& residual)> residual = nullptr;  // if implicit
};

struct Answer {
  std::vector<double> place;
  double event = std::numeric_limits<double>::quiet_NaN();
  long evaluations = 0;
};

// `make(rates, start, t)` begins a piece: a Trajectory or SundialsFlow.
template <std::size_t n, class Make>
Answer solve(const Problem<n>& p, const Make& make) {
  auto y = p.start;
  double t = 0;
  Answer a;
  for (const double end : p.ends) {
    const double last = std::nextafter(end, t);
    auto flow = make([&](double at, const auto& x, auto& dx) { p.rates(std::min(at, last), x, dx); }, y, t);
    flow.watch([&](double, const auto& x) { return p.watched(x); });
    flow.run(end, [&](double at, const auto&, std::size_t) {
      if (!p.first || std::isnan(a.event)) a.event = at;
      return false;
    });
    y = flow.state();
    t = end;
    a.evaluations += flow.evaluations();
  }
  a.place.assign(y.begin() + static_cast<std::ptrdiff_t>(p.at), y.begin() + static_cast<std::ptrdiff_t>(p.at + p.size));
  return a;
}

template <std::size_t n>
Answer by_dopri5(const Problem<n>& p, double tolerance) {
  return solve(p, [&](auto rates, const auto& y, double t) {
    return Trajectory<n>(std::move(rates), y, t, {.tolerance = tolerance});
  });
}

template <std::size_t n>
Answer by_sundials(const Problem<n>& p, SundialsMethod method, double tolerance) {
  return solve(p, [&](auto rates, const auto& y, double t) {
    return SundialsFlow<n>(method, std::move(rates), y, t, tolerance);
  });
}

// By the residual alone; its load does not jump.
template <std::size_t n>
Answer by_ida(const Problem<n>& p, double tolerance) {
  return solve(p, [&](const auto&, const auto& y, double t) { return SundialsFlow<n>(p.residual, y, t, tolerance); });
}

// --- the scenes

// A point of 1 kg under F_N = 10 N: x, v, kappa. `rate(kappa, v)` is that of the bristle, `load(t)` acts.
template <class Rate, class Load>
Problem<3> point(std::string name, double v, double kappa, double end, bool first, const PointBristle& bristle,
                 const Law& law, const Rate& rate, const Load& load) {
  return {std::move(name),
          {0, v, kappa},
          {end},
          [=](double t, const auto& y, auto& dy) {
            const double dk = rate(bristle, law, 10, y[2], y[1]);
            dy = {y[1], load(t) + bristle_force(bristle, law, 10, y[2], dk, y[1]), dk};
          },
          [](const auto& y) { return y[1]; },
          first,
          0,
          1};
}

// 0 where dkappa/dt = `rate` [m/s]. The zone slides where it is pulled; a trial that has it slide back is rubbed as if
// it did not, so that friction does not jump.
double half_freedom_residual(const PointBristle& bristle, const Law& law, double normal_force, double kappa, double v,
                             double rate) {
  const double pull = bristle.c1 * v - bristle.c0 * kappa, u = v + rate;
  if (!(std::fabs(pull) > law.mu_static * normal_force)) return u;
  const double dry = patchgrip::friction::coefficient(law, {}, {u, 0, 0}) * normal_force;
  return (bristle_pull(bristle, kappa, rate) + std::copysign(dry, pull) - viscous_force(law, normal_force, u)) /
         bristle.c1;
}

double no_load(double) { return 0; }

Problem<3> half_freedom(const Law& law) {
  const PointBristle bristle{5000, 100};
  auto p = point("block_half_freedom", 4, 0, 1.5, true, bristle, law, half_freedom_exact_rate, no_load);
  p.residual = [=](double, const auto& y, const auto& dy, auto& r) {
    r = {dy[0] - y[1], dy[1] - bristle_force(bristle, law, 10, y[2], dy[2], y[1]),
         half_freedom_residual(bristle, law, 10, y[2], y[1], dy[2])};
  };
  return p;
}

Problem<2> smoothed_by_tanh() {
  const Law law = Law::stribeck(0.9, 0.5, 0.05);
  return {"figure_4_15_tanh",
          {0, 0},
          {0.6},
          [=](double t, const auto& y, auto& dy) {
            dy = {y[1], 12 * std::sin(10 * std::numbers::pi * t) + tanh_force(law, 10, 100, y[1])};
          },
          [](const auto& y) { return y[1]; },
          false,
          0,
          1};
}

Problem<11> disc_of_the_figures() {
  using Surface = RoundLimitSurface<HertzDisc>;
  const BristleMotion motion(
      PatchBristle<Surface>(Surface(HertzDisc::of_radius(0.2)), {{1000, 1000, 40}, {20, 20, 0.8}, 0.2},
                            Law::stribeck(1, 0.5, 0.05), 1),
      1, 1);
  return {"figure_4_30",
          {0, 0, 0, 0, 0, 0, 0.49 / 1000},
          {5, 15, 60},
          [=](double t, const auto& y, auto& dy) { dy = motion(Vector3(0.49, 0, t >= 5 && t < 15 ? 0.1167 : 0), y); },
          [](const auto& y) { return std::hypot(y[3], y[4], 0.2 * y[5]) - 1e-3; },
          false,
          0,
          3};
}

// --- what is measured

struct Run {
  double place_error, event_error, us;
};

double distance(const Answer& a, const Answer& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.place.size(); ++i) sum += (a.place[i] - b.place[i]) * (a.place[i] - b.place[i]);
  return std::sqrt(sum);
}

// The least time of those whose errors are both within `error`.
double time_for(const std::vector<Run>& runs, double error) {
  double least = std::numeric_limits<double>::infinity();
  for (const Run& r : runs) {
    if (r.place_error <= error && r.event_error <= error) least = std::min(least, r.us);
  }
  return least;
}

template <std::size_t n>
void measure(const Problem<n>& p, double seconds, std::ostream& csv) {
  const Answer truth = by_dopri5(p, 1e-14), other = by_sundials(p, SundialsMethod::adams, 1e-13);
  fmt::print("\n{}: truth by two ways apart by {:.1e} m, {:.1e} s\n", p.name, distance(truth, other),
             std::fabs(truth.event - other.event));
  fmt::print("  integrator    tolerance  error of place [m]  of event [s]  evaluations         us\n");
  const auto runs_of = [&](const char* integrator, const auto& solved) {
    std::vector<Run> runs;
    for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
      const Answer a = solved(tolerance);
      const double us = least_cpu_time([&] { solved(tolerance); }, seconds);
      runs.push_back({distance(a, truth), std::fabs(a.event - truth.event), us});
      const Run& r = runs.back();
      fmt::print("  {:<12} {:>10.0e} {:>19.1e} {:>13.1e} {:>12} {:>10.1f}\n", integrator, tolerance, r.place_error,
                 r.event_error, a.evaluations, us);
      fmt::print(csv, "{},{},{:e},{:e},{:e},{},{:e}\n", p.name, integrator, tolerance, r.place_error, r.event_error,
                 a.evaluations, us);
    }
    return runs;
  };
  const auto ours = runs_of("dopri5", [&](double tolerance) { return by_dopri5(p, tolerance); });
  std::vector<std::pair<std::string, std::vector<Run>>> theirs;
  for (const auto& [name, method] : {std::pair{"cvode_bdf", SundialsMethod::bdf},
                                     {"cvode_adams", SundialsMethod::adams},
                                     {"arkode_erk", SundialsMethod::dormand_prince},
                                     {"arkode_dirk", SundialsMethod::kvaerno}}) {
    theirs.emplace_back(name, runs_of(name, [&](double tolerance) { return by_sundials(p, method, tolerance); }));
  }
  if (p.residual) theirs.emplace_back("ida", runs_of("ida", [&](double tolerance) { return by_ida(p, tolerance); }));
  const auto part = [](double us, double their_us) {
    return std::isinf(us) || std::isinf(their_us) ? std::string("-") : fmt::format("{:.3g}", us / their_us);
  };
  for (const double error : {1e-4, 1e-6, 1e-8}) {
    const double us = time_for(ours, error);
    fmt::print("  CPU time for errors up to {:.0e} (-: not reached), ours of theirs:", error);
    for (const auto& [name, runs] : theirs) fmt::print(" {} {}", name, part(us, time_for(runs, error)));
    fmt::print("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("beside_sundials", "Smooth laws of friction beside SUNDIALS: error against time.",
                                     "repeat each measurement fewer times");
  line.read(argc, argv);
  const double seconds = line.is_short ? 0.005 : 0.1;
  std::ostringstream csv;
  fmt::print(csv, "# patchgrip {} beside_sundials\n", patchgrip::version);
  fmt::print(csv, "scene,integrator,tolerance,place_error_m,event_error_s,evaluations,us\n");
  const Law stribeck = Law::stribeck(1, 1 / 3., 0.1);
  measure(point("example_4_7", 4, 0, 8, true, {50, 1, 0, 0.9}, stribeck, elastoplastic_rate, no_load), seconds, csv);
  measure(disc_of_the_figures(), seconds, csv);
  measure(half_freedom(stribeck), seconds, csv);
  measure(point("oscillation_lugre", 0, -3 / 5000., 60, false, {5000, 10}, Law::stribeck(1, 0.5, 0.1), dahl_rate,
                [](double t) { return 3 * (1 + std::sin(2 * std::numbers::pi * t)); }),
          seconds, csv);
  measure(smoothed_by_tanh(), seconds, csv);
  return line.write([&](std::ostream& file) { file << csv.str(); });
}
