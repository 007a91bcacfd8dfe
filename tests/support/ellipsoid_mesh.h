// Triangles on an ellipsoid: a subdivided icosahedron, every vertex on the surface.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace patchgrip::testing {

struct Triangles {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// 10 * 4^levels + 2 vertices, triangles counter-clockwise from outside.
inline Triangles ellipsoid_mesh(int levels, double ax, double ay, double az) {
  const double g = (1 + std::sqrt(5.)) / 2;
  Triangles mesh{{{-1, g, 0},
                  {1, g, 0},
                  {-1, -g, 0},
                  {1, -g, 0},
                  {0, -1, g},
                  {0, 1, g},
                  {0, -1, -g},
                  {0, 1, -g},
                  {g, 0, -1},
                  {g, 0, 1},
                  {-g, 0, -1},
                  {-g, 0, 1}},
                 {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                  {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                  {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t i, std::size_t j) {
      const auto [entry, added] = middles.try_emplace(std::minmax(i, j), mesh.vertices.size());
      if (added) {
        const auto p = mesh.vertices[i], q = mesh.vertices[j];
        mesh.vertices.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
      }
      return entry->second;
    };
    std::vector<std::array<std::size_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
    for (auto& v : mesh.vertices) {
      const double size = std::hypot(v[0], v[1], v[2]);
      for (double& x : v) x /= size;
    }
  }
  for (auto& v : mesh.vertices) {
    const double size = std::hypot(v[0], v[1], v[2]);
    v = {ax * v[0] / size, ay * v[1] / size, az * v[2] / size};
  }
  return mesh;
}

}  // namespace patchgrip::testing
