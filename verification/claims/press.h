// Presses of rigid bodies of revolution into an elastic half-space under a given force: what the library says.
//
// The bodies press so that the library's contact radius is 1 m: the unit of length. Quantities: approach, the root
// mean square radius of the pressure, sqrt(<r^2>_p) (0.632 a for Hertz), p(0), p(r), and the L2 distance of p(r).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <patchgrip/contact/material.h>
#include <patchgrip/verification/claims/claim.h>

namespace patchgrip::verification {

struct PressedBody {
  contact::Material material;               // of the half-space
  double force;                             // F [N]
  double approach;                          // delta [m]
  std::string height;                       // f(r) in the language of GetFEM
  std::function<double(double)> height_at;  // f(r) [m]
  std::function<double(double)> pressure;   // p(r) [Pa]
  std::vector<double> radii;                // where p is compared [m]
  std::vector<Quantity> quantities;
  std::string slope;  // f'(r) in the language of GetFEM, where the pressure acts along the normal
};

PressedBody pressed_paraboloid(double contact_modulus = 1000);
std::vector<Quantity> paraboloid_at_approach();  // its force and pressure, where the approach is given
PressedBody pressed_sphere(double contact_over_sphere_radius);
// Hertz where a/R = 0.1, against a body that touches points where they have gone, f(r + u_r) in place of f(r), and
// presses along its normal: 1.6 % more force at the same approach, which no mesh takes away.
PressedBody pressed_paraboloid_at_moved_points();

}  // namespace patchgrip::verification
