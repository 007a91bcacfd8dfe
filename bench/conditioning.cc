// Badly conditioned grips: iterations, width of the bracket and share of undecided ones.
//
//     conditioning [--output CSV] [--short]
//
//     not_closed   next to a cone that is not closed, by delta: the least grip is sqrt 1.25 (1 + delta^2) / delta
//     friction     coefficients of all contacts
//     inside       loads within what is held, by delta of their friction; beyond it for `outside`
//
// Random grasps of 2 to 30 contacts of all kinds (tests/grasp/random_grasps.h), the same ones in m and in mm. A width
// counts as infinite where nothing that holds was found; outside there is none.
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include <patchgrip/bench/command_line.h>
#include <patchgrip/tests/grasp/random_grasps.h>
#include <patchgrip/version.h>

namespace {

using namespace patchgrip::grasp;

struct Row {
  std::string family, unit;
  double x;  // delta, or mu
  int cases = 0, undecided = 0;
  std::vector<double> iterations = {}, widths = {};
};

double quantile(std::vector<double> sorted, double share) {
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(sorted);
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5)];
}

void add(Row& row, const DrawnGrasp& g, double lengths) {
  std::vector<Contact> contacts;
  for (const DrawnContact& c : g.contacts) contacts.push_back(c.in_units(lengths).contact());
  Grasp grasp(std::move(contacts));
  const GripAnswer& a = grasp.least_grip(spatial(g.load.head<3>(), lengths * g.load.tail<3>()));
  ++row.cases;
  row.undecided += a.verdict == Verdict::undecided;
  row.iterations.push_back(a.effort.iterations + a.effort.newton_steps);
  if (g.truth == DrawnGrasp::Truth::not_held) return;
  const bool held = a.verdict == Verdict::holds;
  row.widths.push_back(held ? std::max((a.upper - a.lower) / a.upper, 0x1p-53)
                            : std::numeric_limits<double>::infinity());
}

struct Family {
  const char* name;
  GraspDraws::Class kind;
  double GraspDraws::*parameter;
  int from, to;  // powers of ten
};

}  // namespace

int main(int argc, char** argv) {
  patchgrip::bench::CommandLine line("conditioning", "Badly conditioned grips: iterations, width and undecided ones.",
                                     "draw 40 grasps a point in place of 200");
  line.read(argc, argv);
  const int cases = line.is_short ? 40 : 200;
  using Class = GraspDraws::Class;
  const std::array<Family, 4> families{{{"not_closed", Class::not_closed, &GraspDraws::fixed_delta, -7, -1},
                                        {"friction", Class::wide_mu, &GraspDraws::fixed_mu, -8, 6},
                                        {"inside", Class::near_inside, &GraspDraws::fixed_delta, -12, -1},
                                        {"outside", Class::near_outside, &GraspDraws::fixed_delta, -12, -1}}};
  std::vector<Row> rows;
  fmt::print("{:<11}{:>8}{:>7}{:>12}{:>24}{:>12}\n", "", "", "", "iterations", "width", "undecided");
  fmt::print("{:<11}{:>8}{:>7}{:>6}{:>6}{:>12}{:>12}{:>12}\n", "grasps", "at", "unit", "half", "most", "half",
             "9 of 10", "share");
  for (const Family& family : families) {
    for (int power = family.to; power >= family.from; --power) {
      GraspDraws draws(7);
      draws.*family.parameter = std::pow(10., power);
      std::array<Row, 2> units{{{family.name, "m", std::pow(10., power)}, {family.name, "mm", std::pow(10., power)}}};
      while (units[0].cases < cases) {
        const DrawnGrasp g = draws.draw(family.kind);
        if (g.truth == DrawnGrasp::Truth::unknown) continue;
        add(units[0], g, 1);
        add(units[1], g, 1000);
      }
      for (Row& row : units) {
        fmt::print("{:<11}{:>8.0e}{:>7}{:>6}{:>6}{:>12.1e}{:>12.1e}{:>12.3f}\n", row.family, row.x, row.unit,
                   quantile(row.iterations, 0.5), quantile(row.iterations, 1), quantile(row.widths, 0.5),
                   quantile(row.widths, 0.9), static_cast<double>(row.undecided) / row.cases);
        rows.push_back(std::move(row));
      }
    }
  }
  return line.write([&](std::ostream& csv) {
    fmt::print(csv, "# patchgrip {} conditioning: {} grasps a point\n", patchgrip::version, cases);
    fmt::print(csv, "family,unit,at,iterations_half,iterations_most,width_half,width_9_of_10,undecided_share\n");
    for (const Row& r : rows) {
      fmt::print(csv, "{},{},{:e},{},{},{:e},{:e},{}\n", r.family, r.unit, r.x, quantile(r.iterations, 0.5),
                 quantile(r.iterations, 1), quantile(r.widths, 0.5), quantile(r.widths, 0.9),
                 static_cast<double>(r.undecided) / r.cases);
    }
  });
}
