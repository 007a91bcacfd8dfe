// What the rows about creep in data/reference/contact.json are made of.
#pragma once

#include <patchgrip/contact/creep/contact_creep.h>
#include <patchgrip/contact/creep/standard_models.h>
#include <patchgrip/contact/power_profile.h>
#include <patchgrip/tests/contact/contact_table.h>

namespace patchgrip::contact {

inline PowerProfile paraboloid(double R) { return PowerProfile::of_coefficient(1 / (2 * R), 2); }

inline ContactCreep poynting_thomson_of(const testing::ContactRow& row) {
  return ContactCreep::against_rigid(ViscoelasticMaterial::of(
      PoyntingThomson::of(row.input("E1"), row.input("E2"), row.input("eta")).modulus(), row.input("nu")));
}

inline ContactCreep prony_of(const testing::ContactRow& row) {
  return ContactCreep::against_rigid(
      ViscoelasticMaterial::of(RelaxationModulus::of(row.input("E_inf"), {{row.input("E_1"), row.input("tau_1")},
                                                                          {row.input("E_2"), row.input("tau_2")},
                                                                          {row.input("E_3"), row.input("tau_3")}}),
                               row.input("nu")));
}

}  // namespace patchgrip::contact
