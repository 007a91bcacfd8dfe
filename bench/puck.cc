// A puck that slides and spins to rest: error of its stop against CPU time and evaluations of friction, for every law
// and integrator, in one run.
//
//     puck [--output CSV] [--short]
//
// 1 kg, R = 0.05 m, J = m R^2 / 2, v = 1 m/s, w = 20 rad/s, mu = 0.5, g = 9.81 m/s^2. The error of a law with bristles
// tends to what their give makes of the stop; it is told where the puck would stop by its last state that still slides
// for half a step, or at 0.01 m/s: 2 T / mu F_N D(v) later. The stack is the puck on a body of 1e9 kg that the ground
// holds. With libsundials-dev CVODE follows the laws of bristles, too, and IDA the implicit one as it is written,
// K kappa + D dkappa/dt = U^T L grad D(U e), e = v - dkappa/dt. --short repeats less and leaves out the finest.
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/bench/cpu_time.h>
#ifdef PATCHGRIP_WITH_SUNDIALS
#include <patchgrip/bench/sundials.h>
#endif
#include <patchgrip/dynamics/bristle_body.h>
#include <patchgrip/dynamics/bristle_motion.h>
#include <patchgrip/dynamics/half_freedom_patch.h>
#include <patchgrip/dynamics/rigid_motion.h>
#include <patchgrip/dynamics/stacked_bodies.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::dynamics;
using namespace patchgrip::friction;

constexpr double R = 0.05, J = R * R / 2, F_N = 9.81, mu = 0.5, L = mu * F_N, horizon = 0.4;

struct Stop {
  double time, distance;
  long evaluations;  // of friction
};

const auto no_load = [](double) { return Vector3(Vector3::Zero()); };

double kinetic(const Vector3& v) { return (v[0] * v[0] + v[1] * v[1] + J * v[2] * v[2]) / 2; }

// Where constant deceleration takes it from here; it moves on by half of its speed.
template <class P>
Stop stop_from(const P& disc, double t, const Vector3& place, const Vector3& v, long evaluations) {
  const double rest = 2 * kinetic(v) / (L * disc.dissipation({v[0], v[1], v[2]}));
  return {t + rest, place[0] + v[0] * rest / 2, evaluations};
}

PlanarState start() {
  PlanarState s;
  s.twist = {1, 0, 20};
  return s;
}

template <class P>
Stop rigid(const P& disc, double tolerance) {
  const auto r = RigidMotion(disc, 1, J, Law::coulomb(mu))({no_load, [](double) { return F_N; }}, start(), 0, horizon,
                                                           {.tolerance = tolerance});
  return {r.events.at(0).time, r.state.place[0], r.evaluations};
}

template <class P>
Stop return_mapping(const P& disc, double k, Method method, double h) {
  const BristleBody body(disc, {1, J, {k, k * R * R / 2}});
  PlanarState s = start(), last = s;
  double at = 0;
  long evaluations = 0;
  const auto steps = static_cast<long>(std::ceil(horizon / h));
  for (long i = 0; i < steps; ++i) {
    const StepResult r =
        body.step(s, h * static_cast<double>(i), h, method, no_load, [](double, const Vector3&) { return L; });
    evaluations += method == Method::sdirk2 ? 2 : 1;
    s = r.state;
    if (!r.slips) break;
    const Vector3& v = s.twist;
    if (kinetic(v) > h / 4 * L * disc.dissipation({v[0], v[1], v[2]})) last = s, at = h * static_cast<double>(i + 1);
  }
  return stop_from(disc, at, last.place, last.twist, evaluations);
}

template <class P>
Stop stack(const P& disc, double k, double h) {
  const StackedBodies bodies(UniformDisc::of_radius(1), disc, {1e9, 1e9, {k, k}}, {1, J, {k, k * R * R / 2}});
  StackState s, last;
  s.twist << 0, 0, 0, 1, 0, 20;
  last = s;
  const auto no_loads = [](double) { return Vector6(Vector6::Zero()); };
  const auto limit = [](int which, double, const Vector3&) { return which == 0 ? 10 * L : L; };
  double at = 0;
  long evaluations = 0;
  const auto steps = static_cast<long>(std::ceil(horizon / h));
  for (long i = 0; i < steps; ++i) {
    const StackStep r = bodies.step(s, h * static_cast<double>(i), h, Method::sdirk2, no_loads, limit);
    evaluations += 2 * r.sweeps;
    s = r.state;
    if (!r.slips[1]) break;
    const Vector3 v = s.twist.tail<3>();
    if (kinetic(v) > h / 4 * L * disc.dissipation({v[0], v[1], v[2]})) last = s, at = h * static_cast<double>(i + 1);
  }
  return stop_from(disc, at, last.place.tail<3>(), last.twist.tail<3>(), evaluations);
}

