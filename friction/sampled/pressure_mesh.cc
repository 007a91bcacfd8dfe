#include <patchgrip/friction/sampled/pressure_mesh.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/sampled/mesh_pieces.h>
#include <patchgrip/friction/sampled/sampled_pressure.h>

namespace patchgrip::friction {
namespace {

using kernels::LoadedTriangle;
using kernels::MeshPieces;
using kernels::PressureFrame;
// Far poles see the centroid's last digits.
using Wide = boost::multiprecision::cpp_bin_float_quad;

// Twice the signed area.
Wide cross(const Triangulation& mesh, const std::array<std::size_t, 3>& t) {
  const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
  return (Wide(b.x) - a.x) * (Wide(c.y) - a.y) - (Wide(b.y) - a.y) * (Wide(c.x) - a.x);
}

// Thinner triangles have no area in double: their height is a rounding of the longest edge.
constexpr double least_height = 1e-14;

double longest_edge(const Triangulation& mesh, const std::array<std::size_t, 3>& t) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &p = mesh.points[t[i]], &q = mesh.points[t[(i + 1) % 3]];
    longest = std::max(longest, std::hypot(q.x - p.x, q.y - p.y));
  }
  return longest;
}

void require_mesh(const Triangulation& mesh) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!std::isfinite(mesh.points[i].x))
      contact::require_finite("points[" + std::to_string(i) + "].x", mesh.points[i].x);
    if (!std::isfinite(mesh.points[i].y))
      contact::require_finite("points[" + std::to_string(i) + "].y", mesh.points[i].y);
  }
  if (mesh.triangles.empty() || mesh.triangles.size() > PressureMesh::most_triangles) {
    throw std::invalid_argument("triangles has " + std::to_string(mesh.triangles.size()) +
                                " entries: from 1 to 2^24 are allowed");
  }
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    const std::string name = "triangles[" + std::to_string(k) + "]";
    for (const std::size_t i : t) {
      if (i >= mesh.points.size()) {
        throw std::invalid_argument(name + " names point " + std::to_string(i) + ": there are " +
                                    std::to_string(mesh.points.size()) + ", counted from 0");
      }
    }
    const double longest = longest_edge(mesh, t);
    if (!(std::fabs(static_cast<double>(cross(mesh, t))) > least_height * longest * longest))
      throw std::invalid_argument(name + " has no area: its corners must not lie on one line");
  }
}

void require_pressures(const std::vector<double>& pressures, std::size_t count, const char* of) {
  if (pressures.size() != count) {
    throw std::invalid_argument("pressures has " + std::to_string(pressures.size()) + " numbers: one for each of " +
                                std::to_string(count) + " " + of + " is expected");
  }
  for (std::size_t k = 0; k < pressures.size(); ++k) {
    const double p = pressures[k];
    if (!(p >= 0) || !std::isfinite(p)) contact::require_non_negative("pressures[" + std::to_string(k) + "]", p);
  }
}

// Counter-clockwise, without those that carry no pressure.
template <class PressureOf>
std::vector<LoadedTriangle> loaded_triangles(const Triangulation& mesh, const PressureOf& pressure_of) {
  std::vector<LoadedTriangle> result;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    LoadedTriangle t{mesh.triangles[k], {}};
    if (cross(mesh, t.corners) < 0) std::swap(t.corners[1], t.corners[2]);
    for (std::size_t i = 0; i < 3; ++i) t.pressures[i] = pressure_of(k, t.corners[i]);
    if (t.pressures[0] > 0 || t.pressures[1] > 0 || t.pressures[2] > 0) result.push_back(t);
  }
  if (result.empty()) throw std::invalid_argument("pressures are all 0 on the triangles: one must be positive");
  return result;
}

// Points seen from the centre of pressure are rounded: small triangles far from it may lose their area.
void require_area(const LoadedTriangle& t, const std::vector<double>& x, const std::vector<double>& y) {
  const auto [a, b, c] = t.corners;
  if (!((x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]) > 0)) {
    throw std::invalid_argument("the triangle of points " + std::to_string(a) + ", " + std::to_string(b) + ", " +
                                std::to_string(c) + " is too small: seen from the centre of pressure its corners " +
                                "must not round to one line");
  }
}

struct MeshMoments {
  Wide area{0}, force{0};
  Wide x{0}, y{0};  // centroid
  Wide polar{0};
};

