// A rigid body of revolution on the section of an elastic half-space, as input for CalculiX.
//
// Quadrilaterals of eight nodes with reduced integration (CAX8R). Contact is surface to surface with a linear penalty
// of 100 n^2 E*/a, n elements per contact radius: its error, some 1 / 100 n^2 of the approach, falls as that of the
// mesh, and refinement sees both. The rigid body is one element that cannot change: its height must be a quadratic. A
// hole of 0.003 a keeps faces of contact off the axis, where ccx gets their pressure wrong. It is given the force on the
// whole circle, and prints that on 2 degrees of it.
//
// Names    nodes RIGID and, of them, REFERENCE; elements RIGID, and those of the half-space as the caller says.
// Units    the contact radius is the length 1; the rest as those of the material.
// Throws   pressure: std::out_of_range where the result lacks the stress of a node.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <patchgrip/contact/material.h>
#include <patchgrip/verification/fe/calculix.h>
#include <patchgrip/verification/fe/mesh.h>
#include <patchgrip/verification/fe/model.h>

namespace patchgrip::verification {

struct CalculixPress {
  static constexpr double hole = 0.003;
  static constexpr double sectors = 180;  // of 2 degrees

  // Nodes, elements, surfaces. Several sets of elements share the nodes of the half-space: their stresses add up.
  std::string bodies(const std::vector<std::string>& element_sets) const;
  std::string contact(double contact_modulus) const;
  std::string rigid_as_one() const;  // all of the rigid body moves down as REFERENCE does
  std::string held() const;          // lines of *BOUNDARY: no radial displacement of the rigid body and on the axis
  std::string far_field(double force, const contact::Material& material) const;  // lines of *BOUNDARY, Boussinesq's

  // -sigma_zz at the middles of the sides of elements, which lie between points of integration: what ccx tells of
  // corners, and as pressure of contact, jumps from node to node.
  std::vector<std::pair<Point, double>> pressure(const CalculixResult& result) const;

  QuadSection section;                   // from the hole on
  double extent;                         // of it
  double elements;                       // per contact radius
  std::function<double(double)> height;  // f(r) of the rigid body, a quadratic
  double rigid_reach;                    // radius of the rigid body
  double touched_reach;                  // faces of the half-space up to this radius can touch
};

}  // namespace patchgrip::verification
