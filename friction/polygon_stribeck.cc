// Stribeck's excess of polygons: triangles between the pole, or the centroid, and the edges (local_stribeck.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <boost/multiprecision/cpp_bin_float.hpp>

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

// A needle's long edges are nearly in line with any pole or centre on it: what crosses them is taken in 113 bits.
using Wide = boost::multiprecision::cpp_bin_float_quad;

// int_0^1 exp(-y l^2) l dl and int_0^1 exp(-y l^2) l^2 dl, to 3 and 15 units.
double radial_force(double y) noexcept { return y > 0 ? -std::expm1(-y) / (2 * y) : 0.5; }

double radial_moment(double y) noexcept {
  if (y > 1) return (std::sqrt(pi / y) / 2 * std::erf(std::sqrt(y)) - std::exp(-y)) / (2 * y);
  long double sum = 0, term = 1;
  for (int k = 0; k < 20; ++k) {
    sum += term / (2 * k + 3);
    term *= -y / static_cast<long double>(k + 1);
  }
  return static_cast<double>(sum);
}

struct Triangles {
  BoundedIntegrals<5> sum;
  Wide twice_area{0};
};

// One of the triangles between (X, Y) and the edges: the start of its edge seen from there, and the edge.
struct Triangle {
  Wide px, py, ex, ey;
  Wide twice_area;  // signed
};

// `add_to(sum, triangle)` for all that have an area.
template <class F>
Triangles over_triangles(const kernels::Boundary<double>& boundary, const Wide& X, const Wide& Y, F&& add_to) {
  Triangles triangles;
  std::size_t first = 0;
  for (const std::size_t end : boundary.ring_ends) {
    for (std::size_t i = first; i < end; ++i) {
      const auto& p = boundary.vertices[i];
      const auto& q = boundary.vertices[i + 1 < end ? i + 1 : first];
      Triangle t{p.x - X, p.y - Y, Wide(q.x) - p.x, Wide(q.y) - p.y, 0};
      t.twice_area = t.px * t.ey - t.py * t.ex;
      triangles.twice_area += t.twice_area;
      if (t.twice_area != 0) add_to(triangles.sum, t);
    }
    first = end;
  }
  return triangles;
}

// Triangles between the pole and the edges, along the rays in closed form; the moment is about the pole. With the foot
// of the pole, its distance and n to 64 bits, rounded are y 1, the radial functions as above, the product 1 and the
// length of the piece 1; y moves the functions by 1 and 3/2 of itself at most.
Triangles about_pole(const kernels::Boundary<double>& boundary, const Wide& X, const Wide& Y, double w,
                     double length) noexcept {
  constexpr double of_force = 6, of_moment = 19;  // units
  return over_triangles(boundary, X, Y, [&](BoundedIntegrals<5>& sum, const Triangle& triangle) {
    const auto& [px, py, ex, ey, twice_triangle] = triangle;
    const Wide side = sqrt(ex * ex + ey * ey), start = (px * ex + py * ey) / side, stop = start + side;
    const auto h = static_cast<long double>(twice_triangle / side);
    const auto tx = static_cast<long double>(ex / side), ty = static_cast<long double>(ey / side);
    // The rays turn fastest at the foot of the pole.
    const Wide foot = start > 0 ? start : stop < 0 ? stop : Wide(0);
    const auto t_foot = static_cast<long double>(foot);
    const auto at = [&](long double t) -> ExcessParts {
      const long double R2 = t * t + h * h, R = std::sqrt(R2);
      const auto y = static_cast<double>(w * R * w * R);
      const long double dx = ty * h + tx * t, dy = ty * t - tx * h;
      const long double k = h * radial_force(y), m = h * R / length * radial_moment(y);
      return {static_cast<double>(-k * dy / R), static_cast<double>(k * dx / R), static_cast<double>(m),
              of_force * unit * static_cast<double>(std::fabs(k)),
              of_moment * unit * static_cast<double>(std::fabs(m))};
    };
    add(sum, integrate<5>([&](double, double to_foot) { return at(t_foot - to_foot); }, 0,
                          static_cast<double>(foot - start)));
    add(sum, integrate<5>([&](double from_foot, double) { return at(t_foot + from_foot); }, 0,
                          static_cast<double>(stop - foot)));
  });
}

