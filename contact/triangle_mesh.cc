#include <patchgrip/contact/triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

namespace patchgrip::contact {
namespace {

using Eigen::Vector3d;

Vector3d at(const Vector& v) { return {v[0], v[1], v[2]}; }

std::string named(std::size_t triangle) { return "triangle " + std::to_string(triangle); }

void require_area(const std::vector<Vector>& vertices, const TriangleMesh::Triangle& t, std::size_t index) {
  for (const std::size_t vertex : t) {
    if (vertex >= vertices.size()) {
      throw std::invalid_argument(named(index) + " has corner " + std::to_string(vertex) + ": there are only " +
                                  std::to_string(vertices.size()) + " vertices");
    }
  }
  const Vector3d u = at(vertices[t[1]]) - at(vertices[t[0]]), v = at(vertices[t[2]]) - at(vertices[t[0]]);
  const double longest = std::max({u.stableNorm(), v.stableNorm(), (u - v).stableNorm()});
  if (!(u.cross(v).stableNorm() > 1e-12 * longest * longest))
    throw std::invalid_argument(named(index) + " has no area: its corners must not lie on one line");
}

// On the segment from p along u.
Vector3d closest_on_segment(const Vector3d& p, const Vector3d& u, const Vector3d& to) {
  return p + std::clamp((to - p).dot(u) / u.squaredNorm(), 0., 1.) * u;
}

Vector3d closest_on_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& to) {
  const Vector3d u = b - a, v = c - a, w = to - a;
  const Vector3d n = u.cross(v);
  const double area = n.squaredNorm();
  const double beta = w.cross(v).dot(n) / area, gamma = u.cross(w).dot(n) / area;
  if (beta >= 0 && gamma >= 0 && beta + gamma <= 1) return a + beta * u + gamma * v;
  Vector3d best = closest_on_segment(a, u, to);
  for (const Vector3d& other : {closest_on_segment(a, v, to), closest_on_segment(b, c - b, to)}) {
    if ((other - to).stableNorm() < (best - to).stableNorm()) best = other;
  }
  return best;
}

}  // namespace

TriangleMesh TriangleMesh::of(std::vector<Vector> vertices, std::vector<Triangle> triangles) {
  if (triangles.empty()) throw std::invalid_argument("mesh has no triangles: a surface needs at least one");
  if (triangles.size() > 100000000) throw std::invalid_argument("mesh has more than 1e8 triangles");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (const double x : vertices[i]) {
      if (!std::isfinite(x)) throw std::invalid_argument("vertex " + std::to_string(i) + " is not finite");
    }
  }
  TriangleMesh mesh;
  // Directed edges: each may be there once, and its opposite once.
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> edges;
  double volume = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    require_area(vertices, t, i);
    const Vector3d corner = at(vertices[t[0]]);
    volume +=
        (corner - at(vertices[triangles[0][0]])).dot((at(vertices[t[1]]) - corner).cross(at(vertices[t[2]]) - corner));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [edge, added] = edges.try_emplace({t[k], t[(k + 1) % 3]}, i);
      if (!added) {
        throw std::invalid_argument("triangles " + std::to_string(edge->second) + " and " + std::to_string(i) +
                                    " see their edge in the same direction: an edge has at most two triangles, "
                                    "turned the same way");
      }
    }
  }
  mesh.neighbours_.resize(vertices.size());
  mesh.on_border_.assign(vertices.size(), false);
  bool closed = true;
  for (const auto& [edge, triangle] : edges) {
    const auto [from, to] = edge;
    mesh.neighbours_[from].push_back(to);
    if (edges.find({to, from}) == edges.end()) {
      closed = false;
      mesh.on_border_[from] = mesh.on_border_[to] = true;
      mesh.neighbours_[to].push_back(from);
    }
  }
  if (closed && volume < 0) {
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
  }
  mesh.vertices_ = std::move(vertices);
  mesh.triangles_ = std::move(triangles);
  return mesh;
}

TriangleMesh::Closest TriangleMesh::closest_to(const Vector& point) const {
  for (const double x : point) {
    if (!std::isfinite(x)) throw std::invalid_argument("point is not finite");
  }
  const Vector3d to = at(point);
  Closest best{vertices_[triangles_[0][0]], 0, (at(vertices_[triangles_[0][0]]) - to).stableNorm()};
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Triangle& t = triangles_[i];
    const Vector3d candidate = closest_on_triangle(at(vertices_[t[0]]), at(vertices_[t[1]]), at(vertices_[t[2]]), to);
    const double distance = (candidate - to).stableNorm();
    if (distance < best.distance) best = {{candidate[0], candidate[1], candidate[2]}, i, distance};
  }
  return best;
}

Vector TriangleMesh::normal(std::size_t triangle) const {
  const Triangle& t = triangles_.at(triangle);
  const Vector3d corner = at(vertices_[t[0]]);
  const Vector3d n = (at(vertices_[t[1]]) - corner).cross(at(vertices_[t[2]]) - corner).stableNormalized();
  return {n[0], n[1], n[2]};
}

}  // namespace patchgrip::contact
