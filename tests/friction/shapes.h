// Polygons that friction of a uniform pressure is tried on, from a triangle to a needle.
#pragma once

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/polygon_rings.h>

namespace patchgrip::friction {

using PointRing = std::vector<Point>;

struct Shape {
  std::string name;
  PointRing outer;
  std::vector<PointRing> holes = {};

  Polygon patch() const { return Polygon::uniform(outer, holes); }
  std::vector<std::vector<kernels::Vertex>> rings() const { return oriented_rings(outer, holes); }
};

inline void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

inline PointRing turned(const PointRing& ring, double angle) {
  PointRing result;
  for (const Point& p : ring) {
    result.push_back({p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)});
  }
  return result;
}

inline PointRing moved(PointRing ring, double x, double y) {
  for (Point& p : ring) p = {p.x + x, p.y + y};
  return ring;
}

inline PointRing scaled(PointRing ring, double k) {
  for (Point& p : ring) p = {k * p.x, k * p.y};
  return ring;
}

inline PointRing box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

inline PointRing regular(int corners, double radius) {
  PointRing ring;
  for (int k = 0; k < corners; ++k) {
    const double phi = 2 * std::numbers::pi * k / corners;
    ring.push_back({radius * std::cos(phi), radius * std::sin(phi)});
  }
  return ring;
}

// Dyadic coordinates: moving it by whole numbers is exact.
inline const PointRing l_ring{{-0.75, -0.75}, {1.25, -0.75}, {1.25, -0.25},
                              {-0.25, -0.25}, {-0.25, 1.25}, {-0.75, 1.25}};

inline const Shape triangle{"Triangle", {{0, 0}, {0.03, 0.004}, {0.011, 0.021}}};
inline const Shape square{"Square", box(-1, -1, 1, 1)};
inline const Shape l_shape{"LShape", l_ring};
inline const Shape frame{"Frame", box(-2, -1, 2, 1), {box(-1.875, -0.875, 0, 0.875), box(0.125, -0.875, 1.875, 0.875)}};
inline const Shape comb{"Comb",
                        {{0, 0},
                         {7, 0},
                         {7, 3},
                         {6, 3},
                         {6, 1},
                         {5, 1},
                         {5, 3},
                         {4, 3},
                         {4, 1},
                         {3, 1},
                         {3, 3},
                         {2, 3},
                         {2, 1},
                         {1, 1},
                         {1, 3},
                         {0, 3}}};
inline const Shape many_sided{"ManySided", regular(24, 0.05)};
inline const Shape slender_10{"Slender10", turned(box(-1, -0.1, 1, 0.1), 0.3)};
inline const Shape slender_100{"Slender100", turned(box(-1, -0.01, 1, 0.01), 1.2)};
inline const Shape slender_1000{"Slender1000", turned(box(-1, -0.001, 1, 0.001), -0.7)};
inline const Shape away{"Away", moved(l_ring, 1536, -1024)};  // 1e3 of its radii from the origin
inline const Shape micrometre{"Micrometre", scaled(l_ring, 1e-6)};

inline const std::vector<Shape> all_shapes{triangle,   square,      l_shape,      frame, comb,      many_sided,
                                           slender_10, slender_100, slender_1000, away,  micrometre};

}  // namespace patchgrip::friction