// Triangles between a centre and the edges, point by point; the moment is about the centre, u the twist there. The pole
// is two radii away: V <= 2 |u_P|, and W = |w| radius <= V / 2. Rounded are places 6 of the radius, w y 1, the sums 1,
// and u at the centre 1: velocities 6 V, hence 12 of the force of a point; all else of it 10 more, of its moment 20.
Triangles about_centre(const kernels::Boundary<double>& boundary, double X, double Y, const Twist& u,
                       double length) noexcept {
  constexpr double of_force = 22, of_moment = 32;  // units
  return over_triangles(boundary, X, Y, [&](BoundedIntegrals<5>& sum, const Triangle& triangle) {
    const auto px = static_cast<double>(triangle.px), py = static_cast<double>(triangle.py);
    const auto qx = static_cast<double>(triangle.px + triangle.ex), qy = static_cast<double>(triangle.py + triangle.ey);
    const auto twice_triangle = static_cast<double>(triangle.twice_area);
    const double force_rounding = of_force / 2 * unit * std::fabs(twice_triangle);    // int l dl
    const double moment_rounding = of_moment / 3 * unit * std::fabs(twice_triangle);  // int l^2 dl
    const auto ray = [&](double from_p, double to_q) -> ExcessParts {
      const double ex = px * to_q + qx * from_p, ey = py * to_q + qy * from_p;
      const auto point = [&](double l, double) -> std::array<double, 3> {
        const double x = l * ex, y = l * ey, ux = u.vx - u.w * y, uy = u.vy + u.w * x;
        const double speed2 = ux * ux + uy * uy;
        const double k = twice_triangle * l * std::exp(-speed2) / std::sqrt(speed2);
        return {k * ux, k * uy, k * (x * uy - y * ux) / length};
      };
      const auto [value, error] = integrate<3>(point, 0, 1);
      return {value[0], value[1], value[2], error[0] + error[1] + force_rounding, error[2] + moment_rounding};
    };
    add(sum, integrate<5>(ray, 0, 1));
  });
}

}  // namespace

BoundedWrench stribeck_excess(const Polygon& polygon, const Twist& u) noexcept {
  const PressureMoments s = polygon.moments();
  const auto force_of = [](const BoundedWrench& g) { return std::hypot(g.value.fx, g.value.fy); };
  if (u.w == 0) {
    BoundedWrench g = stribeck_excess(PointLoad{}, u);
    g.value.m = s.x * g.value.fy - s.y * g.value.fx;
    g.moment_error = (std::fabs(s.x) + std::fabs(s.y)) * (g.force_error + 3 * unit * force_of(g));
    return g;
  }
  const kernels::Boundary<double>& boundary = polygon.boundary();
  const Twist c{std::fma(-u.w, s.y, u.vx), std::fma(u.w, s.x, u.vy), u.w};
  double radius = 0;
  for (const auto& p : boundary.vertices) radius = std::max(radius, std::hypot(p.x - s.x, p.y - s.y));
  const bool near = std::hypot(c.vx, c.vy) < 2 * radius * std::fabs(u.w);
  double x = s.x, y = s.y;
  Triangles triangles;
  if (near) {
    const Wide X = -Wide(u.vy) / u.w, Y = Wide(u.vx) / u.w;
    x = static_cast<double>(X);
    y = static_cast<double>(Y);
    triangles = about_pole(boundary, X, Y, u.w, radius);
  } else {
    triangles = about_centre(boundary, x, y, c, radius);
  }
  BoundedWrench g = collected(triangles.sum, static_cast<double>(2 / triangles.twice_area), radius);
  if (near) {
    const double sign = std::copysign(1.0, u.w);
    g.value = {sign * g.value.fx, sign * g.value.fy, sign * g.value.m};
  }
  // Area and radius; then the moment about the origin.
  g.force_error += 2 * unit * force_of(g);
  g.moment_error += 4 * unit * std::fabs(g.value.m);
  g.value.m += x * g.value.fy - y * g.value.fx;
  g.moment_error +=
      (std::fabs(x) + std::fabs(y)) * (g.force_error + 3 * unit * force_of(g)) + unit * std::fabs(g.value.m);
  return g;
}

}  // namespace patchgrip::friction
