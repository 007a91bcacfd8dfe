#include <array>

#include <patchgrip/verification/cases/case.h>
#include <patchgrip/verification/cases/press.h>

namespace patchgrip::verification {
namespace {

const std::vector<Setting> sections{{10, 20}, {20, 20}, {40, 20}};
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
  };
  return cases;
}

}  // namespace patchgrip::verification
