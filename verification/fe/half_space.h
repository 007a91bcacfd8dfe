// The elastic half-space of revolution under a force on its axis, cut off at a quarter circle.
//
// Small strains; the field is u = (u_r, u_z), y = z is negative inside. On the far boundary u is Boussinesq's of a
// point force F at the origin,
//
//     u_r = F/(4 pi G) (r Z / q^3 - (1 - 2 nu) r / (q (q + Z))),   u_z = -F/(4 pi G) (Z^2 / q^3 + 2 (1 - nu) / q)
//
// with Z = -z, q^2 = r^2 + Z^2 (Johnson, Contact Mechanics, 3.18): what the size of the body leaves is of the order of
// (a/L)^2 of it. On the axis u_r is held by a spring of 10^5 E n / a; a stiffer one spoils the condition of the system.
//
// Units    as those of the material and the force.
#pragma once

#include <string>

#include <patchgrip/contact/material.h>
#include <patchgrip/verification/fe/model.h>
#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

double shear_modulus(const contact::Material& material);
double lame_modulus(const contact::Material& material);

Point boussinesq_section(const Point& at, double force, const contact::Material& material);  // (u_r, u_z)

// The section alone, its regions marked. Elements at the edge of the contact are smaller by `edge_refinement`.
Model half_space_section(const Setting& setting, double contact_reach, double edge_refinement = 1);

// Fields u and lam, lam [Pa] the pressure where r <= contact_reach; numbers G, la, gam for terms. Neither the strain
// energy nor contact nor the far boundary is said yet.
Model bare_half_space(const Setting& setting, double contact_reach, const contact::Material& material,
                      double edge_refinement = 1);
void set_far_force(Model& model, const Setting& setting, const contact::Material& material, double force);  // far_u

// With the strain energy and the far boundary. Contact is not said yet.
Model half_space_of_revolution(const Setting& setting, double contact_reach, const contact::Material& material,
                               double force, double edge_refinement = 1);

// A rigid body of height f (GetFEM's language) touches without friction; its approach `delta` is unknown, its force
// given. The pressure acts downwards, and with a `slope` (f') along the normal of the body.
void press_without_friction(Model& model, const std::string& height, double force, double approach_to_start,
                            const std::string& slope = "");

std::string strain_of_revolution(const std::string& field);
std::string stretch_around_axis(const std::string& field);  // u_r / r, and on the axis du_r / dr
std::string von_mises_of_revolution();                      // [Pa], from u, G, la

// At radii of the line, by the polynomial through so many neighbouring nodes, 2 or more: straight as a linear multiplier
// is, or the parabola through 3. Throws std::out_of_range where the line has fewer nodes, or is left by more than its
// last two are apart.
std::vector<double> values_at(const std::vector<std::pair<Point, double>>& line, const std::vector<double>& radii,
                              std::size_t points = 2);
// Both up to a radius.
Curve pressure_curve(const std::vector<std::pair<Point, double>>& line, const std::function<double(double)>& library,
                     double reach);

// sqrt(int (lam - p)^2 r dr / int p^2 r dr) over the radii of the line.
double pressure_distance_of(const std::vector<std::pair<Point, double>>& line,
                            const std::function<double(double)>& pressure);

}  // namespace patchgrip::verification
