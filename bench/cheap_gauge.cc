// The gauge of a load by every method: error against time, and the side that the cheap ones err on.
//
//     cheap_gauge [--output CSV] [--sides CSV] [--short]
//
// --output   time of an evaluation and worst relative error over random loads (plots/speed_accuracy_gauge.py)
// --sides    signed relative error over the direction of the load (plots/gauge_sides.py)
// --short    repeats each measurement fewer times.
//
// The truth is t . v / D(v) with D in 50 digits at the twist v of the general solver: the gauge is stationary there, so
// that an error of 1e-13 in v leaves 1e-26.

#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <concepts>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/bench/patches.h>
#include <patchgrip/bench/reference_truth.h>
#include <patchgrip/friction/limit_surface/ellipsoid_gauge.h>
#include <patchgrip/friction/limit_surface/fast_hertz_gauge.h>
#include <patchgrip/friction/limit_surface/hertz_gauge.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/limit_surface/quartic_gauge.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/limit_surface/seed_gauge.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::friction;
using patchgrip::bench::reference_truth, patchgrip::bench::Truth;

struct Row {
  std::string patch, method;
  double parameter;  // relative gap asked for; 0: none
  double ns;
  double error;  // worst, relative
  double excess, deficit;
};

struct Side {
  std::string patch, method;
  double force_direction;  // [deg]
  double angle;            // atan of moment / l over force [deg]
  double error;            // signed, relative
};

struct Loads {
  std::vector<Wrench> loads;
  std::vector<double> truth;  // of the first of them
};

// visit(name, patch, gradient in 50 digits, loads that are judged) for all but those that the charts have no room for.
template <class Visit>
void for_every_patch(const Visit& visit) {
  const auto if_shown = [&](const std::string& name, const auto& patch, const auto&, const Gradient50& gradient,
                            std::size_t judged) {
    constexpr std::array left_out{"stamp_disc", "hertz_ellipse_100", "pressure_mesh", "line_load"};
    if (std::ranges::find(left_out, name) == left_out.end()) visit(name, patch, gradient, judged);
  };
  patchgrip::bench::for_every_round_patch(if_shown);
  patchgrip::bench::for_every_other_patch(if_shown);
}

// visit(name, model) for every cheap gauge of the patch.
template <class P, class Visit>
void for_every_model(const P& patch, const Visit& visit) {
  const auto even_ellipsoid = EllipsoidGauge::even(patch);
  visit("ellipsoid_axis", EllipsoidGauge::axis(patch));
  visit("ellipsoid_least_squares", EllipsoidGauge::least_squares(patch));
  visit("ellipsoid_even", even_ellipsoid);
  visit("ellipsoid_safe", even_ellipsoid.safe());
  visit("ellipsoid_inner", EllipsoidGauge::inner(patch));
  visit("ellipsoid_enclosing", EllipsoidGauge::enclosing(patch));
  const auto even_quartic = QuarticGauge::even(patch);
  visit("quartic_least_squares", QuarticGauge::least_squares(patch));
  visit("quartic_even", even_quartic);
  visit("quartic_safe", even_quartic.safe());
  if constexpr (std::same_as<P, HertzDisc>) {
    visit("seed", SeedGauge::of_radius(patch.radius()));
    visit("fast", FastHertzGauge::of_radius(patch.radius()));
    visit("exact", HertzGauge::of_radius(patch.radius()));
  }
}

// Directions even in the frame of the centre of pressure.
template <class P>
Loads random_loads(const P& patch, const Gradient50& gradient, std::size_t judged) {
  constexpr std::size_t count = 4096;
  const auto frame = CentredFrame::of(patch);
  const LimitSurface surface(patch);
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal;
  Loads result;
  std::vector<Twist> twists;
  while (result.loads.size() < count) {
    const Wrench t = frame.global(Wrench{normal(engine), normal(engine), normal(engine)});
    result.loads.push_back(t);
    if (twists.size() < judged) twists.push_back(surface.gauge(t).twist);
  }
  const Truth truth = reference_truth(gradient, twists);
  for (std::size_t i = 0; i < judged; ++i) {
    const auto power = [&v = twists[i]](const Wrench& t) {
      return static_cast<long double>(t.fx) * v.vx + static_cast<long double>(t.fy) * v.vy +
             static_cast<long double>(t.m) * v.w;
    };
    result.truth.push_back(static_cast<double>(power(result.loads[i]) / (power(truth[i].head) + power(truth[i].tail))));
  }
  return result;
}

template <class Method>
[[gnu::noinline]] double evaluate(const Method& method, const Wrench& t) noexcept {
  return method(t);
}

// Of up to `repetitions`, but three at the least, that take `seconds` together.
template <class Method>
double fastest_ns(const Method& method, const std::vector<Wrench>& loads, int repetitions, double seconds) {
  using Clock = std::chrono::steady_clock;
  double best = 1e300, spent = 0;
  for (int k = 0; k < repetitions && (k < 3 || spent < seconds * 1e9); ++k) {
    const auto start = Clock::now();
    double kept = 0;
    for (const Wrench& t : loads) kept += evaluate(method, t);
    const double ns = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    volatile double sink = kept;
    static_cast<void>(sink);
    best = std::min(best, ns / static_cast<double>(loads.size()));
    spent += ns;
  }
  return best;
}

