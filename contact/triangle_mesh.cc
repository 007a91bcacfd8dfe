#include <patchgrip/contact/triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace patchgrip::contact {
namespace {

Vector minus(const Vector& p, const Vector& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

double dot(const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

Vector cross(const Vector& p, const Vector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

double length(const Vector& p) { return std::hypot(p[0], p[1], p[2]); }

Vector along(const Vector& p, const Vector& direction, double part) {
  return {p[0] + part * direction[0], p[1] + part * direction[1], p[2] + part * direction[2]};
}

std::string named(std::size_t triangle) { return "triangle " + std::to_string(triangle); }

void require_area(const std::vector<Vector>& vertices, const TriangleMesh::Triangle& t, std::size_t index) {
  for (const std::size_t vertex : t) {
    if (vertex >= vertices.size()) {
      throw std::invalid_argument(named(index) + " has corner " + std::to_string(vertex) + ": there are only " +
                                  std::to_string(vertices.size()) + " vertices");
    }
  }
  const Vector u = minus(vertices[t[1]], vertices[t[0]]), v = minus(vertices[t[2]], vertices[t[0]]);
  const double longest = std::max({length(u), length(v), length(minus(u, v))});
  if (!(length(cross(u, v)) > 1e-12 * longest * longest))
    throw std::invalid_argument(named(index) + " has no area: its corners must not lie on one line");
}

// On the segment from p along u.
Vector closest_on_segment(const Vector& p, const Vector& u, const Vector& to) {
  return along(p, u, std::clamp(dot(minus(to, p), u) / dot(u, u), 0., 1.));
}

Vector closest_on_triangle(const Vector& a, const Vector& b, const Vector& c, const Vector& to) {
  const Vector u = minus(b, a), v = minus(c, a), w = minus(to, a);
  const Vector n = cross(u, v);
  const double area = dot(n, n);
  const double beta = dot(cross(w, v), n) / area, gamma = dot(cross(u, w), n) / area;
  if (beta >= 0 && gamma >= 0 && beta + gamma <= 1) return along(along(a, u, beta), v, gamma);
  Vector best = closest_on_segment(a, u, to);
  for (const Vector& other : {closest_on_segment(a, v, to), closest_on_segment(b, minus(c, b), to)}) {
    if (length(minus(other, to)) < length(minus(best, to))) best = other;
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
    volume += dot(minus(vertices[t[0]], vertices[triangles[0][0]]),
                  cross(minus(vertices[t[1]], vertices[t[0]]), minus(vertices[t[2]], vertices[t[0]])));
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
  Closest best{vertices_[triangles_[0][0]], 0, length(minus(vertices_[triangles_[0][0]], point))};
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Triangle& t = triangles_[i];
    const Vector candidate = closest_on_triangle(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]], point);
    const double distance = length(minus(candidate, point));
    if (distance < best.distance) best = {candidate, i, distance};
  }
  return best;
}

Vector TriangleMesh::normal(std::size_t triangle) const {
  const Triangle& t = triangles_.at(triangle);
  const Vector n = cross(minus(vertices_[t[1]], vertices_[t[0]]), minus(vertices_[t[2]], vertices_[t[0]]));
  const double size = length(n);
  return {n[0] / size, n[1] / size, n[2] / size};
}

}  // namespace patchgrip::contact
