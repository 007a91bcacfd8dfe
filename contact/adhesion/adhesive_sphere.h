// An adhesive contact of two spheres: what every model of adhesion starts from.
//
//     w = gamma_1 + gamma_2 - gamma_12 [J/m^2], the work to part a unit area; the seed's gamma is w/2 (4.1.4)
//
// Domain   all three positive; a paraboloid of radius R stands for the gap (hertz_circle.h).
// Units    R [m], E* [Pa], w [J/m^2], forces [N].
// Error    force_above: <= 2^-9 units of 2^-53, relative, also next to its zero, the load that parts the bodies: the
//          product is formed to twice the digits of long double.
// Throws   std::invalid_argument, naming the parameter, outside the domain.
#pragma once

namespace patchgrip::contact {

struct AdhesiveSphere {
  static AdhesiveSphere of(double relative_radius, double contact_modulus, double work_of_adhesion);

  long double pi_w_R() const;  // [N]

  // multiple F + parts pi w R, for small whole numbers.
  long double force_above(int multiple, double force, int parts) const;

  double relative_radius;   // R [m]
  double contact_modulus;   // E* [Pa]
  double work_of_adhesion;  // w [J/m^2]
};

// One state of equilibrium of an adhesive contact; compression positive.
struct AdhesiveState {
  double normal_force;    // F [N], negative in tension
  double approach;        // delta [m]
  double contact_radius;  // a [m]
  double stiffness;       // dF/d(delta) [N/m], along the curve of equilibria
};

}  // namespace patchgrip::contact
