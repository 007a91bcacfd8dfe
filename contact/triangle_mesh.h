// Surface of a body as triangles: read, checked once, and the point of it closest to a given one.
//
// Files: .off, .ply (text or binary) and .stl (text or binary; its corners are joined where they coincide exactly). The
// triangles are seen counter-clockwise from outside; a closed surface that is turned inside out is turned back.
//
// Domain   every edge has one triangle (border) or two, which see it in opposite directions; no triangle without area;
//          no more than 1e8 triangles.
// Units    [m], as in the file: it has none of its own.
// Error    closest point: a few units of rounding of the size of the coordinates.
// Fails    self-intersections are not looked for.
// Throws   std::invalid_argument, naming the file or the triangle: a file that cannot be opened, is empty, cut off, not
//          a mesh or of unknown kind; coordinates that are not finite; triangles, edges and orientations as above.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <patchgrip/contact/principal_curvatures.h>

namespace patchgrip::contact {

class TriangleMesh {
 public:
  using Triangle = std::array<std::size_t, 3>;

  static TriangleMesh read(const std::string& file);
  static TriangleMesh of(std::vector<Vector> vertices, std::vector<Triangle> triangles);

  struct Closest {
    Vector point;  // on the triangle [m]
    std::size_t triangle;
    double distance;  // [m]
  };
  Closest closest_to(const Vector& point) const;  // looks at every triangle

  const std::vector<Vector>& vertices() const noexcept { return vertices_; }
  const std::vector<Triangle>& triangles() const noexcept { return triangles_; }
  const std::vector<std::size_t>& neighbours(std::size_t vertex) const { return neighbours_[vertex]; }
  bool on_border(std::size_t vertex) const { return on_border_[vertex]; }
  Vector normal(std::size_t triangle) const;  // unit, outwards

 private:
  std::vector<Vector> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<std::size_t>> neighbours_;
  std::vector<bool> on_border_;
};

}  // namespace patchgrip::contact
