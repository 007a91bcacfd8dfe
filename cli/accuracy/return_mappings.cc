// Sections return_mapping_scalar and return_mapping_hertz_disc: one step after the other, each from the deflection that
// the one before has left.
//
// With L the larger of mu F_N and the gauge of the trial: forces are relative to L, moments to L a, deflection and slip
// to L / k and L a / k_r, dissipation to L^2 / k.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/accuracy/sections.h>
#include <patchgrip/dynamics/return_mapping.h>
#include <patchgrip/dynamics/round_return_mapping.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>

namespace patchgrip::cli {
namespace {

using dynamics::Returned;
using dynamics::Vector3;
using friction::HertzDisc;
using friction::Wrench;

struct Step {
  std::array<Exact, 3> increment;
  Exact mu;
};

struct Mapped {
  Vector3 kappa, s, slip;
  double gauge;
  bool slips;
};

// Steps 0 to `last`; `closest(s*, L, K)` is the return mapping.
template <class Closest>
Mapped after(const std::vector<Step>& steps, std::size_t last, const HertzDisc& disc, const std::array<Exact, 3>& K,
             const Exact& normal_force, Inputs inputs, const Closest& closest) {
  const friction::RoundLimitSurface surface(disc);
  const auto vector = [&](const std::array<Exact, 3>& x) {
    return Vector3(as_double(x[0], inputs), as_double(x[1], inputs), as_double(x[2], inputs));
  };
  const Vector3 k = vector(K);
  Mapped m{};
  m.kappa = Vector3::Zero();
  for (std::size_t i = 0; i <= last; ++i) {
    const Vector3 t = k.cwiseProduct(m.kappa + vector(steps[i].increment));
    const Wrench trial{t[0], t[1], t[2]};
    const Returned r = closest(trial, as_double(steps[i].mu * normal_force, inputs), k);
    const Wrench& s = r.wrench.value;
    m = {Vector3(s.fx, s.fy, s.m).cwiseQuotient(k),
         {s.fx, s.fy, s.m},
         {r.slip.vx, r.slip.vy, r.slip.w},
         surface.gauge(trial).value,
         r.slips};
  }
  return m;
}

Returned closest_round(const HertzDisc& disc, const Wrench& trial, double limit, const Vector3& k) {
  return dynamics::RoundReturnMapping(disc)(trial, limit, {k[0], k[2]});
}

Returned closest_any(const HertzDisc& disc, const Wrench& trial, double limit, const Vector3& k) {
  return dynamics::ReturnMapping(disc)(trial, limit, dynamics::BristleMetric::diagonal(k[0], k[1], k[2]));
}

std::array<Exact, 3> triple(const TableNode& node) {
  const auto x = node.numbers(3);
  return {x[0], x[1], x[2]};
}

struct Problem {
  std::string_view section;
  const TableNode& node;
  Exact radius;
  std::array<Exact, 3> K;
  Exact normal_force;
};

void check(const Problem& p, TableObject& fields) {
  const TableNode K = fields["K"];
  for (const Exact& k : p.K) {
    if (!(k > 0)) K.fail("positive stiffnesses are expected");
  }
}

// One row by one of the two mappings.
template <class Map>
void compare_step(const Problem& p, const std::vector<Step>& steps, std::size_t i, TableObject& row,
                  std::string_view how, AccuracyReport& report, const Map& map) {
  const auto q = measure_entry(row.node(), [&](Inputs inputs) {
    const HertzDisc disc = HertzDisc::of_radius(as_double(p.radius, inputs));
    const Mapped m = after(steps, i, disc, p.K, p.normal_force, inputs,
                           [&](const Wrench& t, double L, const Vector3& k) { return map(disc, t, L, k); });
    return std::array{m.kappa[0], m.kappa[1], m.kappa[2], m.s[0],  m.s[1],          m.s[2],
                      m.slip[0],  m.slip[1],  m.slip[2],  m.gauge, m.s.dot(m.slip), m.slips ? 1. : 0.};
  });
  const Exact gauge = row["trial_gauge_N"].number();
  Exact L = std::max<Exact>(gauge, steps[i].mu * p.normal_force);
  if (L == 0) L = 1;
  const Exact k = std::min(p.K[0], p.K[1]);
  const auto add = [&](std::string_view quantity, std::size_t first, std::span<const Exact> reference,
                       const Exact& scale) {
    report.add({std::string(p.section), "hertz_disc", std::string(quantity) + std::string(how)},
               deviation(q, first, reference, scale), row.node().place());
  };
  const auto add_triple = [&](const char* name, std::string_view linear, std::string_view angular, std::size_t first,
                              const Exact& scale, const Exact& turn_scale) {
    const auto x = triple(row[name]);
    add(linear, first, std::span(x).first(2), scale);
    add(angular, first + 2, std::span(x).last(1), turn_scale);
  };
  add_triple("kappa", "deflection", "deflection, turn", 0, L / k, L * p.radius / p.K[2]);
  add_triple("s", "force", "moment", 3, L, L * p.radius);
  add_triple("slip", "slip", "slip, turn", 6, L / k, L * p.radius / p.K[2]);
  add("gauge of the trial", 9, std::span(&gauge, 1), L);
  const Exact dissipation = row["dissipation_J"].number();
  add("dissipation", 10, std::span(&dissipation, 1), L * L / k);
  const bool slips = row["mode"].text() == "slip";
  report.add({std::string(p.section), "hertz_disc", "stick or slip" + std::string(how)},
             slips == (q.value[11] == 1) ? Deviation{} : failed, row.node().place());
}

}  // namespace

void compare_return_mapping_disc(const TableNode& node, AccuracyReport& report) {
  TableObject fields(node);
  const Problem p{"return_mapping_hertz_disc", node, fields.length("radius").node.positive(), triple(fields["K"]),
                  fields["F_N"].positive()};
  check(p, fields);
  const auto rows = fields["rows"].filled();
  std::vector<Step> steps;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    TableObject row(rows[i]);
    const TableNode mode = row["mode"];
    if (mode.text() != "stick" && mode.text() != "slip") mode.fail("'stick' or 'slip' is expected");
    if (row["mu"].number() < 0) row["mu"].fail("a coefficient from 0 on is expected");
    steps.push_back({triple(row["increment"]), row["mu"].number()});
    if (p.K[0] == p.K[1]) compare_step(p, steps, i, row, "", report, closest_round);
    compare_step(p, steps, i, row, ", any metric", report, closest_any);
    name_unread(row, p.section, report);
  }
  name_unread(fields, p.section, report);
}

