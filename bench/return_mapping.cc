// Return mapping: its time against that of the friction wrench, and what it takes on any patch, in one run.
//
//     return_mapping [--output CSV] [--states N] [--short]
//
// States on the Hertz disc have |F| / |M| per radius log-uniform in 1e-3 .. 1e3 and a stiffness ratio k a^2 / k_r
// log-uniform in 0.1 .. 10. "mixed": overshoot g / L uniform in 0.5 .. 3, "slip" in 1 .. 11, "inside" the same with the
// pole of the slip inside, "stick" in 0 .. 1. N is the number of trials that must not fail, and a fiftieth of it a
// patch: overshoot 1e-12 .. 1e9, stiffness ratio 1e-6 .. 1e6. --short repeats less.
#include <fmt/ostream.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/bench/keep.h>
#include <patchgrip/bench/random.h>
#include <patchgrip/dynamics/return_mapping.h>
#include <patchgrip/dynamics/round_return_mapping.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::dynamics;
using namespace patchgrip::friction;
using patchgrip::bench::keep;
using patchgrip::bench::log_uniform;
using patchgrip::bench::uniform;

// Least CPU time of one of `all` [ns].
template <class Item, class Function>
double least_time(const std::vector<Item>& all, int repetitions, const Function& function) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < repetitions; ++k) {
    const std::clock_t start = std::clock();
    for (const Item& item : all) function(item);
    least = std::min(least, static_cast<double>(std::clock() - start));
  }
  return 1e9 * least / CLOCKS_PER_SEC / static_cast<double>(all.size());
}

struct State {
  Wrench trial;
  RoundStiffness K;
};

// Unit radius, L = 1.
template <class P>
State draw(std::mt19937_64& engine, const RoundLimitSurface<P>& surface, double overshoot, double ratio, double rho) {
  const double phi = uniform(engine, 0, 2 * std::numbers::pi), sign = uniform(engine, -1, 1) < 0 ? -1 : 1;
  const Wrench t{ratio * std::cos(phi), ratio * std::sin(phi), sign};
  const double k = overshoot / surface.gauge(t).value;
  return {{k * t.fx, k * t.fy, k * t.m}, {1e5, 1e5 / rho}};
}

struct Mix {
  const char* name;
  double lo, hi;  // of g / L
  bool inside;    // poles
  double target;  // times the wrench
};

void print_hertz(int repetitions, std::ostream& csv) {
  const HertzDisc disc = HertzDisc::of_radius(1);
  const RoundReturnMapping mapping(disc);
  const RoundLimitSurface surface(disc);
  std::mt19937_64 engine(5);
  std::vector<Twist> mixed, inside;
  for (int i = 0; i < 1 << 14; ++i) {
    const double phi = uniform(engine, 0, 2 * std::numbers::pi);
    const auto about = [&](double x) { return twist_about({x * std::cos(phi), x * std::sin(phi)}, 1); };
    mixed.push_back(about(log_uniform(engine, 1e-3, 1e3)));
    inside.push_back(about(uniform(engine, 0, 1)));
  }
  const auto wrench = [&](const Twist& v) { keep(disc.gradient(v)); };
  fmt::print("Hertz disc     ns a state   of the wrench's   target   evaluations\n");
  for (const Mix& mix : {Mix{"mixed", 0.5, 3, false, 8}, Mix{"slip", 1, 11, false, 8}, Mix{"inside", 1, 11, true, 12},
                         Mix{"stick", 0, 1, false, 2}}) {
    std::vector<State> states;
    double evaluations = 0;
    while (states.size() < 1 << 14) {
      const State s = draw(engine, surface, uniform(engine, mix.lo, mix.hi), log_uniform(engine, 1e-3, 1e3),
                           log_uniform(engine, 0.1, 10));
      const Returned r = mapping(s.trial, 1, s.K);
      if (mix.inside && std::hypot(r.slip.vx, r.slip.vy) > std::fabs(r.slip.w)) continue;
      evaluations += r.evaluations;
      states.push_back(s);
    }
    double ns = std::numeric_limits<double>::infinity(), one = ns;
    for (int k = 0; k < repetitions; ++k) {
      ns = std::min(ns, least_time(states, 1, [&](const State& s) { keep(mapping(s.trial, 1, s.K)); }));
      one = std::min(one, least_time(mix.inside ? inside : mixed, 1, wrench));
    }
    const double ratio = ns / one;
    fmt::print("{:<12} {:>12.1f} {:>17.2f} {:>8} {:>13.2f}{}\n", mix.name, ns, ratio, fmt::format("<= {}", mix.target),
               evaluations / static_cast<double>(states.size()), ratio > mix.target ? "  missed" : "");
    fmt::print(csv, "hertz_disc,{},{},{},{}\n", mix.name, ns, ratio, evaluations / static_cast<double>(states.size()));
  }
}

