// Verdicts and widths of the bracket over random grasps (random_grasps.h).
//
//     draws [--cases N] [--seed S] [--class NAME] [--verbose]
//
// Exit code 1 if a verdict or a bound contradicts what is known by construction. A load pushed out by delta that forces
// beyond 0.01 delta / 1e-16 would still carry is out of reach of double precision, not wrong.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <patchgrip/tests/grasp/random_grasps.h>

namespace patchgrip::grasp {
namespace {

struct Tally {
  int count = 0, narrow = 0, good = 0, fair = 0, cannot = 0, undecided = 0, wrong = 0;
  double iterations = 0, newton = 0, repairs = 0;
  int most_iterations = 0;
};

bool is_wrong(const DrawnGrasp& g, const GripAnswer& a) {
  using Truth = DrawnGrasp::Truth;
  const double size = g.load.norm();
  switch (g.truth) {
    case Truth::held:
      return a.verdict == Verdict::cannot_hold || a.lower > g.known * (1 + 1e-9);
    case Truth::not_held:
      return a.verdict == Verdict::holds && a.upper < size * 0.01 * g.delta / 1e-16;
    case Truth::value: {
      // The numbers drawn are rounded, which moves the optimum by as many times |W|, 1.25 / delta^2.
      const double rounding = 1e-9 + 0x1p-52 * 1.25 / (g.delta * g.delta);
      return a.lower > g.known * (1 + rounding) || a.upper < g.known * (1 - rounding);
    }
    default:
      return a.lower > a.upper;
  }
}

int run(int cases, unsigned seed, std::string_view only, bool verbose) {
  constexpr std::size_t classes = GraspDraws::names.size();
  std::array<Tally, classes> tallies;
  GraspDraws draws(seed);
  for (int i = 0; i < cases; ++i) {
    const std::size_t kind = static_cast<std::size_t>(i) % classes;
    const DrawnGrasp g = draws.draw(static_cast<GraspDraws::Class>(kind));
    if (!only.empty() && only != GraspDraws::names[kind]) continue;
    Grasp grasp(g.made());
    const GripAnswer& a = grasp.least_grip(g.load);
    Tally& t = tallies[kind];
    ++t.count;
    const double width = a.upper > a.lower ? (a.upper - a.lower) / a.upper : 0;
    if (a.verdict == Verdict::holds) {
      t.narrow += width <= 1e-12;
      t.good += width <= 1e-9;
      t.fair += width <= 1e-6;
    }
    t.cannot += a.verdict == Verdict::cannot_hold;
    t.undecided += a.verdict == Verdict::undecided;
    const bool wrong = is_wrong(g, a);
    t.wrong += wrong;
    t.iterations += a.effort.iterations;
    t.most_iterations = std::max(t.most_iterations, a.effort.iterations);
    t.newton += a.effort.newton_steps;
    t.repairs += a.effort.repairs;
    if (wrong || (verbose && (a.verdict == Verdict::undecided || (a.verdict == Verdict::holds && !(width <= 1e-12))))) {
      std::printf(
          "%d %s%s: %zu contacts, delta %.1e, [%.9g, %.9g] known %.9g, width %.1e, charged %.1e, |W| %.1e, %d it, %d "
          "newton, %d repairs, route %d\n",
          i, GraspDraws::names[kind], wrong ? " WRONG" : "", g.contacts.size(), g.delta, a.lower, a.upper, g.known,
          width, a.charged, a.escape_twist.norm(), a.effort.iterations, a.effort.newton_steps, a.effort.repairs,
          static_cast<int>(a.effort.route));
    }
  }
  std::printf("%-13s %6s %7s %7s %7s %7s %7s %6s | %6s %5s %7s %7s\n", "class", "n", "<=1e-12", "<=1e-9", "<=1e-6",
              "cannot", "undec.", "wrong", "it", "most", "Newton", "repairs");
  int wrong = 0;
  for (std::size_t k = 0; k < classes; ++k) {
    const Tally& t = tallies[k];
    if (t.count == 0) continue;
    std::printf("%-13s %6d %7d %7d %7d %7d %7d %6d | %6.1f %5d %7.1f %7.2f\n", GraspDraws::names[k], t.count, t.narrow,
                t.good, t.fair, t.cannot, t.undecided, t.wrong, t.iterations / t.count, t.most_iterations,
                t.newton / t.count, t.repairs / t.count);
    wrong += t.wrong;
  }
  return wrong > 0 ? 1 : 0;
}

}  // namespace
}  // namespace patchgrip::grasp

int main(int argc, char** argv) {
  int cases = 9000;
  unsigned seed = 1;
  std::string_view only;
  bool verbose = false;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--verbose") verbose = true;
    if (i + 1 == argc) break;
    if (argument == "--cases") cases = std::atoi(argv[i + 1]);
    if (argument == "--seed") seed = static_cast<unsigned>(std::atoi(argv[i + 1]));
    if (argument == "--class") only = argv[i + 1];
  }
  return patchgrip::grasp::run(cases, seed, only, verbose);
}
