#include <patchgrip/cli/accuracy/sections.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

using Compare = void (*)(const TableNode&, AccuracyReport&);

struct Section {
  std::string_view name;
  Compare compare;
};

constexpr std::array<Section, 21> sections{{{"wrench_integrals", compare_wrench_integrals},
                                            {"entries", compare_contact_entries},
                                            {"hessian_S", compare_hessian_S},
                                            {"hessian_D", compare_hessian_D},
                                            {"limit_curve", compare_limit_curve},
                                            {"gauge", compare_gauge},
                                            {"stick_radius", compare_stick_radius},
                                            {"multi_mu", compare_multi_mu},
                                            {"viscous", compare_viscous},
                                            {"local_stribeck", compare_local_stribeck},
                                            {"misc.example_4_8", compare_example_4_8},
                                            {"point_laws", compare_point_laws},
                                            {"belt_stick_slip", compare_belt},
                                            {"karnopp", compare_karnopp},
                                            {"elastoplastic_scalar", compare_elastoplastic_point},
                                            {"misc.example_4_7_simulation", compare_elastoplastic_point},
                                            {"return_mapping_scalar", compare_return_mapping_scalar},
                                            {"return_mapping_hertz_disc", compare_return_mapping_disc},
                                            {"misc.coast_down_limit_x", compare_coast_down_limit},
                                            {"misc.coast_down_stop", compare_coast_down_stop},
                                            {"misc.disc_example_fig_4_30", compare_elastoplastic_disc}}};

constexpr std::array<std::string_view, 4> descriptions{"set", "note", "conventions", "verification"};

// What tells the entries of a section apart: the problem they state or, if nothing else, their name.
std::string kind_of(const TableNode& entry) {
  if (!entry.is_object()) return {};
  TableObject fields(entry);
  for (const std::string_view field : {"problem", "name"}) {
    if (const auto node = fields.find(field)) {
      if (node->value().kind == TableValue::Kind::text) return fmt::format("'{}'", printable(node->text()));
    }
  }
  return {};
}

void name_section(const TableNode& node, AccuracyReport& report) {
  if (!node.is_list() || node.items().empty()) return report.not_covered(node.place(), "all of it");
  for (const TableNode& entry : node.items()) {
    const std::string kind = kind_of(entry);
    report.not_covered(node.place(), kind.empty() ? "all of it" : kind);
  }
}

void compare_section(const TableNode& node, AccuracyReport& report) {
  // A name may go on with its definition: coast_down_limit_x=v/(a|omega|).
  const std::string_view name = std::string_view(node.place()).substr(0, node.place().find('='));
  const auto known = std::find_if(sections.begin(), sections.end(), [&](const Section& s) { return s.name == name; });
  if (known == sections.end()) return name_section(node, report);
  known->compare(node, report);
}

}  // namespace

void compare_table(const TableNode& table, AccuracyReport& report) {
  if (!table.is_object()) table.fail("an object of sections is expected");
  TableObject sections_of_table(table);
  const auto grasps = sections_of_table.find("grasps");
  for (const auto& [name, value] : table.value().members) {
    const TableNode section = table.member(name, value);
    if (std::find(descriptions.begin(), descriptions.end(), name) != descriptions.end()) continue;
    if (grasps && name == "grasps") continue;
    if (grasps && name == "cases") {
      compare_grasps(*grasps, section, report);
      continue;
    }
    if (name != "misc" || !section.is_object()) {
      compare_section(section, report);
      continue;
    }
    for (const auto& [part, content] : value.members) compare_section(section.member(part, content), report);
  }
  if (report.entries() == 0 && report.not_covered() == 0) table.fail("nothing to compare");
}

void name_unread(const TableObject& object, std::string_view section, AccuracyReport& report) {
  for (const std::string& field : object.unread()) {
    report.not_covered(section, fmt::format("field '{}'", printable(field)));
  }
}

TableNode named_entry(const TableNode& entry) {
  TableObject fields(entry);
  const auto name = fields.find("name");
  return name ? entry.named(name->text()) : entry;
}

std::optional<ContactEntry> read_contact_entry(const TableNode& entry, std::string_view section,
                                               AccuracyReport& report) {
  TableObject fields(named_entry(entry));
  auto contact = TableContact::read(fields["contact"], section, report);
  if (!contact) return std::nullopt;
  return ContactEntry{std::move(fields), *std::move(contact)};
}

void compare_area_radius(const TableContact& contact, const TableObject::Length& a_K, std::string_view section,
                         AccuracyReport& report) {
  a_K.node.positive();
  const auto q = measure([&](Inputs inputs) {
    return contact.visit(inputs, [](const auto& patch) { return std::array{patch.area_radius()}; });
  });
  report.add({std::string(section), contact.type(), "a_K"}, deviation(q, 0, a_K.metres(), a_K.metres()),
             a_K.node.place());
}

ExactPole ExactPole::read(TableObject& row) { return {row["xi_M"].number(), row["eta_M"].number()}; }

friction::Twist ExactPole::twist(Inputs inputs) const {
  return friction::twist_about({as_double(xi, inputs), as_double(eta, inputs)}, 1);
}

bool ExactPole::is_exact() const { return rounds_to_itself(xi) && rounds_to_itself(eta); }

ExactTwist ExactTwist::read(const TableNode& node) {
  const auto v = node.numbers(3);
  return {v[0], v[1], v[2]};
}

friction::Twist ExactTwist::twist(Inputs inputs) const {
  return {as_double(v1, inputs), as_double(v2, inputs), as_double(omega, inputs)};
}

bool ExactTwist::is_exact() const { return rounds_to_itself(v1) && rounds_to_itself(v2) && rounds_to_itself(omega); }

}  // namespace patchgrip::cli
