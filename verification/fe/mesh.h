// Meshes of the bodies that are verified, made by gmsh and written as files of its format 2.2, which GetFEM reads.
//
// Bodies of revolution are meshed as their section in the half-plane x = r, y = z; the axis is x = 0. The surface of a
// half-space is y = 0 (z = 0 in space), the material below it. Half-spaces end on a quarter circle or an eighth of a
// sphere.
//
// Units    any length, e.g. the contact radius; a size is the wanted length of an edge of an element at a point.
// Throws   std::runtime_error with gmsh's own words.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

namespace patchgrip::verification {

using SizeAt = std::function<double(double x, double y, double z)>;

// `fine` up to the distance `reach` from the origin, and from there growing by `growth` per length.
SizeAt graded(double fine, double reach, double growth);

struct Mesh {
  static Mesh half_space_section(double extent, double split, const SizeAt& size);  // with a node at (split, 0)
  static Mesh half_space_quarter(double extent, const SizeAt& size);                // x >= 0, y >= 0, z <= 0
  static Mesh hemisphere_section(double radius, const SizeAt& size);                // apex at (0, -radius), curved
  static Mesh elliptic_pad(double a, double b, double height, double size);         // 0 <= z <= height, curved
  static Mesh box_pad(double side_x, double side_y, double height, double size);    // 0 <= z <= height

  std::filesystem::path file;  // kept until the program ends
  int dimension;
};

// The section of a half-space as quadrilaterals of eight nodes, in a block inner <= x <= extent, -extent <= y <= 0.
// Corners turn anticlockwise, then come the middles of their sides.
struct QuadSection {
  // Square ones, `elements` per length, up to 1.5, with sides at x = 1.
  static QuadSection half_space(double inner, double extent, double elements);
  // At (edge, 0) smaller by `edge_refinement`; from there they grow by 2 / elements each.
  static QuadSection half_space_with_edge(double inner, double edge, double extent, double elements,
                                          double edge_refinement);

  std::vector<std::array<double, 2>> nodes;
  std::vector<std::array<std::size_t, 8>> elements;
};

}  // namespace patchgrip::verification