// Of a closest point: how far the mapped wrench is from one, in the norm of K^-1 [L].
template <class P>
void print_trials(const char* name, const P& disc, int count) {
  const RoundReturnMapping<P> mapping(disc);
  const RoundLimitSurface surface(disc);
  std::mt19937_64 engine(11);
  long sum = 0, failures = 0;
  int most = 0;
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    const double overshoot = 1 + log_uniform(engine, 1e-12, 1e9), rho = log_uniform(engine, 1e-6, 1e6);
    const State s = draw(engine, surface, overshoot, log_uniform(engine, 1e-12, 1e12), rho);
    const Returned r = mapping(s.trial, 1, s.K);
    sum += r.evaluations;
    most = std::max(most, r.evaluations);
    const double off = std::max(r.wrench.force_error / std::max(1., std::sqrt(rho)),
                                r.wrench.moment_error / std::max(1., 1 / std::sqrt(rho)));
    worst = std::max(worst, off);
    failures += !r.slips || !(off < 1e-14) || power(r.wrench.value, r.slip) < 0;
  }
  fmt::print("{:<14} {:>8} trials: evaluations {:.2f} in the mean, at most {}, largest error {:.1e} L, {} failures\n",
             name, count, static_cast<double>(sum) / count, most, worst, failures);
}

template <class P>
void print_patch(const char* name, const P& patch, int count, std::ostream& csv) {
  const ReturnMapping mapping(patch);
  const double length = mapping.surface().frame().length;
  std::mt19937_64 engine(13);
  std::vector<int> evaluations;
  long sum = 0, failures = 0;
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    const Vector3 axes(1, log_uniform(engine, 1e-2, 1), log_uniform(engine, 1e-2, 1));
    const Matrix3 turn =
        Eigen::AngleAxisd(uniform(engine, 0, 3),
                          Vector3(uniform(engine, -1, 1), uniform(engine, -1, 1), uniform(engine, -1, 1)).normalized())
            .toRotationMatrix();
    const Vector3 lengths(1, 1, length);
    const Matrix3 K = 1e5 * lengths.asDiagonal() * (turn * axes.asDiagonal() * turn.transpose()) * lengths.asDiagonal();
    const BristleMetric metric((K + K.transpose()) / 2);
    Wrench t{uniform(engine, -1, 1), uniform(engine, -1, 1), length * uniform(engine, -1, 1)};
    const double k = (1 + log_uniform(engine, 1e-9, 1e3)) / mapping.surface().gauge(t).value;
    t = {k * t.fx, k * t.fy, k * t.m};
    const Returned r = mapping(t, 1, metric);
    evaluations.push_back(r.evaluations);
    sum += r.evaluations;
    const double off = std::max(r.wrench.force_error, r.wrench.moment_error / length);
    worst = std::max(worst, off);
    failures += !r.slips || !(off < 1e-9);
  }
  std::ranges::sort(evaluations);
  const double mean = static_cast<double>(sum) / count;
  fmt::print(
      "{:<18} {:>8} trials: evaluations {:.2f} in the mean (target 9), {} in 99 %, at most {}, error {:.1e}, {} "
      "failures{}\n",
      name, count, mean, evaluations[evaluations.size() * 99 / 100], evaluations.back(), worst, failures,
      mean > 9 ? "  missed" : "");
  fmt::print(csv, "{},any,,,{}\n", name, mean);
}

}  // namespace

int main(int argc, char** argv) {
  int states = 1000000;
  patchgrip::bench::CommandLine line("return_mapping", "Return mapping: time against the wrench, cost on any patch.",
                                     "repeat each measurement fewer times");
  line.app.add_option("--states", states, "trials a disc")->check(CLI::Range(100, 100000000))->capture_default_str();
  line.read(argc, argv);
  if (line.is_short) states = std::min(states, 50000);

  std::ostringstream csv;
  fmt::print(csv, "# patchgrip {} return_mapping\n", patchgrip::version);
  fmt::print(csv, "patch,mix,ns,ratio,evaluations\n");
  print_hertz(line.is_short ? 10 : 100, csv);
  fmt::print("\n");
  print_trials("hertz_disc", HertzDisc::of_radius(1), states);
  print_trials("uniform_disc", UniformDisc::of_radius(1), states / 10);
  fmt::print("\n");
  const int few = states / 50;
  print_patch("hertz_disc", HertzDisc::of_radius(0.01), few, csv);
  print_patch("rectangle 2:1", Rectangle::of_sides(2, 1), few, csv);
  print_patch("rectangle 100:1", Rectangle::of_sides(100, 1), few, csv);
  print_patch("hertz_ellipse 5:1", HertzEllipse::of_semi_axes(5, 1), few, csv);
  print_patch("l_shape", Polygon::uniform({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}), few, csv);
  print_patch("two discs",
              Several::of_parts({{Placed(UniformDisc::of_radius(0.004), -0.02, 0.001), 60, 0.5},
                                 {Placed(HertzDisc::of_radius(0.003), 0.015, -0.002), 25, 0.9}}),
              few, csv);
  return line.write([&](std::ostream& file) { file << csv.str(); });
}
