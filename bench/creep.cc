// Viscoelastic press under a half sine of force: error of the approach against time for every method, in one run.
//
//     creep [--output CSV] [--short]
//
// A Poynting-Thomson half-space with E1 = E2 under a ball (seed, Fig. 4.9), at t = 0.4 s (the contact grows: Lee and
// Radok) and at 0.9 s (it shrinks: Ting). The truth is the closed form of the press in each case; it agrees with
// data/reference/contact.json to 4e-16.
//
// --short repeats each measurement fewer times.

#include <fmt/ostream.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/contact/creep/growing_contact.h>
#include <patchgrip/contact/creep/press_under_force.h>
#include <patchgrip/contact/creep/seed_creep.h>
#include <patchgrip/contact/creep/spring_press.h>
#include <patchgrip/contact/creep/standard_models.h>
#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::contact;

struct Method {
  std::string name;
  double parameter;  // steps, springs; 0: none
  std::function<double(double t)> approach;
};

struct Row {
  std::string method;
  double parameter;
  double t;
  double us;
  double error;  // relative
};

// The naive way: all of the past again at each step. Lee and Radok's X by the trapezoidal rule.
double growing_convolution(const Paraboloid& ball, const CreepCompliance& compliance, const History& force, double t,
                           int steps) {
  double X = 0;
  for (int now = 1; now <= steps; ++now) {
    X = 0;
    for (int k = 1; k <= now; ++k) {
      const double age = (now - k + 0.5) * t / steps;
      X += compliance(age) * (force(t * k / steps) - force(t * (k - 1) / steps));
    }
  }
  return ball.approach(ball.radius_of_force(X));
}

double stepped(const Paraboloid& ball, const CreepCompliance& compliance, const History& force, double t, int steps) {
  GrowingContact contact(compliance);
  for (int k = 1; k <= steps; ++k) contact.advance(t / steps, force(t * k / steps));
  return contact.approach(ball);
}

double fastest_us(const Method& method, double t, int repetitions) {
  using Clock = std::chrono::steady_clock;
  double best = 1e300;
  for (int k = 0; k < repetitions; ++k) {
    int count = 0;
    const auto start = Clock::now();
    double us = 0;
    do {
      volatile double kept = method.approach(t);
      static_cast<void>(kept);
      ++count;
      us = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
    } while (us < 2000);
    best = std::min(best, us / count);
  }
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("creep", "Viscoelastic press: time and error of every method.",
                                     "repeat each measurement fewer times");
  line.read(argc, argv);
  const int repetitions = line.is_short ? 3 : 9;

  const auto ball = Paraboloid::of_radius(0.02);
  const auto creep =
      ContactCreep::against_rigid(ViscoelasticMaterial::of(PoyntingThomson::of(25000, 25000, 5000).modulus(), 0.5));
  const auto force = History::half_sine(10, std::numbers::pi);
  const auto press = PressUnderForce<Paraboloid>::of(ball, creep, force, 1);

  std::vector<Method> methods{
      {"seed_4_28", 0, [&](double t) { return seed_creep_approach(ball, creep, force, t).value; }},
      {"lee_radok", 0,
       [&](double t) { return ball.approach(ball.radius_of_force(load_integral(creep.compliance, force, t))); }},
      {"ting", 0, [&](double t) { return PressUnderForce<Paraboloid>::of(ball, creep, force, 1).approach(t).value; }},
  };
  for (const int steps : {10, 30, 100, 300, 1000}) {
    methods.push_back({"growing_convolution", static_cast<double>(steps),
                       [&, steps](double t) { return growing_convolution(ball, creep.compliance, force, t, steps); }});
  }
  for (const int steps : {10, 30, 100, 300, 1000, 3000}) {
    methods.push_back({"growing_contact", static_cast<double>(steps),
                       [&, steps](double t) { return stepped(ball, creep.compliance, force, t, steps); }});
  }
  for (const int steps : {5, 10, 20, 40, 80, 160}) {
    methods.push_back({"springs", static_cast<double>(steps), [&, steps](double t) {
                         auto springs = Springs::under(ball, creep, 0.017, 10 * steps);
                         spring_press::run(springs, force, t, steps);
                         return springs.approach();
                       }});
    methods.push_back({"springs_richardson", static_cast<double>(steps), [&, steps](double t) {
                         return press_springs(ball, creep, force, t, 0.017, 10 * steps, steps).approach.value;
                       }});
  }

  std::vector<Row> rows;
  fmt::print("{:22} {:>6} {:>5} {:>12} {:>10}\n", "method", "steps", "t [s]", "us", "error");
  for (const double t : {0.4, 0.9}) {
    const double truth = press.approach(t).value;
    for (const auto& method : methods) {
      const double error = std::max(std::fabs(method.approach(t) / truth - 1), 0x1p-54);
      rows.push_back({method.name, method.parameter, t, fastest_us(method, t, repetitions), error});
      const auto& row = rows.back();
      fmt::print("{:22} {:>6} {:>5} {:>12.4g} {:>10.1e}\n", row.method,
                 row.parameter > 0 ? fmt::format("{:g}", row.parameter) : "", row.t, row.us, row.error);
    }
  }
  const auto time_of = [&](const std::string& method, double parameter) {
    return std::find_if(rows.begin(), rows.end(),
                        [&](const Row& row) { return row.method == method && row.parameter == parameter; })
        ->us;
  };
  fmt::print("\n1000 steps: all of the past again / internal variables = {:.0f} times the time\n",
             time_of("growing_convolution", 1000) / time_of("growing_contact", 1000));

  return line.write([&](std::ostream& file) {
    fmt::print(file, "# patchgrip {} creep\n", patchgrip::version);
    fmt::print(file, "# us: fastest of several repetitions; error: of the approach, relative\n");
    fmt::print(file, "method,parameter,t,us,error\n");
    for (const auto& row : rows) {
      fmt::print(file, "{},{:g},{:g},{:.6g},{:.6g}\n", row.method, row.parameter, row.t, row.us, row.error);
    }
  });
}
