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
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <patchgrip/bench/truth.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/ellipsoid_gauge.h>
#include <patchgrip/friction/limit_surface/fast_hertz_gauge.h>
#include <patchgrip/friction/limit_surface/hertz_gauge.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/limit_surface/quartic_gauge.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/limit_surface/seed_gauge.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::friction;
using patchgrip::bench::Truth;

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

// Directions even in the frame of the centre of pressure.
template <class P, class TruthOf>
Loads random_loads(const P& patch, const TruthOf& truth_of) {
  constexpr std::size_t count = 4096, judged = 500;
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
  const Truth truth = truth_of(twists);
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

template <class Method>
double fastest_ns(const Method& method, const std::vector<Wrench>& loads, int repetitions) {
  using Clock = std::chrono::steady_clock;
  double best = 1e300;
  for (int k = 0; k < repetitions; ++k) {
    const auto start = Clock::now();
    double kept = 0;
    for (const Wrench& t : loads) kept += evaluate(method, t);
    const double ns = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    volatile double sink = kept;
    static_cast<void>(sink);
    best = std::min(best, ns / static_cast<double>(loads.size()));
  }
  return best;
}

class Report {
 public:
  Report(std::string patch, Loads loads, int repetitions)
      : patch_(std::move(patch)), loads_(std::move(loads)), repetitions_(repetitions) {}

  template <class Method>
  void add(const std::string& name, double parameter, const Method& method) {
    Row row{patch_, name, parameter, fastest_ns(method, loads_.loads, repetitions_), 0, 0, 0};
    for (std::size_t i = 0; i < loads_.truth.size(); ++i) {
      const double error = method(loads_.loads[i]) / loads_.truth[i] - 1;
      row.excess = std::max(row.excess, error);
      row.deficit = std::max(row.deficit, -error);
    }
    row.error = std::max({row.excess, row.deficit, 0x1p-54});
    rows.push_back(row);
  }

  template <class P>
  void add_models_of_any(const P& patch) {
    for (const double gap : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
      const LimitSurface surface(patch, {.relative_gap = gap});
      add("newton", gap, [&](const Wrench& t) { return surface.gauge(t).value; });
    }
    const auto axis = EllipsoidGauge::axis(patch), even = EllipsoidGauge::even(patch);
    const auto quartic = QuarticGauge::even(patch);
    add("ellipsoid_axis", 0, [&](const Wrench& t) { return axis.value(t); });
    add("ellipsoid_even", 0, [&](const Wrench& t) { return even.value(t); });
    add("quartic_even", 0, [&](const Wrench& t) { return quartic.value(t); });
  }

  std::vector<Row> rows;

 private:
  std::string patch_;
  Loads loads_;
  int repetitions_;
};

template <class P>
class Sides {
 public:
  Sides(std::string patch, const P& patch_type, double direction)
      : patch_(std::move(patch)), surface_(patch_type), frame_(CentredFrame::of(patch_type)), direction_(direction) {}

  template <class Method>
  void add(std::vector<Side>& sides, const std::string& name, const Method& method) const {
    for (int i = 0; i <= 180; ++i) {
      const double angle = i * 0.5, f = std::cos(angle * degree), m = std::sin(angle * degree);
      const Wrench t = frame_.global(Wrench{f * std::cos(direction_ * degree), f * std::sin(direction_ * degree), m});
      sides.push_back({patch_, name, direction_, angle, method(t) / surface_.gauge(t).value - 1});
    }
  }

  void add_models_of_any(std::vector<Side>& sides) const {
    const auto& patch = surface_.patch();
    const auto axis = EllipsoidGauge::axis(patch), even = EllipsoidGauge::even(patch), safe = even.safe();
    const auto quartic = QuarticGauge::even(patch), safe_quartic = quartic.safe();
    add(sides, "ellipsoid_axis", [&](const Wrench& t) { return axis.value(t); });
    add(sides, "ellipsoid_even", [&](const Wrench& t) { return even.value(t); });
    add(sides, "ellipsoid_safe", [&](const Wrench& t) { return safe.value(t); });
    add(sides, "quartic_even", [&](const Wrench& t) { return quartic.value(t); });
    add(sides, "quartic_safe", [&](const Wrench& t) { return safe_quartic.value(t); });
  }

 private:
  static constexpr double degree = std::numbers::pi / 180;

  std::string patch_;
  LimitSurface<P> surface_;
  CentredFrame frame_;
  double direction_;
};

constexpr double radius = 5e-3;                                             // m
constexpr double l_xi = 20e-3, l_eta = 5e-3;                                // m
const std::vector<Point> l_shape{{0, 0},       {0.03, 0},    {0.03, 0.01},  // m
                                 {0.01, 0.01}, {0.01, 0.02}, {0, 0.02}};

std::vector<Row> measure(int repetitions) {
  std::vector<Row> rows;
  const auto keep = [&](const Report& report) { rows.insert(rows.end(), report.rows.begin(), report.rows.end()); };

  const auto disc = HertzDisc::of_radius(radius);
  Report of_disc(
      "hertz_disc",
      random_loads(disc, [](const auto& twists) { return patchgrip::bench::power_disc_truth(radius, 1, twists); }),
      repetitions);
  const auto seed = SeedGauge::of_radius(radius);
  const auto exact = HertzGauge::of_radius(radius);
  const auto fast = FastHertzGauge::of_radius(radius);
  const RoundLimitSurface round(disc);
  of_disc.add("seed", 0, [&](const Wrench& t) { return seed.value(t); });
  of_disc.add("fast", 0, [&](const Wrench& t) { return fast.value(t); });
  of_disc.add("exact", 0, [&](const Wrench& t) { return exact.value(t); });
  of_disc.add("round", 0, [&](const Wrench& t) { return round.gauge(t).value; });
  of_disc.add_models_of_any(disc);
  keep(of_disc);

  const auto of_outline = [&](const std::string& name, const auto& patch, const std::vector<Point>& outline) {
    Report report(
        name, random_loads(patch, [&](const auto& twists) { return patchgrip::bench::polygon_truth(outline, twists); }),
        repetitions);
    report.add_models_of_any(patch);
    keep(report);
  };
  const double x = l_xi / 2, y = l_eta / 2;
  of_outline("rectangle", Rectangle::of_sides(l_xi, l_eta), {{-x, -y}, {x, -y}, {x, y}, {-x, y}});
  of_outline("l_shape", Polygon::uniform(l_shape), l_shape);
  return rows;
}

std::vector<Side> sides_of_all() {
  std::vector<Side> sides;
  const Sides disc("hertz_disc", HertzDisc::of_radius(radius), 0);
  const auto seed = SeedGauge::of_radius(radius);
  disc.add_models_of_any(sides);
  disc.add(sides, "seed", [&](const Wrench& t) { return seed.value(t); });
  for (const double direction : {0., 90.}) {
    Sides("rectangle", Rectangle::of_sides(l_xi, l_eta), direction).add_models_of_any(sides);
  }
  return sides;
}

void print(std::ostream& out, const std::vector<Row>& rows) {
  fmt::print(out, "{:12} {:16} {:>8} {:>10} {:>10} {:>10} {:>10}\n", "patch", "method", "gap", "ns", "error",
             "too large", "too small");
  for (const Row& row : rows) {
    fmt::print(out, "{:12} {:16} {:>8} {:>10.4g} {:>10.1e} {:>10.1e} {:>10.1e}\n", row.patch, row.method,
               row.parameter > 0 ? fmt::format("{:g}", row.parameter) : "", row.ns, row.error, row.excess, row.deficit);
  }
}

void write(std::ostream& out, const std::vector<Row>& rows) {
  fmt::print(out, "# patchgrip {} cheap_gauge\n", patchgrip::version);
  fmt::print(out, "# ns: fastest of several repetitions; error: worst of 500 random loads, relative\n");
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

template <class Table>
bool wrote(const std::string& path, const Table& table) {
  if (path.empty()) return true;
  std::ofstream file(path);
  write(file, table);
  file.flush();
  if (!file) std::cerr << "cheap_gauge: cannot write " << path << '\n';
  return static_cast<bool>(file);
}

}  // namespace

int main(int argc, char** argv) {
  std::string output, sides;
  int repetitions = 200;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--output") == 0 && i + 1 < argc) {
      output = argv[++i];
    } else if (std::strcmp(argv[i], "--sides") == 0 && i + 1 < argc) {
      sides = argv[++i];
    } else if (std::strcmp(argv[i], "--short") == 0) {
      repetitions = 30;
    } else {
      std::cerr << "cheap_gauge: unknown option " << argv[i] << "; known are --output CSV, --sides CSV and --short\n";
      return 2;
    }
  }
  const std::vector<Row> rows = measure(repetitions);
  print(std::cout, rows);
  return wrote(output, rows) && wrote(sides, sides_of_all()) ? EXIT_SUCCESS : EXIT_FAILURE;
}
