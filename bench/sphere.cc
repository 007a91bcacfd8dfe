// A sphere on a half-space by every method of contact/: time against error of force and central pressure, in one run.
//
//     sphere [--output CSV]
//
// Asked is the contact of a given approach: radius, force and pressure on the axis. The reference is the closed form in
// long double. Times are the least of many runs; a ratio in the table is the time over that of the closed form.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/half_space/press.h>
#include <patchgrip/contact/power_sum.h>
#include <patchgrip/contact/smooth_profile.h>
#include <patchgrip/contact/sphere.h>

namespace {

using namespace patchgrip::contact;  // NOLINT: a program of its own

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

struct Found {
  double force;     // F / E*
  double pressure;  // p(0) / E*
};

struct Row {
  std::string method;
  int parameter;
  double ratio;  // a / R
  double ns;
  double force_error;
  double pressure_error;
};

template <class Run>
double least_time(const Run& run) {
  constexpr double enough = 0.05;  // [s] a repetition
  double one = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double start = seconds();
    run();
    one = std::min(one, seconds() - start);
  }
  const int loops = std::max(1, static_cast<int>(enough / one));
  double least = one;
  for (int repetition = 0; repetition < 5; ++repetition) {
    const double start = seconds();
    for (int i = 0; i < loops; ++i) run();
    least = std::min(least, (seconds() - start) / loops);
  }
  return least;
}

template <Profile P>
Found press(const P& profile, double approach) {
  const auto c = AxisymmetricContact<P>::at_approach(profile, approach, 1);
  return {c.force(), c.pressure(0)};
}

Found press_on_grid(int cells, double approach, double radius) {
  const Grid grid = Grid::square(cells, 2.5 * radius);
  const auto gap = sample(grid, [](double x, double y) {
    const double r2 = std::min(x * x + y * y, 1.);
    return r2 / (1 + std::sqrt(1 - r2));
  });
  PressSettings settings;
  settings.threads = 1;
  const auto pressed = press_half_space(grid, Surface::free, gap, 1, Press::by_approach(approach), settings);
  return {pressed.force.value, pressed.pressure[grid.index(cells / 2, cells / 2)]};
}

class Measurement {
 public:
  explicit Measurement(double ratio) : ratio_(ratio) {
    const auto sphere = Sphere::of_radius(1);
    const long double a = ratio;
    approach_ = static_cast<double>(sphere.approach(a));
    // The radius of the approach as a double, which is what every method is given.
    const auto exact = sphere.radius_of_approach(approach_);
    force_ = sphere.force(exact);
    pressure_ = sphere.pressure(0, exact);
  }

  template <class Method>
  void take(const std::string& name, int parameter, const Method& method, std::vector<Row>& rows) const {
    const Found found = method(approach_);
    volatile double kept = 0;
    const double time = least_time([&] { kept = method(approach_).force; });
    rows.push_back({name, parameter, ratio_, 1e9 * time, std::fabs(found.force / force_ - 1),
                    std::fabs(found.pressure / pressure_ - 1)});
  }

 private:
  double ratio_;
  double approach_, force_, pressure_;
};

std::vector<Row> measure(double ratio) {
  std::vector<Row> rows;
  const Measurement measurement(ratio);
  const auto sphere = Sphere::of_radius(1);
  measurement.take(
      "closed form", 0, [&](double d) { return press(sphere, d); }, rows);
  for (int terms = 1; terms <= 6; ++terms) {
    const auto series = PowerSum::sphere_series(1, terms);
    measurement.take(
        "series", terms, [&](double d) { return press(series, d); }, rows);
  }
  for (const int cells : {32, 64, 128, 256}) {
    measurement.take(
        "half-space", cells, [&](double d) { return press_on_grid(cells, d, ratio); }, rows);
  }
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("sphere", "Sphere on a half-space: time and error of every model.");
  line.read(argc, argv);
  std::string csv = "method,parameter,a_over_R,ns,error_force,error_pressure\n";
  for (const double ratio : {0.1, 0.5, 0.9}) {
    const auto rows = measure(ratio);
    std::cout << fmt::format("a/R = {}\n{:<12} {:>5} {:>12} {:>12} {:>10} {:>10}\n", ratio, "method", "", "ns",
                             "/closed", "F", "p(0)");
    for (const Row& r : rows) {
      std::cout << fmt::format("{:<12} {:>5} {:>12.0f} {:>12.3g} {:>10.1e} {:>10.1e}\n", r.method, r.parameter, r.ns,
                               r.ns / rows.front().ns, r.force_error, r.pressure_error);
      csv += fmt::format("{},{},{},{:.6g},{:.3g},{:.3g}\n", r.method, r.parameter, r.ratio, r.ns, r.force_error,
                         r.pressure_error);
    }
  }
  return line.write([&](std::ostream& file) { file << csv; });
}
