// Least grip: times against SDPA, against the number of contacts and models, and the error of cut cones, in one run.
//
//     grasp [--output CSV] [--instances N] [--short]
//
// Contacts lie round a ball of 5 cm, mu in 0.2 .. 0.9, soft fingers of 1 to 6 mm; admissible forces are drawn, the
// load is what they carry. Infeasible grasps have a twist that every contact yields to, and a load along it. Of the
// times of N instances (10) the median counts, of each instance the fastest run, in CPU time of all threads. Set-up is
// included but for warm starts, whose load turns by 0.2 degrees a step. SDPA solves the matrix inequalities of lmi.h,
// where it is installed; OPENBLAS_NUM_THREADS=1 keeps it to one thread. What the allocator gives back to the system
// after each grasp and fetches anew for the next is a sixth of the time at 1000 contacts: at the end it keeps it.
// --short repeats less.
#include <fmt/ostream.h>
#include <malloc.h>
#include <time.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/bench/keep.h>
#include <patchgrip/bench/random.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/grasp/grasp.h>
#include <patchgrip/grasp/interior_point.h>
#include <patchgrip/grasp/linearised_cone.h>
#include <patchgrip/version.h>
#ifdef PATCHGRIP_WITH_SDPA
#include <patchgrip/grasp/lmi_solver.h>
#endif

namespace {

using namespace patchgrip::grasp;
using patchgrip::bench::keep;
using patchgrip::bench::uniform;

enum class Model { point, elliptic, hertz };

struct Instance {
  std::vector<Contact> contacts;
  Vector6 load = Vector6::Zero();
};

struct Draws {
  std::mt19937_64 engine;

  double in(double lo, double hi) { return uniform(engine, lo, hi); }
  Vector3 vector() {
    std::normal_distribution<double> normal;
    return {normal(engine), normal(engine), normal(engine)};
  }

  FrictionCone cone(Model model, double mu) {
    const double e = in(0.001, 0.006);
    if (model == Model::point) return FrictionCone::point(mu);
    if (model == Model::elliptic) return FrictionCone::soft_elliptic(mu, e);
    const double a = e * 16 / (3 * std::numbers::pi);  // D(0, 0, 1) = e
    return FrictionCone::patch(mu, patchgrip::friction::HertzDisc::of_radius(a));
  }

  Instance held(Model model, int count) {
    Instance instance;
    for (int i = 0; i < count; ++i) {
      const Vector3 direction = vector().normalized(), r = 0.05 * in(0.8, 1.2) * direction;
      const double mu = in(0.2, 0.9);
      instance.contacts.emplace_back(ContactFrame{r, direction + 0.15 * vector(), vector()}, cone(model, mu));
      // At most half of what slips: the sum of the shares of force and moment is a lower bound of every model's cone.
      const double F = in(0.1, 1), e = instance.contacts.back().cone().moment_length();
      const Vector3 t = 0.5 * mu * F * Vector3(in(-.5, .5), in(-.5, .5), e * in(-.3, .3));
      instance.load -= instance.contacts.back().wrench(F, t);
    }
    return instance;
  }

