#include <iostream>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/law.h>

int main() {
  using namespace patchgrip::friction;
  const auto patch = HertzDisc::of_radius(2e-3);                               // a = 2 mm
  const auto motion = twist_about(Pole{1e-3, 1e-3}, 0.5);                      // 0.5 rad/s about the pole (1 mm, 1 mm)
  const auto friction = friction_wrench(Law::coulomb(0.4), 3, patch, motion);  // mu = 0.4, F_N = 3 N
  const auto& [force_x, force_y, moment] = friction.value;
  std::cout << "force (" << force_x << ", " << force_y << ") N +- " << friction.force_error << "\n"
            << "moment " << moment << " N m +- " << friction.moment_error << "\n";
}
