// patchgrip::contact alone: the FFTW of its half-space comes along without asking.
#include <iostream>

#include <patchgrip/contact/hertz_circle.h>

int main() {
  const auto circle = patchgrip::contact::HertzCircle::under_force(1, 10e-3, 1e6);
  std::cout << "contact radius " << circle.radius << " m\n";
}
