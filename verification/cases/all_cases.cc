#include <array>

#include <patchgrip/verification/cases/bodies.h>
#include <patchgrip/verification/cases/case.h>
#include <patchgrip/verification/cases/creep.h>
#include <patchgrip/verification/cases/pad.h>
#include <patchgrip/verification/cases/press.h>
#include <patchgrip/verification/cases/punch.h>
#include <patchgrip/verification/cases/shear.h>
#include <patchgrip/verification/claims/creep.h>
#include <patchgrip/verification/claims/punch.h>
#include <patchgrip/verification/claims/shear.h>

namespace patchgrip::verification {
namespace {

const std::vector<Setting> sections{{10, 20}, {20, 20}, {40, 20}};
const std::vector<Setting> coarse_sections{{5, 20}, {10, 20}, {20, 20}};
const std::vector<Setting> fine_section{{40, 20}};
const std::vector<Setting> creep_steps{{3, 20}, {6, 20}, {12, 20}};
const std::vector<Setting> finer_creep{{24, 20}};
const std::vector<Setting> quarters{{3, 8}, {4, 8}, {6, 8}};
const std::vector<Setting> finer_quarter{{8, 8}};
const std::vector<Setting> pads{{2, 0}, {3, 0}, {4, 0}};
const std::vector<Setting> finer_pad{{6, 0}, {8, 0}};
const std::vector<Setting> finer_section{{80, 20}};

template <PadShape shape, int pole_in_halves>
Case pad_case(std::string_view name, std::string_view title) {
  return {name,
          title,
          pads,
          finer_pad,
          [] { return pad(shape, pole_in_halves / 2.).quantities; },
          [](const Setting& setting) { return solve_pad(pad(shape, pole_in_halves / 2.), setting); }};
}

}  // namespace

std::span<const Case> all_cases() {
  static const std::array cases{
      Case{"sphere", "Rigid sphere on a half-space, a/R = 0.001 (Hertz)", sections, finer_section,
           [] { return pressed_paraboloid().quantities; },
           [](const Setting& setting) { return solve_press(pressed_paraboloid(), setting); }},
      Case{"sphere_01", "Rigid sphere on a half-space, a/R = 0.1", sections, finer_section,
           [] { return pressed_sphere(0.1).quantities; },
           [](const Setting& setting) { return solve_press(pressed_sphere(0.1), setting); }},
      Case{"sphere_05", "Rigid sphere on a half-space, a/R = 0.5", sections, finer_section,
           [] { return pressed_sphere(0.5).quantities; },
           [](const Setting& setting) { return solve_press(pressed_sphere(0.5), setting); }},
      Case{"sphere_08", "Rigid sphere on a half-space, a/R = 0.8", sections, finer_section,
           [] { return pressed_sphere(0.8).quantities; },
           [](const Setting& setting) { return solve_press(pressed_sphere(0.8), setting); }},
      Case{"moved_points", "Rigid paraboloid, a/R = 0.1, that touches points where they have gone", sections,
           finer_section, [] { return pressed_paraboloid_at_moved_points().quantities; },
           [](const Setting& setting) { return solve_press(pressed_paraboloid_at_moved_points(), setting); }},
      Case{"flat_punch", "Rigid flat punch on a half-space", sections, finer_section,
           [] { return flat_punch().quantities; }, solve_flat_punch},
      Case{"rough_punch", "Stick under a rigid flat punch with friction (Spence)", sections, finer_section,
           [] { return rough_punch().quantities; }, solve_rough_punch},
      Case{"torsion", "Hertz contact twisted: partial slip (Lubkin)", sections, finer_section,
           [] { return torsion().quantities; }, solve_torsion},
      Case{"shear", "Hertz contact sheared: partial slip (Cattaneo, Mindlin)", coarse_sections, fine_section,
           [] { return shear().quantities; }, solve_shear},
      Case{"stuck_circle", "Stiffness of a circle that sticks: bristles", sections, finer_section,
           [] { return stuck_circle().quantities; }, solve_stuck_circle},
      Case{"creep", "Ball on a standard linear solid, constant load", creep_steps, finer_creep,
           [] { return held().quantities; }, [](const Setting& setting) { return solve_creep(held(), setting); }},
      Case{"creep_ramp", "Ball on a standard linear solid, growing load", creep_steps, finer_creep,
           [] { return ramped().quantities; }, [](const Setting& setting) { return solve_creep(ramped(), setting); }},
      Case{"unloading", "Ball on a standard linear solid, pressed and released (Ting)", creep_steps, finer_creep,
           [] { return released().quantities; },
           [](const Setting& setting) { return solve_creep(released(), setting); }},
      Case{"elastic_pair", "Two elastic bodies of unequal moduli", sections, finer_section,
           [] { return elastic_pair().press.quantities; }, solve_elastic_pair},
      Case{"ellipse_05", "Ellipse of contact, R_small / R_large = 0.5", quarters, finer_quarter,
           [] { return pressed_ellipse(0.5).quantities; },
           [](const Setting& setting) { return solve_ellipse(pressed_ellipse(0.5), setting); }},
      Case{"ellipse_01", "Ellipse of contact, R_small / R_large = 0.1", quarters, finer_quarter,
           [] { return pressed_ellipse(0.1).quantities; },
           [](const Setting& setting) { return solve_ellipse(pressed_ellipse(0.1), setting); }},
      Case{"rubber_hemisphere",
           "Rubber hemisphere pressed to 0.4 R: large strains",
           {{5, 0}, {10, 0}, {20, 0}},
           {{40, 0}},
           [] { return rubber_hemisphere().quantities; },
           solve_rubber_hemisphere},
      pad_case<PadShape::disc, 0>("pad_disc_0", "Soft round pad turned about a pole at 0 m"),
      pad_case<PadShape::disc, 1>("pad_disc_05", "Soft round pad turned about a pole at 0.5 m"),
      pad_case<PadShape::disc, 2>("pad_disc_1", "Soft round pad turned about a pole at 1 m"),
      pad_case<PadShape::disc, 4>("pad_disc_2", "Soft round pad turned about a pole at 2 m"),
      pad_case<PadShape::ellipse, 1>("pad_ellipse_05", "Soft elliptic pad turned about a pole at 0.5 m"),
      pad_case<PadShape::rectangle, 1>("pad_rectangle_05", "Soft rectangular pad turned about a pole at 0.5 m"),
  };
  return cases;
}

}  // namespace patchgrip::verification
