// Sections hessian_S (second derivatives of S in the pole) and hessian_D (of D in the twist, with D itself).
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <patchgrip/cli/accuracy/sections.h>

namespace patchgrip::cli {
namespace {

using friction::Hessian;
using friction::Twist;

constexpr std::string_view infinite = "an infinite Hessian at a pole that rounding moved off the rim";

// Entries of a Hessian as the table states them; nothing for an infinite one.
template <std::size_t N>
using Entries = std::array<std::optional<Exact>, N>;

template <std::size_t N>
bool all_finite(const Entries<N>& entries) {
  return std::all_of(entries.begin(), entries.end(), [](const auto& entry) { return entry.has_value(); });
}

// The worst entry relative to the largest, each entry divided by its length^k first.
template <std::size_t N>
Deviation compare_entries(const Measured<N>& measured, const Entries<N>& entries, const std::array<Exact, N>& lengths,
                          const TableNode& row) {
  Exact largest = 0;
  for (std::size_t i = 0; i < N; ++i) largest = std::max<Exact>(largest, abs(*entries[i]) / lengths[i]);
  if (largest == 0) row.fail("a Hessian that is not zero is expected");
  Deviation worst;
  for (std::size_t i = 0; i < N; ++i) {
    const Deviation error = deviation(measured, i, *entries[i], largest * lengths[i]);
    worst = {std::max(worst.as_is, error.as_is), std::max(worst.own, error.own)};
  }
  return worst;
}

// `evaluate(Inputs)` gives the N entries, or throws std::domain_error where they are infinite.
template <std::size_t N, class Evaluate>
void compare_hessian(const AccuracyReport::Kind& kind, const Entries<N>& entries, const std::array<Exact, N>& lengths,
                     const TableNode& row, bool exact_inputs, AccuracyReport& report, Evaluate&& evaluate) {
  const bool finite = all_finite(entries);
  try {
    const auto measured = measure(evaluate);
    if (finite) return report.add(kind, compare_entries(measured, entries, lengths, row), row.place());
    if (exact_inputs) return report.add(kind, failed, row.place());
    report.not_covered(kind.section, infinite);
  } catch (const std::domain_error&) {
    report.add(kind, finite ? failed : Deviation{}, row.place());
  }
}

Hessian hessian(const TableContact& contact, Inputs inputs, const Twist& v) {
  return contact.visit(inputs, [&](const auto& patch) { return patch.hessian(v); });
}

void compare_D(const TableContact& contact, const ExactTwist& v, const Exact& D, std::string_view place,
               AccuracyReport& report) {
  const auto q = measure([&](Inputs inputs) {
    return contact.visit(inputs, [&](const auto& patch) { return std::array{patch.dissipation(v.twist(inputs))}; });
  });
  report.add({"hessian_D", contact.type(), "D"}, deviation(q, 0, D, D == 0 ? Exact(1) : abs(D)), place);
}

// What the spin is multiplied by to compare it with a velocity.
Exact spin_length(const TableContact& contact) {
  return contact.visit(Inputs::rounded, [](const auto& patch) {
    const auto moments = patch.moments();
    return std::max(patch.area_radius(), std::hypot(moments.x, moments.y));
  });
}

}  // namespace

void compare_hessian_S(const TableNode& node, AccuracyReport& report) {
  constexpr std::string_view section = "hessian_S";
  for (const TableNode& entry_node : node.filled()) {
    auto entry = read_contact_entry(entry_node, section, report);
    if (!entry) continue;
    const TableContact& contact = entry->contact;
    for (const TableNode& row_node : entry->fields["rows"].filled()) {
      TableObject row(row_node);
      const ExactPole pole = ExactPole::read(row);
      const Entries<3> entries{row["S_xixi"].number_unless_infinite(), row["S_xieta"].number_unless_infinite(),
                               row["S_etaeta"].number_unless_infinite()};
      // D = |w| S(-vy / w, vx / w)
      compare_hessian({std::string(section), contact.type(), "Hessian of S"}, entries, {1, 1, 1}, row_node,
                      contact.is_exact() && pole.is_exact(), report, [&](Inputs inputs) {
                        const Hessian h = hessian(contact, inputs, pole.twist(inputs));
                        return std::array{h.yy, -h.xy, h.xx};
                      });
      name_unread(row, section, report);
    }
    name_unread(entry->fields, section, report);
  }
}

void compare_hessian_D(const TableNode& node, AccuracyReport& report) {
  constexpr std::string_view section = "hessian_D";
  for (const TableNode& entry_node : node.filled()) {
    auto entry = read_contact_entry(entry_node, section, report);
    if (!entry) continue;
    const TableContact& contact = entry->contact;
    const Exact a = spin_length(contact);
    for (const TableNode& row_node : entry->fields["rows"].filled()) {
      TableObject row(row_node);
      const ExactTwist v = ExactTwist::read(row["twist"]);
      compare_D(contact, v, row["D"].number(), row_node.place(), report);
      Entries<6> entries;
      const auto nodes = row["H_11_12_13_22_23_33"].items(entries.size());
      std::transform(nodes.begin(), nodes.end(), entries.begin(),
                     [](const TableNode& n) { return n.number_unless_infinite(); });
      compare_hessian({std::string(section), contact.type(), "Hessian of D"}, entries, {1, 1, a, 1, a, a * a}, row_node,
                      contact.is_exact() && v.is_exact(), report, [&](Inputs inputs) {
                        const Hessian h = hessian(contact, inputs, v.twist(inputs));
                        return std::array{h.xx, h.xy, h.xw, h.yy, h.yw, h.ww};
                      });
      name_unread(row, section, report);
    }
    name_unread(entry->fields, section, report);
  }
}

}  // namespace patchgrip::cli
