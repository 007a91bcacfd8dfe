// How far attraction reaches, against how far the surfaces are drawn: the parameters that tell JKR from DMT.
//
//     mu_T = (R w^2 / (E*^2 z_0^3))^(1/3)                                   (Tabor, J. Colloid Interface Sci. 58, 1977)
//     lambda = 2 sigma_0 (R / (pi w K^2))^(1/3),   K = 4 E*/3                      (Maugis, same 150, 1992)
//     sigma_0 = 16 w / (9 sqrt(3) z_0)    largest attraction of the Lennard-Jones law (8w/3z_0)[(z_0/z)^3 - (z_0/z)^9]
//     sigma_0 = w / z_0                   Dugdale stress that does the same work within z_0
//
// With the first sigma_0, lambda = 1.15701 mu_T. DMT holds below about 0.1, JKR above about 5; between:
// maugis_dugdale.h.
//
// Domain   all arguments positive.
// Units    z_0 [m], the distance of equilibrium; sigma_0 [Pa]; mu_T, lambda [1].
// Error    <= 1.01 units of 2^-53, relative; tests/contact/tabor_test.cc.
// Throws   std::invalid_argument, naming the parameter, outside the domain.
#pragma once

#include <patchgrip/contact/adhesion/adhesive_sphere.h>

namespace patchgrip::contact {

double tabor_parameter(const AdhesiveSphere& sphere, double equilibrium_distance);
double maugis_parameter(const AdhesiveSphere& sphere, double attraction);
long double unrounded_maugis_parameter(const AdhesiveSphere& sphere, double attraction);

double lennard_jones_attraction(double work_of_adhesion, double equilibrium_distance);
double dugdale_attraction(double work_of_adhesion, double range);

}  // namespace patchgrip::contact