// With the barycentric coordinates l: int l_i dA = A/3, int l_i l_j dA = A/12 (1 + [i = j]), int l_i l_j l_k dA = A/60
// times 6 for three equal ones, 2 for two.
MeshMoments mesh_moments(const Triangulation& mesh, const std::vector<LoadedTriangle>& triangles) {
  MeshMoments m;
  const Point& origin = mesh.points[triangles[0].corners[0]];
  for (const LoadedTriangle& t : triangles) {
    const Wide area = cross(mesh, t.corners) / 2;
    std::array<Wide, 3> x, y;
    Wide sum_p = 0, sum_x = 0, sum_y = 0, squares = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = Wide(mesh.points[t.corners[i]].x) - origin.x;
      y[i] = Wide(mesh.points[t.corners[i]].y) - origin.y;
      sum_p += t.pressures[i];
      sum_x += x[i];
      sum_y += y[i];
      squares += x[i] * x[i] + y[i] * y[i];
    }
    Wide px = 0, py = 0, second = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Wide p = t.pressures[i];
      px += p * (sum_x + x[i]);
      py += p * (sum_y + y[i]);
      // sum over j, k of l_i l_j l_k x_j x_k
      second += p * (sum_x * sum_x + sum_y * sum_y + squares + 2 * (x[i] * (sum_x + x[i]) + y[i] * (sum_y + y[i])));
    }
    m.area += area;
    m.force += area * sum_p / 3;
    m.x += area * px / 12;
    m.y += area * py / 12;
    m.polar += area * second / 60;
  }
  m.x /= m.force;
  m.y /= m.force;
  m.polar = m.polar / m.force - m.x * m.x - m.y * m.y;
  m.x += origin.x;
  m.y += origin.y;
  return m;
}

std::shared_ptr<const kernels::SampledPressure> make(const Triangulation& mesh, std::vector<LoadedTriangle> triangles,
                                                     double tolerance) {
  const MeshMoments m = mesh_moments(mesh, triangles);
  PressureFrame frame;
  frame.x = static_cast<double>(m.x);
  frame.y = static_cast<double>(m.y);
  frame.offset_x = static_cast<long double>(m.x - frame.x);
  frame.offset_y = static_cast<long double>(m.y - frame.y);
  frame.area = contact::require_representable("area", static_cast<double>(m.area));
  frame.polar = contact::require_representable("polar moment", static_cast<double>(m.polar));
  double radius = 0;
  for (const LoadedTriangle& t : triangles) {
    for (const std::size_t i : t.corners)
      radius = std::max(radius, std::hypot(mesh.points[i].x - frame.x, mesh.points[i].y - frame.y));
  }
  frame.scale = std::scalbn(1.0, std::ilogb(radius));
  frame.centroid_error = 0x1p-100 * radius;

  std::vector<double> x, y;
  for (const Point& p : mesh.points) {
    x.push_back((p.x - frame.x) / frame.scale);
    y.push_back((p.y - frame.y) / frame.scale);
  }
  for (const LoadedTriangle& t : triangles) require_area(t, x, y);
  const auto factor = static_cast<long double>(Wide(frame.scale) * frame.scale / m.force);
  for (LoadedTriangle& t : triangles) {
    for (double& p : t.pressures) {
      p = static_cast<double>(p * factor);
      frame.highest = std::max(frame.highest, p);
    }
  }
  // Of about 64 triangles the exact sums take as long as the loads in their place.
  const std::size_t leaf = tolerance > 0 ? 64 : triangles.size();
  auto pieces = std::make_unique<MeshPieces>(std::move(x), std::move(y), std::move(triangles));
  auto nodes = pieces->make_tree(leaf);
  return std::make_shared<const kernels::SampledPressure>(frame, std::move(nodes), std::move(pieces), tolerance);
}

std::shared_ptr<const kernels::SampledPressure> make_linear(const Triangulation& mesh, const std::vector<double>& p,
                                                            double tolerance) {
  require_mesh(mesh);
  require_pressures(p, mesh.points.size(), "points");
  return make(mesh, loaded_triangles(mesh, [&](std::size_t, std::size_t corner) { return p[corner]; }), tolerance);
}

std::shared_ptr<const kernels::SampledPressure> make_constant(const Triangulation& mesh, const std::vector<double>& p,
                                                              double tolerance) {
  require_mesh(mesh);
  require_pressures(p, mesh.triangles.size(), "triangles");
  return make(mesh, loaded_triangles(mesh, [&](std::size_t triangle, std::size_t) { return p[triangle]; }), tolerance);
}

double require_tolerance(double tolerance) { return contact::require_in("tolerance", tolerance, 1e-14, 1e-3); }

}  // namespace

PressureMesh PressureMesh::linear(const Triangulation& mesh, const std::vector<double>& nodal_pressures) {
  return PressureMesh(make_linear(mesh, nodal_pressures, 0));
}

PressureMesh PressureMesh::constant(const Triangulation& mesh, const std::vector<double>& pressures) {
  return PressureMesh(make_constant(mesh, pressures, 0));
}

PressureMesh PressureMesh::linear_within(double tolerance, const Triangulation& mesh,
                                         const std::vector<double>& nodal_pressures) {
  return PressureMesh(make_linear(mesh, nodal_pressures, require_tolerance(tolerance)));
}

PressureMesh PressureMesh::constant_within(double tolerance, const Triangulation& mesh,
                                           const std::vector<double>& pressures) {
  return PressureMesh(make_constant(mesh, pressures, require_tolerance(tolerance)));
}

}  // namespace patchgrip::friction
