// Section wrench_integrals: S and the wrench (I1, I2, a_K I3) at unit spin.
#include <array>
#include <cmath>
#include <span>

#include <patchgrip/cli/accuracy/sections.h>

namespace patchgrip::cli {
namespace {

constexpr std::string_view section = "wrench_integrals";

// Beyond this many extents of the patch a pole is far, and the moment due to be relatively exact.
constexpr double far = 2;

using friction::PressureMoments;
using friction::Twist;
using friction::Wrench;

struct Row {
  const TableContact& contact;
  ExactPole pole;
  std::array<Exact, 4> reference;  // I1, I2, a_K I3, S
  std::string place;
};

bool is_far(const Row& row, const PressureMoments& moments) {
  const double x = as_double(row.pole.xi, Inputs::rounded) - moments.x;
  const double y = as_double(row.pole.eta, Inputs::rounded) - moments.y;
  return std::hypot(x, y) > far * row.contact.extent();
}

void compare_row(const Row& row, const Exact& a_K, AccuracyReport& report) {
  const TableContact& contact = row.contact;
  const auto q = measure([&](Inputs inputs) {
    const Twist v = row.pole.twist(inputs);
    return contact.visit(inputs, [&](const auto& patch) {
      const Wrench g = patch.gradient(v);
      return std::array{g.fx, g.fy, g.m, patch.dissipation(v)};
    });
  });
  const auto add = [&](std::string_view quantity, std::size_t first, std::size_t count, const Exact& scale) {
    report.add({std::string(section), contact.type(), std::string(quantity)},
               deviation(q, first, std::span(row.reference).subspan(first, count), scale), row.place);
  };
  const auto& [I1, I2, T, S] = row.reference;
  const Exact force = sqrt(I1 * I1 + I2 * I2);
  const auto moments = contact.visit(Inputs::rounded, [](const auto& patch) { return patch.moments(); });
  const double offset = std::hypot(moments.x, moments.y);
  const bool centred_disc = contact.is_round() && offset == 0;

  add("force", 0, 2, 1);
  add("moment", 2, 1, a_K);
  if (centred_disc && force > 0) add("force, relative", 0, 2, force);
  if (centred_disc) add("moment, relative", 2, 1, abs(T));
  // About the frame's origin the moment of a patch that lies elsewhere may vanish; its parts do not.
  if (!contact.is_round() && is_far(row, moments)) add("far moment, relative", 2, 1, abs(T) + offset * force);
  add("S", 3, 1, S);
}

}  // namespace

void compare_wrench_integrals(const TableNode& node, AccuracyReport& report) {
  for (const TableNode& entry_node : node.filled()) {
    auto entry = read_contact_entry(entry_node, section, report);
    if (!entry) continue;
    const auto a_K = entry->fields.length("a_K");
    compare_area_radius(entry->contact, a_K, section, report);
    for (const TableNode& row_node : entry->fields["rows"].filled()) {
      TableObject row(row_node);
      const auto S = row.length("S");
      S.node.positive();
      const Exact moment = a_K.metres() * row["I3"].number();
      compare_row({entry->contact,
                   ExactPole::read(row),
                   {row["I1"].number(), row["I2"].number(), moment, S.metres()},
                   row_node.place()},
                  a_K.metres(), report);
      name_unread(row, section, report);
    }
    name_unread(entry->fields, section, report);
  }
}

}  // namespace patchgrip::cli
