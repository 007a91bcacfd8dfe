#include <iostream>

#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/rectangle.h>

int main() {
  using namespace patchgrip::friction;
  const LimitSurface surface(Rectangle::of_sides(40e-3, 10e-3));     // a block of 40 mm by 10 mm
  const Gauge gauge = surface.gauge({.fx = 2, .fy = 1, .m = 0.05});  // load: 2 N, 1 N and 0.05 N m
  const Pole pole{-gauge.twist.vy / gauge.twist.w, gauge.twist.vx / gauge.twist.w};
  std::cout << "friction must hold " << gauge.value << " N, else it slips about (" << pole.x << ", " << pole.y
            << ") m\n";
}
