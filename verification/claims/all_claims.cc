#include <patchgrip/verification/claims/all_claims.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include <patchgrip/verification/claims/bodies.h>
#include <patchgrip/verification/claims/creep.h>
#include <patchgrip/verification/claims/pad.h>
#include <patchgrip/verification/claims/press.h>
#include <patchgrip/verification/claims/punch.h>
#include <patchgrip/verification/claims/rubber.h>
#include <patchgrip/verification/claims/shear.h>

namespace patchgrip::verification {

std::span<const ClaimSet> all_claims() {
  static const std::array sets{
      ClaimSet{"sphere", "Rigid sphere on a half-space, a/R = 0.001 (Hertz)",
               [] { return pressed_paraboloid().quantities; }},
      ClaimSet{"sphere_ccx", "Rigid sphere on a half-space, a/R = 0.001, by CalculiX", paraboloid_at_approach},
      ClaimSet{"sphere_01", "Rigid sphere on a half-space, a/R = 0.1", [] { return pressed_sphere(0.1).quantities; }},
      ClaimSet{"sphere_05", "Rigid sphere on a half-space, a/R = 0.5", [] { return pressed_sphere(0.5).quantities; }},
      ClaimSet{"sphere_08", "Rigid sphere on a half-space, a/R = 0.8", [] { return pressed_sphere(0.8).quantities; }},
      ClaimSet{"moved_points", "Rigid paraboloid, a/R = 0.1, that touches points where they have gone",
               [] { return pressed_paraboloid_at_moved_points().quantities; }},
      ClaimSet{"flat_punch", "Rigid flat punch on a half-space", [] { return flat_punch().quantities; }},
      ClaimSet{"flat_punch_ccx", "Rigid flat punch on a half-space, by CalculiX", flat_punch_at_approach},
      ClaimSet{"rough_punch", "Stick under a rigid flat punch with friction (Spence)",
               [] { return rough_punch().quantities; }},
      ClaimSet{"torsion", "Hertz contact twisted: partial slip (Lubkin)", [] { return torsion().quantities; }},
      ClaimSet{"shear", "Hertz contact sheared: partial slip (Cattaneo, Mindlin)", [] { return shear().quantities; }},
      ClaimSet{"stuck_circle", "Stiffness of a circle that sticks: bristles", [] { return stuck_circle().quantities; }},
      ClaimSet{"creep", "Ball on a standard linear solid, constant load", [] { return held().quantities; }},
      ClaimSet{"creep_ramp", "Ball on a standard linear solid, growing load", [] { return ramped().quantities; }},
      ClaimSet{"unloading", "Ball on a standard linear solid, pressed and released (Ting)",
               [] { return released().quantities; }},
      ClaimSet{"creep_shear", "Ball on a solid whose shear alone creeps, constant load",
               [] { return shear_held().quantities; }},
      ClaimSet{"creep_shear_ccx", "Ball on a solid whose shear alone creeps, constant load, by CalculiX",
               [] { return shear_held_by_calculix().quantities; }},
      ClaimSet{"elastic_pair", "Two elastic bodies of unequal moduli", [] { return elastic_pair().press.quantities; }},
      ClaimSet{"ellipse_05", "Ellipse of contact, R_small / R_large = 0.5",
               [] { return pressed_ellipse(0.5).quantities; }},
      ClaimSet{"ellipse_01", "Ellipse of contact, R_small / R_large = 0.1",
               [] { return pressed_ellipse(0.1).quantities; }},
      ClaimSet{"rubber_hemisphere", "Rubber hemisphere pressed to 0.4 R: large strains",
               [] { return rubber_hemisphere().quantities; }},
      ClaimSet{"fingertip", "Stiffness of a pressed rubber hemisphere that sticks: bristles",
               [] { return fingertip().quantities; }},
      ClaimSet{"pad_disc_0", "Soft round pad turned about a pole at 0 m",
               [] { return pad(PadShape::disc, 0).quantities; }},
      ClaimSet{"pad_disc_05", "Soft round pad turned about a pole at 0.5 m",
               [] { return pad(PadShape::disc, 0.5).quantities; }},
      ClaimSet{"pad_disc_1", "Soft round pad turned about a pole at 1 m",
               [] { return pad(PadShape::disc, 1).quantities; }},
      ClaimSet{"pad_disc_2", "Soft round pad turned about a pole at 2 m",
               [] { return pad(PadShape::disc, 2).quantities; }},
      ClaimSet{"pad_ellipse_05", "Soft elliptic pad turned about a pole at 0.5 m",
               [] { return pad(PadShape::ellipse, 0.5).quantities; }},
      ClaimSet{"pad_rectangle_05", "Soft rectangular pad turned about a pole at 0.5 m",
               [] { return pad(PadShape::rectangle, 0.5).quantities; }},
  };
  return sets;
}

const ClaimSet& claims_of(std::string_view name) {
  const auto sets = all_claims();
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const ClaimSet& set) { return set.name == name; });
  if (found == sets.end()) throw std::out_of_range("no claims about '" + std::string(name) + "'");
  return *found;
}

}  // namespace patchgrip::verification
