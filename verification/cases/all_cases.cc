#include <array>

#include <patchgrip/verification/cases/case.h>
#include <patchgrip/verification/cases/press.h>
#include <patchgrip/verification/cases/punch.h>
#include <patchgrip/verification/cases/shear.h>
#include <patchgrip/verification/claims/punch.h>
#include <patchgrip/verification/claims/shear.h>

namespace patchgrip::verification {
namespace {

const std::vector<Setting> sections{{10, 20}, {20, 20}, {40, 20}};
const std::vector<Setting> coarse_sections{{5, 20}, {10, 20}, {20, 20}};
const std::vector<Setting> fine_section{{40, 20}};
const std::vector<Setting> finer_section{{80, 20}};

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
  };
  return cases;
}

}  // namespace patchgrip::verification
