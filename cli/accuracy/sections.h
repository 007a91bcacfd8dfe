// The sections of reference tables that the library covers, each with its comparison.
#pragma once

#include <exception>
#include <string_view>

#include <patchgrip/cli/accuracy/node.h>
#include <patchgrip/cli/accuracy/report.h>
#include <patchgrip/cli/accuracy/table_contact.h>

namespace patchgrip::cli {

// Compares every section of a table. Throws TableError.
void compare_table(const TableNode& table, AccuracyReport& report);

void compare_contact_entries(const TableNode& section, AccuracyReport& report);
void compare_wrench_integrals(const TableNode& section, AccuracyReport& report);
void compare_hessian_S(const TableNode& section, AccuracyReport& report);
void compare_hessian_D(const TableNode& section, AccuracyReport& report);
void compare_limit_curve(const TableNode& section, AccuracyReport& report);
void compare_multi_mu(const TableNode& section, AccuracyReport& report);
void compare_gauge(const TableNode& section, AccuracyReport& report);
void compare_stick_radius(const TableNode& section, AccuracyReport& report);
void compare_viscous(const TableNode& section, AccuracyReport& report);
void compare_local_stribeck(const TableNode& section, AccuracyReport& report);
void compare_example_4_8(const TableNode& example, AccuracyReport& report);
void compare_point_laws(const TableNode& section, AccuracyReport& report);
void compare_belt(const TableNode& section, AccuracyReport& report);
void compare_karnopp(const TableNode& section, AccuracyReport& report);
void compare_elastoplastic_point(const TableNode& entry, AccuracyReport& report);
void compare_return_mapping_scalar(const TableNode& section, AccuracyReport& report);
void compare_return_mapping_disc(const TableNode& section, AccuracyReport& report);
void compare_coast_down_limit(const TableNode& section, AccuracyReport& report);
void compare_coast_down_stop(const TableNode& section, AccuracyReport& report);
void compare_elastoplastic_disc(const TableNode& example, AccuracyReport& report);

// `cases` name the `grasps` that they are about.
void compare_grasps(const TableNode& grasps, const TableNode& cases, AccuracyReport& report);

// Fields of `object` that no comparison asked for.
void name_unread(const TableObject& object, std::string_view section, AccuracyReport& report);

// A row {t, gauge_N, pole, spin_sign}: the gauge over the resistance (table_contact.h), and the pole of the slip.
void compare_gauge_load(std::string_view section, const TableContact& contact, TableObject& row,
                        AccuracyReport& report);

// measure() of inputs.h; what the library refuses is told at `owner`.
template <class Evaluate>
auto measure_entry(const TableNode& owner, Evaluate&& evaluate) {
  try {
    return measure(evaluate);
  } catch (const TableError&) {
    throw;
  } catch (const std::exception& error) {
    owner.fail(error.what());
  }
}

// The entry of a list, with its name in its place if it has one.
TableNode named_entry(const TableNode& entry);

// An entry about one contact.
struct ContactEntry {
  TableObject fields;
  TableContact contact;
};

// Nothing where the contact is not covered.
std::optional<ContactEntry> read_contact_entry(const TableNode& entry, std::string_view section,
                                               AccuracyReport& report);

// The radius of a disc with the area of the contact, which entries state beside it.
void compare_area_radius(const TableContact& contact, const TableObject::Length& a_K, std::string_view section,
                         AccuracyReport& report);

// The pole (xi_M, eta_M) of a row, and a twist (v1, v2, omega).
struct ExactPole {
  static ExactPole read(TableObject& row);
  friction::Twist twist(Inputs inputs) const;  // about the pole, with unit spin
  bool is_exact() const;                       // as doubles

  Exact xi, eta;
};

struct ExactTwist {
  static ExactTwist read(const TableNode& node);
  friction::Twist twist(Inputs inputs) const;
  bool is_exact() const;

  Exact v1, v2, omega;
};

}  // namespace patchgrip::cli