class Report {
 public:
  Report(std::string patch, Loads loads, int repetitions)
      : patch_(std::move(patch)), loads_(std::move(loads)), repetitions_(repetitions) {}

  template <class Method>
  void add(const std::string& name, double parameter, const Method& method) {
    constexpr double seconds = 0.05;
    Row row{patch_, name, parameter, fastest_ns(method, loads_.loads, repetitions_, seconds), 0, 0, 0};
    for (std::size_t i = 0; i < loads_.truth.size(); ++i) {
      const double error = method(loads_.loads[i]) / loads_.truth[i] - 1;
      row.excess = std::max(row.excess, error);
      row.deficit = std::max(row.deficit, -error);
    }
    row.error = std::max({row.excess, row.deficit, 0x1p-54});
    rows.push_back(row);
  }

  template <GaugeModel Model>
  void add(const std::string& name, const Model& model) {
    add(name, 0, [&](const Wrench& t) { return model.value(t); });
  }

  template <class P>
  void add_all(const P& patch) {
    for (const double gap : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
      const LimitSurface surface(patch, {.relative_gap = gap});
      add("newton", gap, [&](const Wrench& t) { return surface.gauge(t).value; });
    }
    if constexpr (requires { patch.kernel(); }) {
      const RoundLimitSurface surface(patch);
      add("round", 0, [&](const Wrench& t) { return surface.gauge(t).value; });
    }
    for_every_model(patch, [this](const std::string& name, const auto& model) { add(name, model); });
  }

  std::vector<Row> rows;

 private:
  std::string patch_;
  Loads loads_;
  int repetitions_;
};

std::vector<Row> measure(int repetitions) {
  std::vector<Row> rows;
  for_every_patch([&](const std::string& name, const auto& patch, const Gradient50& gradient, std::size_t judged) {
    Report report(name, random_loads(patch, gradient, judged), repetitions);
    report.add_all(patch);
    rows.insert(rows.end(), report.rows.begin(), report.rows.end());
  });
  return rows;
}

std::vector<Side> sides_of_all() {
  constexpr double degree = std::numbers::pi / 180;
  std::vector<Side> sides;
  for_every_patch([&](const std::string& patch_name, const auto& patch, const Gradient50&, std::size_t) {
    const LimitSurface surface(patch);
    const auto frame = CentredFrame::of(patch);
    for_every_model(patch, [&](const std::string& name, const GaugeModel auto& model) {
      for (const double direction : {0., 90.}) {
        for (int i = 0; i <= 180; ++i) {
          const double angle = i * 0.5, f = std::cos(angle * degree), m = std::sin(angle * degree);
          const Wrench t = frame.global(Wrench{f * std::cos(direction * degree), f * std::sin(direction * degree), m});
          sides.push_back({patch_name, name, direction, angle, model.value(t) / surface.gauge(t).value - 1});
        }
      }
    });
  });
  return sides;
}

void print(std::ostream& out, const std::vector<Row>& rows) {
  fmt::print(out, "{:16} {:24} {:>8} {:>10} {:>10} {:>10} {:>10}\n", "patch", "method", "gap", "ns", "error",
             "too large", "too small");
  for (const Row& row : rows) {
    fmt::print(out, "{:16} {:24} {:>8} {:>10.4g} {:>10.1e} {:>10.1e} {:>10.1e}\n", row.patch, row.method,
               row.parameter > 0 ? fmt::format("{:g}", row.parameter) : "", row.ns, row.error, row.excess, row.deficit);
  }
}

void write(std::ostream& out, const std::vector<Row>& rows) {
  fmt::print(out, "# patchgrip {} cheap_gauge\n", patchgrip::version);
  fmt::print(out,
             "# ns: fastest of several repetitions; error: worst of 200 random loads (xydas_kao_disc: 30), relative\n");
  fmt::print(out, "patch,method,gap,ns,error\n");
  for (const Row& row : rows) {
    fmt::print(out, "{},{},{:g},{:.6g},{:.6g}\n", row.patch, row.method, row.parameter, row.ns, row.error);
  }
}

void write(std::ostream& out, const std::vector<Side>& sides) {
  fmt::print(out, "# patchgrip {} cheap_gauge\n", patchgrip::version);
  fmt::print(out, "# angle: atan of moment / l over force, l = M_0 / (mu F_N); error: gauge / true gauge - 1\n");
  fmt::print(out, "patch,method,force_direction_deg,angle_deg,error\n");
  for (const Side& side : sides) {
    fmt::print(out, "{},{},{:g},{:g},{:.6g}\n", side.patch, side.method, side.force_direction, side.angle, side.error);
  }
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("cheap_gauge", "Gauge of a load: time and error of every method.",
                                     "repeat each measurement fewer times");
  std::string sides;
  line.app
      .add_option("--sides", sides, "CSV file to write the signed errors of the cheap methods to, over the direction")
      ->type_name("FILE");
  line.read(argc, argv);
  const std::vector<Row> rows = measure(line.is_short ? 30 : 200);
  print(std::cout, rows);
  const int code = line.write([&](std::ostream& csv) { write(csv, rows); });
  return std::max(code, line.write(sides, [](std::ostream& csv) { write(csv, sides_of_all()); }));
}
