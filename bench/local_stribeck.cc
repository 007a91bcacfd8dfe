// Stribeck's law at each point against Stribeck's law in the mean: how far apart they are, over pole and speed.
//
//     local_stribeck [--output CSV]
//
// Per mu_s - mu_k and normal force both wrenches differ by E - exp(-v_m^2 / v_S^2) grad D (friction/local_stribeck.h),
// whatever the coefficients. A Hertz disc, a Hertz ellipse 3 : 1, and rectangles 4 : 1 and 20 : 1, the pole on the long
// axis; its distance in units of the disc's radius, the major semi-axis or half the long side, moments likewise.
#include <fmt/ostream.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <string>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/local_stribeck.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::friction;

constexpr int per_decade = 16;

struct Worst {
  double force = 0;
  double moment = 0;
  double error = 0;  // of a local wrench
};

// Poles from 0.01 to 100, v_m from 0.1 to 10 v_S.
template <class P>
Worst compare(const char* name, const P& patch, std::ostream& table) {
  Worst worst;
  for (int i = -2 * per_decade; i <= 2 * per_decade; ++i) {
    for (int j = -per_decade; j <= per_decade; ++j) {
      const double pole = std::pow(10, static_cast<double>(i) / per_decade);
      const double speed = std::pow(10, static_cast<double>(j) / per_decade);
      const double w = speed / std::sqrt(pole * pole + patch.moments().polar);
      const Twist u = twist_about({pole, 0}, w);
      const BoundedWrench local = stribeck_excess(patch, u);
      const Wrench g = patch.gradient(u);
      const double mean = std::exp(-speed * speed);
      const double force = std::hypot(local.value.fx - mean * g.fx, local.value.fy - mean * g.fy);
      const double moment = std::fabs(local.value.m - mean * g.m);
      worst.force = std::max(worst.force, force);
      worst.moment = std::max(worst.moment, moment);
      worst.error = std::max({worst.error, local.force_error, local.moment_error});
      fmt::print(table, "{},{:.6g},{:.6g},{:.6g},{:.6g}\n", name, pole, speed, force, moment);
    }
  }
  return worst;
}

// Of one wrench, at a pole half way to the rim.
template <class Friction>
double fastest_us(const Friction& friction) {
  using Clock = std::chrono::steady_clock;
  double best = 1e300;
  for (int k = 0; k < 50; ++k) {
    const auto start = Clock::now();
    volatile double kept = friction().value.m;
    static_cast<void>(kept);
    best = std::min(best, std::chrono::duration<double, std::micro>(Clock::now() - start).count());
  }
  return best;
}

template <class P>
void report(const char* name, const P& patch, std::ostream& table) {
  const Worst worst = compare(name, patch, table);
  const Law law = Law::stribeck(0.9, 0.5, 1);
  const Twist v = twist_about({0.5, 0}, 1);
  fmt::print("{:17} apart by up to {:.3f} (force), {:.3f} (moment); error of a local wrench <= {:.1e}; {:.0f} us\n",
             name, worst.force, worst.moment, worst.error,
             fastest_us([&] { return local_friction_wrench(law, 1, patch, v); }));
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("local_stribeck",
                                     "Stribeck's law at each point and in the mean: how far they are apart.");
  line.read(argc, argv);
  std::ostringstream table;
  fmt::print(table, "# patchgrip {} local_stribeck\n", patchgrip::version);
  fmt::print(table, "# |local - mean| per (mu_s - mu_k) F_N; lengths in radii or half long sides\n");
  fmt::print(table, "patch,pole,v_m_over_v_S,force,moment\n");
  report("hertz_disc", HertzDisc::of_radius(1), table);
  report("hertz_ellipse_3_1", HertzEllipse::of_semi_axes(1, 1. / 3), table);
  report("rectangle_4_1", Rectangle::of_sides(2, 0.5), table);
  report("rectangle_20_1", Rectangle::of_sides(2, 0.1), table);
  return line.write([&](std::ostream& file) { file << table.str(); });
}