// --- bristles as differential equations

template <class P>
auto elastoplastic_motion(const P& disc, double k) {
  using Surface = RoundLimitSurface<P>;
  return BristleMotion(
      PatchBristle<Surface>(Surface(disc), {{k, k, k * R * R / 2}, {0, 0, 0}, R}, Law::coulomb(mu), F_N), 1, J);
}

template <class P>
auto half_freedom_motion(const P& disc, double k, double d) {
  return BristleMotion(HalfFreedomPatch(disc, {{k, k, k * R * R / 2}, {d, d, d * R * R / 2}}, Law::coulomb(mu), F_N), 1,
                       J);
}

using BristleState = Trajectory<11>::State;

constexpr BristleState bristle_start{0, 0, 0, 1, 0, 20};
constexpr double slow = 0.01;  // [m/s]

template <class Motion>
auto rates_of(const Motion& motion) {
  return [&](double, const BristleState& x, BristleState& dx) { dx = motion(Vector3::Zero(), x); };
}

template <class P, class Flow>
Stop stop_of(const P& disc, Flow&& flow) {
  flow.watch([](double, const auto& x) { return std::hypot(x[3], x[4], R * x[5]) - slow; });
  flow.run(horizon, [](double, const auto&, std::size_t) { return true; });
  const auto x = flow.state();
  return stop_from(disc, flow.time(), {x[0], x[1], x[2]}, {x[3], x[4], x[5]}, flow.evaluations());
}

template <class P, class Motion>
Stop by_dopri5(const P& disc, const Motion& motion, double tolerance) {
  return stop_of(disc, Trajectory<11>(rates_of(motion), bristle_start, 0, {.tolerance = tolerance}));
}

#ifdef PATCHGRIP_WITH_SUNDIALS
template <class P, class Motion>
Stop by_cvode(const P& disc, const Motion& motion, patchgrip::bench::SundialsMethod method, double tolerance) {
  return stop_of(disc, patchgrip::bench::SundialsFlow<11>(method, rates_of(motion), bristle_start, 0, tolerance));
}

// Half a degree of freedom, its zone sliding: place, twist and kappa as in bristle_motion.h.
template <class P>
Stop half_freedom_by_ida(const P& disc, double k, double d, double tolerance) {
  using Flow = patchgrip::bench::SundialsFlow<9>;
  const Vector3 K(k, k, k * R * R / 2), D(d, d, d * R * R / 2);
  const auto residual = [&](double, const Flow::State& x, const Flow::State& dx, Flow::State& r) {
    const Vector3 kappa(x[6], x[7], x[8]), rate(dx[6], dx[7], dx[8]);
    const Vector3 e = turned({x[3], x[4], x[5]}, x[8] - x[2]) - rate;
    const Vector3 s = K.cwiseProduct(kappa) + D.cwiseProduct(rate), pull = turned(s, x[2] - x[8]);
    const Wrench zone = zone_wrench(kappa, s);
    const Wrench g = disc.gradient({e[0] + kappa[1] * e[2], e[1] - kappa[0] * e[2], e[2]});
    r = {dx[0] - x[3],        dx[1] - x[4],       dx[2] - x[5],       dx[3] + pull[0], dx[4] + pull[1],
         J * dx[5] + pull[2], zone.fx - L * g.fx, zone.fy - L * g.fy, zone.m - L * g.m};
  };
  return stop_of(disc, Flow(residual, {0, 0, 0, 1, 0, 20}, 0, tolerance));
}
#endif

// Steps of Runge and Kutta, all alike.
template <class P>
Stop elastoplastic_rk4(const P& disc, double k, double h) {
  const auto motion = elastoplastic_motion(disc, k);
  const auto rates = [&](const BristleState& x) { return motion(Vector3::Zero(), x); };
  const auto moved = [](BristleState x, double step, const BristleState& dx) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += step * dx[i];
    return x;
  };
  BristleState y = bristle_start;
  long evaluations = 0;
  double t = 0;
  while (t < horizon && std::hypot(y[3], y[4], R * y[5]) > slow) {
    const BristleState a = rates(y), b = rates(moved(y, h / 2, a)), c = rates(moved(y, h / 2, b)),
                       d = rates(moved(y, h, c));
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    t += h;
    evaluations += 4;
  }
  return stop_from(disc, t, {y[0], y[1], y[2]}, {y[3], y[4], y[5]}, evaluations);
}

