// Stribeck's excess of polygons: triangles between the pole, or the centroid, and the edges (local_stribeck.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <patchgrip/friction/kernels/edge_sum.h>
#include <patchgrip/friction/kernels/excess_parts.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/stribeck_excess.h>

namespace patchgrip::friction {
namespace {

using kernels::BoundedIntegrals;
using kernels::ExcessParts;
using kernels::integrate;
using std::numbers::pi;

constexpr double unit = 0x1p-53;

// int_0^1 exp(-y l^2) l dl and int_0^1 exp(-y l^2) l^2 dl
double radial_force(double y) noexcept { return y > 0 ? -std::expm1(-y) / (2 * y) : 0.5; }

double radial_moment(double y) noexcept {
  if (y > 1) return (std::sqrt(pi / y) / 2 * std::erf(std::sqrt(y)) - std::exp(-y)) / (2 * y);
  double sum = 0, term = 1;
  for (int k = 0; k < 20; ++k) {
    sum += term / (2 * k + 3);
    term *= -y / (k + 1);
  }
  return sum;
}

struct Edge {
  double px, py, qx, qy;  // its ends
  double nx, ny;          // outward
};

template <class F>
void for_each_edge(const kernels::Boundary<double>& boundary, F&& f) {
  std::size_t first = 0;
  for (const std::size_t end : boundary.ring_ends) {
    for (std::size_t i = first; i < end; ++i) {
      const auto& p = boundary.vertices[i];
      const auto& q = boundary.vertices[i + 1 < end ? i + 1 : first];
      f(Edge{p.x, p.y, q.x, q.y, boundary.nx[i], boundary.ny[i]});
    }
    first = end;
  }
}

// Triangles between the pole and the edges, along the rays in closed form; the moment is about the pole.
BoundedIntegrals<5> about_pole(const kernels::Boundary<double>& boundary, double X, double Y, double w,
                               double length) noexcept {
  BoundedIntegrals<5> sum;
  for_each_edge(boundary, [&](const Edge& e) {
    const double h = e.nx * (e.px - X) + e.ny * (e.py - Y);
    if (h == 0) return;
    const double tx = -e.ny, ty = e.nx;
    const double t0 = tx * (e.px - X) + ty * (e.py - Y), t1 = tx * (e.qx - X) + ty * (e.qy - Y);
    const auto at = [&](double t) -> ExcessParts {
      const double R2 = t * t + h * h, R = std::sqrt(R2), y = w * w * R2;
      const double dx = e.nx * h + tx * t, dy = e.ny * h + ty * t;
      const double k = h * radial_force(y) / R;
      return {-k * dy, k * dx, h * R / length * radial_moment(y), 0, 0};
    };
    // The rays turn fastest at the foot of the pole.
    const double foot = std::clamp(0.0, t0, t1);
    add(sum, integrate<5>([&](double, double to_foot) { return at(foot - to_foot); }, t0, foot));
    add(sum, integrate<5>([&](double from_foot, double) { return at(foot + from_foot); }, foot, t1));
  });
  return sum;
}

// Triangles between a centre and the edges, point by point; the moment is about the centre, u the twist there.
BoundedIntegrals<5> about_centre(const kernels::Boundary<double>& boundary, double X, double Y, const Twist& u,
                                 double length) noexcept {
  BoundedIntegrals<5> sum;
  for_each_edge(boundary, [&](const Edge& e) {
    const double px = e.px - X, py = e.py - Y, qx = e.qx - X, qy = e.qy - Y;
    const double twice_triangle = px * qy - py * qx;
    const auto ray = [&](double from_p, double to_q) -> ExcessParts {
      const double ex = px * to_q + qx * from_p, ey = py * to_q + qy * from_p;
      const auto point = [&](double l, double) -> std::array<double, 3> {
        const double x = l * ex, y = l * ey, ux = u.vx - u.w * y, uy = u.vy + u.w * x;
        const double speed2 = ux * ux + uy * uy;
        const double k = twice_triangle * l * std::exp(-speed2) / std::sqrt(speed2);
        return {k * ux, k * uy, k * (x * uy - y * ux) / length};
      };
      const auto [value, error] = integrate<3>(point, 0, 1);
      return {value[0], value[1], value[2], error[0] + error[1], error[2]};
    };
    add(sum, integrate<5>(ray, 0, 1));
  });
  return sum;
}

}  // namespace

BoundedWrench stribeck_excess(const Polygon& polygon, const Twist& u) noexcept {
  const PressureMoments s = polygon.moments();
  if (u.w == 0) {
    BoundedWrench g = stribeck_excess(PointLoad{}, u);
    g.value.m = s.x * g.value.fy - s.y * g.value.fx;
    g.moment_error = g.force_error * (std::fabs(s.x) + std::fabs(s.y));
    return g;
  }
  const double area = pi * polygon.area_radius() * polygon.area_radius();
  const kernels::Boundary<double>& boundary = polygon.boundary();
  const Twist c{std::fma(-u.w, s.y, u.vx), std::fma(u.w, s.x, u.vy), u.w};
  double radius = 0;
  for (const auto& p : boundary.vertices) radius = std::max(radius, std::hypot(p.x - s.x, p.y - s.y));
  const bool near = std::hypot(c.vx, c.vy) < 2 * radius * std::fabs(u.w);
  double x = s.x, y = s.y;
  BoundedWrench g;
  if (near) {
    x = -u.vy / u.w;
    y = u.vx / u.w;
    g = collected(about_pole(boundary, x, y, u.w, radius), 1 / area, radius);
    const double sign = std::copysign(1.0, u.w);
    g.value = {sign * g.value.fx, sign * g.value.fy, sign * g.value.m};
  } else {
    g = collected(about_centre(boundary, x, y, c, radius), 1 / area, radius);
  }
  // The moment about the origin, and some roundings of pole, area and arm.
  const double arm = std::fabs(x) + std::fabs(y);
  g.force_error += 16 * unit;
  g.moment_error += arm * (g.force_error + 2 * unit * std::hypot(g.value.fx, g.value.fy)) + 16 * unit * radius;
  g.value.m += x * g.value.fy - y * g.value.fx;
  return g;
}

}  // namespace patchgrip::friction