  // Every rho_i(W) < 0, w . W > 0.
  Instance not_held(Model model, int count) {
    Instance instance;
    const Vector3 omega = vector(), v = 0.05 * vector();
    for (int i = 0; i < count; ++i) {
      const Vector3 r = 0.05 * in(0.8, 1.2) * vector().normalized();
      const Vector3 w = v + omega.cross(r), n = -(w.normalized() + 0.5 * vector().normalized());
      Contact contact({r, n, vector()}, cone(model, 0));
      const double speed = std::hypot(w.cross(contact.normal()).norm(), 0.01 * omega.norm());
      const double mu = std::min(0.9, 0.8 * contact.opening(spatial(v, omega)) / speed);
      instance.contacts.emplace_back(ContactFrame{r, n, vector()}, cone(model, mu));
    }
    instance.load = spatial(v, 0.0025 * omega);
    return instance;
  }
};

struct Options {
  int instances = 10;
  int repetitions = 20;
};

double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

// Least CPU time of one call [us]; long ones are repeated less.
double least_time(int repetitions, const std::function<void()>& f) {
  double least = std::numeric_limits<double>::infinity(), sum = 0;
  for (int k = 0; k < repetitions && (k < 3 || sum < 2e5); ++k) {
    const double start = cpu_time();
    f();
    const double time = cpu_time() - start;
    least = std::min(least, time);
    sum += time;
  }
  return least;
}

double median(std::vector<double> all) {
  std::ranges::sort(all);
  const std::size_t half = all.size() / 2;
  return all.size() % 2 == 1 ? all[half] : (all[half - 1] + all[half]) / 2;
}

using Solver = std::function<double(const Instance&)>;  // the least grip it finds

double least_grip(const Instance& instance) { return Grasp(instance.contacts).least_grip(instance.load).value; }

double unpolished(const Instance& instance) {
  const ScaledGrasp grasp(instance.contacts);
  const Vector6 w = grasp.scaled_load(instance.load);
  const std::vector<double> limits(instance.contacts.size(), 1);
  InteriorPoint point(grasp);
  point.start({&grasp, Objective::max_force, w / w.norm(), Vector6::Zero(), limits});
  constexpr double tolerance = 1e-8;
  point.run(tolerance, tolerance, GripSettings{}.max_iterations);
  return w.norm() * point.value();
}

#ifdef PATCHGRIP_WITH_SDPA
double sdpa(const Instance& instance) {
  return solve(grip_lmi(instance.contacts, instance.load, Objective::max_force)).upper;
}
#endif

struct Timed {
  double us;
  double error;  // relative, the largest
};

Timed timed(const Options& options, const std::vector<Instance>& instances, const Solver& solver) {
  std::vector<double> times;
  double error = 0;
  for (const Instance& instance : instances) {
    const double truth = least_grip(instance);
    error = std::max(error, std::fabs(solver(instance) / truth - 1));
    times.push_back(least_time(options.repetitions, [&] { keep(solver(instance)); }));
  }
  return {median(times), error};
}

std::vector<Instance> drawn(const Options& options, Model model, int contacts, bool held = true) {
  Draws draws{std::mt19937_64(static_cast<unsigned>(contacts))};
  std::vector<Instance> all;
  for (int i = 0; i < options.instances; ++i)
    all.push_back(held ? draws.held(model, contacts) : draws.not_held(model, contacts));
  return all;
}

void print_line(const std::string& what, const char* relation, double target, double measured) {
  const bool met = *relation == '<' ? measured <= target : measured >= target;
  fmt::print("{:66} {} {:<8g} {:>10.4g}  {}\n", what, relation, target, measured, met ? "" : "missed");
}

double least_us(const Options& options, Model model, int contacts, bool held = true) {
  return timed(options, drawn(options, model, contacts, held), least_grip).us;
}

#ifdef PATCHGRIP_WITH_SDPA
void print_sdpa(const Options& options) {
  struct Target {
    int contacts;
    double polished, unpolished;
  };
  for (const auto& [contacts, with, without] : {Target{2, 100, 130}, {5, 120, 180}, {10, 180, 240}, {50, 380, 450}}) {
    const std::vector<Instance> instances = drawn(options, Model::elliptic, contacts);
    const double theirs = timed(options, instances, sdpa).us;
    const double ours = timed(options, instances, least_grip).us, bare = timed(options, instances, unpolished).us;
    print_line(fmt::format("SDPA / least grip, {} elliptic contacts ({:.0f} us)", contacts, theirs), ">=", with,
               theirs / ours);
    print_line(fmt::format("SDPA / interior point alone, {} elliptic contacts", contacts), ">=", without,
               theirs / bare);
  }
}
#endif

void print_growth(const Options& options) {
  for (const auto& [model, name] :
       {std::pair{Model::elliptic, "elliptic"}, std::pair{Model::point, "point"}, std::pair{Model::hertz, "Hertz"}}) {
    print_line(fmt::format("1000 {} contacts / 100", name), "<=", 13,
               least_us(options, model, 1000) / least_us(options, model, 100));
  }
}

void print_models(const Options& options) {
  for (const int contacts : {2, 5, 10, 20, 50}) {
    print_line(fmt::format("exact Hertz patches / elliptic, {} contacts", contacts), "<=", 2.2,
               least_us(options, Model::hertz, contacts) / least_us(options, Model::elliptic, contacts));
  }
  for (const auto& [model, name] : {std::pair{Model::elliptic, "elliptic"}, std::pair{Model::hertz, "Hertz"}}) {
    for (const int contacts : {3, 5, 10, 20}) {
      print_line(fmt::format("infeasible / feasible, {} {} contacts", contacts, name), "<=", 0.6,
                 least_us(options, model, contacts, false) / least_us(options, model, contacts));
    }
  }
}

// Loads that turn by 0.2 degrees a step: next_least_grip / least_grip.
double warm_ratio(const Options& options, const Instance& instance) {
  std::vector<Vector6> loads;
  for (int i = 1; i <= 50; ++i) {
    const Matrix3 Q = Eigen::AngleAxisd(i * 0.2 * std::numbers::pi / 180, Vector3(1, 2, 3).normalized()).matrix();
    loads.push_back(spatial(Q * instance.load.head<3>(), Q * instance.load.tail<3>()));
  }
  Grasp cold(instance.contacts), warm(instance.contacts);
  const double from_nothing = least_time(options.repetitions, [&] {
    for (const Vector6& w : loads) keep(cold.least_grip(w).value);
  });
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < std::min(options.repetitions, 5); ++k) {
    warm.least_grip(instance.load);
    least = std::min(least, least_time(1, [&] {
                       for (const Vector6& w : loads) keep(warm.next_least_grip(w).value);
                     }));
  }
  return least / from_nothing;
}

