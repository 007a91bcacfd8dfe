// Section multi_mu: the friction of several patches, each with its own normal force and coefficient.
#include <array>
#include <span>
#include <string>

#include <patchgrip/cli/accuracy/sections.h>

namespace patchgrip::cli {
namespace {

constexpr std::string_view section = "multi_mu";

using friction::Twist;
using friction::Wrench;

// Wrench at unit spin and dissipated power, relative to R, R a_K and themselves.
void compare_row(const TableContact& contact, TableObject& row, AccuracyReport& report) {
  const ExactPole pole = ExactPole::read(row);
  const std::array<Exact, 4> reference{row["t1_N"].number(), row["t2_N"].number(), row["t3_Nm"].number(),
                                       row["muFN_S_Nm"].positive()};
  const auto q = measure([&](Inputs inputs) {
    const Twist v = pole.twist(inputs);
    return contact.visit(inputs, [&](const auto& patch) {
      const double R = resistance_of(patch);
      const Wrench g = patch.gradient(v);
      return std::array{-R * g.fx, -R * g.fy, -R * g.m, R * patch.dissipation(v)};
    });
  });
  const auto add = [&](const char* quantity, std::size_t first, std::size_t count, const Exact& scale) {
    report.add({std::string(section), contact.type(), quantity},
               deviation(q, first, std::span(reference).subspan(first, count), scale), row.node().place());
  };
  const auto [R, a_K] = contact.visit(Inputs::rounded, [](const auto& patch) {
    return std::pair{resistance_of(patch), patch.area_radius()};
  });
  add("force", 0, 2, R);
  add("moment", 2, 1, R * a_K);
  add("mu F_N S", 3, 1, reference[3]);
}

}  // namespace

void compare_multi_mu(const TableNode& node, AccuracyReport& report) {
  for (const TableNode& entry_node : node.filled()) {
    auto entry = read_contact_entry(entry_node, section, report);
    if (!entry) continue;
    for (const TableNode& row_node : entry->fields["rows"].filled()) {
      TableObject row(row_node);
      compare_row(entry->contact, row, report);
      name_unread(row, section, report);
    }
    for (const TableNode& row_node : entry->fields["gauge_rows"].filled()) {
      TableObject row(row_node);
      compare_gauge_load(section, entry->contact, row, report);
      name_unread(row, section, report);
    }
    name_unread(entry->fields, section, report);
  }
}

}  // namespace patchgrip::cli
