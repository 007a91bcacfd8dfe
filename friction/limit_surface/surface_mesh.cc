#include <patchgrip/friction/limit_surface/surface_mesh.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {
namespace {

using Point = std::array<double, 3>;

Point on_sphere(const Point& p) {
  const double r = std::hypot(p[0], p[1], p[2]);
  return {p[0] / r, p[1] / r, p[2] / r};
}

// Poles on the axis of moments.
Sphere icosahedron() {
  Sphere s;
  s.points.push_back({0, 0, 1});
  for (const double side : {1, -1}) {
    for (int i = 0; i < 5; ++i) {
      const double phi = std::numbers::pi / 5 * (2 * i + (side > 0 ? 0 : 1));
      s.points.push_back(on_sphere({2 * std::cos(phi), 2 * std::sin(phi), side}));
    }
  }
  s.points.push_back({0, 0, -1});
  for (std::uint32_t i = 0; i < 5; ++i) {
    const std::uint32_t next = (i + 1) % 5;
    const std::uint32_t a = 1 + i, b = 1 + next, c = 6 + i, d = 6 + next;
    s.triangles.push_back({0, a, b});
    s.triangles.push_back({a, c, b});
    s.triangles.push_back({b, c, d});
    s.triangles.push_back({c, 11, d});
  }
  return s;
}

Sphere refined(const Sphere& coarse) {
  Sphere fine{coarse.points, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.points.size()));
    if (is_new) {
      const Point &p = coarse.points[a], &q = coarse.points[b];
      fine.points.push_back(on_sphere({p[0] + q[0], p[1] + q[1], p[2] + q[2]}));
    }
    return at->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.push_back({a, ab, ca});
    fine.triangles.push_back({ab, b, bc});
    fine.triangles.push_back({ca, bc, c});
    fine.triangles.push_back({ab, bc, ca});
  }
  return fine;
}

}  // namespace

Sphere icosphere(int refinements) {
  contact::require_in("refinements", refinements, 0, 7);
  Sphere sphere = icosahedron();
  for (int i = 0; i < refinements; ++i) sphere = refined(sphere);
  return sphere;
}

}  // namespace patchgrip::friction