void print_warm(const Options& options) {
  for (const auto& [model, name] : {std::pair{Model::elliptic, "elliptic"}, std::pair{Model::hertz, "Hertz"}}) {
    for (const auto& [contacts, target] : {std::pair{3, 1. / 3}, std::pair{5, 0.25}, std::pair{20, 0.18}}) {
      std::vector<double> ratios;
      for (const Instance& instance : drawn(options, model, contacts)) ratios.push_back(warm_ratio(options, instance));
      print_line(fmt::format("warm / cold, {} {} contacts", contacts, name), "<=", target, median(ratios));
    }
  }
}

void print_cuts(const Options& options, std::ostream& csv) {
  fmt::print("{:10} {:>8} {:24} {:>10} {:>12}\n", "model", "contacts", "method", "us", "error");
  for (const auto& [model, name] : {std::pair{Model::point, "point"}, std::pair{Model::elliptic, "elliptic"}}) {
    const int contacts = 5;
    const std::vector<Instance> instances = drawn(options, model, contacts);
    const auto print = [&](const std::string& method, const Solver& solver) {
      const auto [us, error] = timed(options, instances, solver);
      fmt::print("{:10} {:8} {:24} {:10.1f} {:12.2e}\n", name, contacts, method, us, error);
      fmt::print(csv, "{},{},{},{},{}\n", name, contacts, method, us, error);
    };
    for (const auto& [side, side_name] : {std::pair{CutSide::inner, "inner"}, std::pair{CutSide::outer, "outer"}}) {
      for (const int k : {4, 8, 16, 32, 64}) {
        print(fmt::format("{} {} edges", side_name, k), [k, side = side](const Instance& instance) {
          return linearised_least_grip(instance.contacts, instance.load, k, side).upper;
        });
      }
    }
#ifdef PATCHGRIP_WITH_SDPA
    print("SDPA", sdpa);
#endif
    print("interior point", unpolished);
    print("least grip", [](const Instance& instance) {
      const GripAnswer a = Grasp(instance.contacts).least_grip(instance.load);
      return a.upper == a.lower ? a.value : a.upper;
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  patchgrip::bench::CommandLine line("grasp",
                                     "Least grip: times against SDPA, contacts and models; error of cut cones.",
                                     "repeat each measurement fewer times");
  line.app.add_option("--instances", options.instances, "random grasps a measurement")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  line.read(argc, argv);
  if (line.is_short) options.repetitions = 3;

  std::ostringstream csv;
  fmt::print(csv, "# patchgrip {} grasp\n", patchgrip::version);
  fmt::print(csv, "model,contacts,method,us,error\n");
  fmt::print("{:66} {:11} {:>10}\n", "Ratios of times", "target", "measured");
#ifdef PATCHGRIP_WITH_SDPA
  print_sdpa(options);
#endif
  print_growth(options);
  print_models(options);
  print_warm(options);
  fmt::print("\nTime and relative error of the least grip\n");
  print_cuts(options, csv);
  fmt::print("\nMemory kept\n");
  constexpr int kept = 1 << 28;
  mallopt(M_MMAP_THRESHOLD, kept / 8);
  mallopt(M_TRIM_THRESHOLD, kept);
  print_growth(options);
  return line.write([&](std::ostream& file) { file << csv.str(); });
}