struct Truth {
  const char* name;
  double time, distance;
};

template <class P>
void measure(const Truth& truth, const P& disc, bool is_short, std::ostream& csv) {
  fmt::print(
      "{:<12} law             integrator       setting  error of stop [s]  of distance [m]  evaluations       us\n",
      truth.name);
  const auto row = [&](const char* law, const char* integrator, double setting, const auto& run) {
    const Stop stop = run();
    const double us = patchgrip::bench::least_cpu_time(run, is_short ? 0.01 : 0.1);
    const double time = std::fabs(stop.time - truth.time), way = std::fabs(stop.distance - truth.distance);
    fmt::print("{:<12} {:<15} {:<15} {:>8.1e} {:>18.1e} {:>16.1e} {:>12} {:>8.1f}\n", truth.name, law, integrator,
               setting, time, way, stop.evaluations, us);
    fmt::print(csv, "{},{},{},{:e},{:e},{:e},{},{:e}\n", truth.name, law, integrator, setting, time, way,
               stop.evaluations, us);
  };
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13})
    row("rigid", "stretched", tolerance, [&] { return rigid(disc, tolerance); });
  std::vector<double> steps{1e-2, 4e-3, 2e-3, 1e-3, 4e-4, 1e-4};
  if (!is_short) steps.push_back(2e-5);
  for (const double h : steps)
    row("return_mapping", "sdirk2", h, [&] { return return_mapping(disc, 1e8, Method::sdirk2, h); });
  for (const double h : steps)
    row("return_mapping", "implicit_euler", h, [&] { return return_mapping(disc, 1e8, Method::implicit_euler, h); });
  for (const double h : steps) row("stack", "sdirk2", h, [&] { return stack(disc, 1e8, h); });
  const auto plastic = elastoplastic_motion(disc, 1e5);
  const auto half = half_freedom_motion(disc, 1e6, 1e3);
  for (const double tolerance : {1e-4, 1e-6, 1e-8})
    row("elastoplastic", "dopri5", tolerance, [&] { return by_dopri5(disc, plastic, tolerance); });
  for (const double tolerance : {1e-4, 1e-6, 1e-8})
    row("half_freedom", "dopri5", tolerance, [&] { return by_dopri5(disc, half, tolerance); });
  for (const double h : {1e-4, 4e-5, 1e-5})
    row("elastoplastic", "rk4", h, [&] { return elastoplastic_rk4(disc, 1e5, h); });
#ifdef PATCHGRIP_WITH_SUNDIALS
  using patchgrip::bench::SundialsMethod;
  for (const auto& [integrator, method] :
       {std::pair{"cvode_bdf", SundialsMethod::bdf}, {"cvode_adams", SundialsMethod::adams}}) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8})
      row("elastoplastic", integrator, tolerance, [&] { return by_cvode(disc, plastic, method, tolerance); });
    for (const double tolerance : {1e-4, 1e-6, 1e-8})
      row("half_freedom", integrator, tolerance, [&] { return by_cvode(disc, half, method, tolerance); });
  }
  for (const double tolerance : {1e-4, 1e-6, 1e-8})
    row("half_freedom", "ida", tolerance, [&] { return half_freedom_by_ida(disc, 1e6, 1e3, tolerance); });
#endif
  fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("puck", "A puck slides to rest: error of the stop against time, for every law.",
                                     "repeat each measurement fewer times");
  line.read(argc, argv);
  std::ostringstream csv;
  fmt::print(csv, "# patchgrip {} puck\n", patchgrip::version);
  fmt::print(csv, "disc,law,integrator,setting,stop_error_s,distance_error_m,evaluations,us\n");
  measure({"hertz_disc", .28808448600715, .12928855096844}, HertzDisc::of_radius(R), line.is_short, csv);
  measure({"uniform_disc", .27325143366306, .12994846567449}, UniformDisc::of_radius(R), line.is_short, csv);
  return line.write([&](std::ostream& file) { file << csv.str(); });
}