// In one direction every patch is a point: mu F_N, whatever its pressure.
void compare_return_mapping_scalar(const TableNode& node, AccuracyReport& report) {
  constexpr std::string_view section = "return_mapping_scalar";
  TableObject fields(node);
  const Exact k = fields["k_N_per_m"].positive(), normal_force = fields["F_N"].positive();
  std::vector<Step> steps;
  const auto rows = fields["rows"].filled();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    TableObject row(rows[i]);
    if (row["mu"].number() < 0) row["mu"].fail("a coefficient from 0 on is expected");
    steps.push_back({{row["increment_m"].number(), 0, 0}, row["mu"].number()});
    const auto q = measure_entry(rows[i], [&](Inputs inputs) {
      const HertzDisc disc = HertzDisc::of_radius(1);
      const Mapped m = after(steps, i, disc, {k, k, 1}, normal_force, inputs,
                             [&](const Wrench& t, double L, const Vector3& K) { return closest_round(disc, t, L, K); });
      return std::array{m.kappa[0], m.s[0], m.slip[0], m.s[0] * m.slip[0], m.gauge};
    });
    Exact L = std::max<Exact>(q.value[4], steps[i].mu * normal_force);
    if (L == 0) L = 1;
    constexpr std::array<std::string_view, 4> names{"kappa_m", "s_N", "slip_m", "dissipation_J"};
    const std::array<Exact, 4> scales{L / k, L, L / k, L * L / k};
    const auto exact_node = row.find("exact");
    const auto exact = exact_node ? exact_node->numbers(4) : std::vector<Exact>{};
    for (std::size_t j = 0; j < names.size(); ++j) {
      const AccuracyReport::Kind kind{std::string(section), "point", std::string(names[j])};
      report.add(kind, deviation(q, j, row[names[j]].number(), scales[j]), rows[i].place());
      if (exact_node) report.add(kind, deviation(q, j, exact[j], scales[j]), exact_node->place());
    }
    name_unread(row, section, report);
  }
  name_unread(fields, section, report);
}

}  // namespace patchgrip::cli
