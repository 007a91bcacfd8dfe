#include <patchgrip/friction/local_stribeck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/special_functions/beta.hpp>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/kernels/edge_sum.h>
#include <patchgrip/friction/kernels/stribeck_wave.h>
#include <patchgrip/friction/kernels/vector_quadrature.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/seed_hertz_disc.h>
#include <patchgrip/friction/uniform_disc.h>

namespace patchgrip::friction {
namespace {

using kernels::BoundedIntegrals;
using kernels::integrate;
using std::numbers::pi;

constexpr double unit = 0x1p-53;

BoundedWrench of_translation(const Twist& u, double centroid_x, double centroid_y) noexcept {
  const double speed = std::hypot(u.vx, u.vy);
  if (speed == 0) return {};
  const double size = std::exp(-speed * speed);
  if (size == 0) return {};
  const double fx = size * u.vx / speed, fy = size * u.vy / speed;
  const double error = unit * size * (4 + 4 * speed * speed);
  return {{fx, fy, centroid_x * fy - centroid_y * fx}, error, error * (std::fabs(centroid_x) + std::fabs(centroid_y))};
}

// q(s) from 1 - s^2.
class Projection {
 public:
  explicit Projection(double n) : n_(n), scale_(1 / boost::math::beta(0.5, n + 1)) {}

  double operator()(double x) const noexcept {
    if (n_ == 0) return scale_;
    if (n_ == 1) return scale_ * x;
    if (n_ == 0.5) return scale_ * std::sqrt(x);
    if (n_ == -0.5) return scale_ / std::sqrt(x);
    return scale_ * std::pow(x, n_);
  }

 private:
  double n_, scale_;
};

// int q g ds and int q s g ds of the wave g(c + k s) over [-1, 1]; c, k >= 0. The wave is folded at s = 0, and jumps
// where it changes sign, at s = c / k. The third number is int q |g| ds: rounding of g leaves 4 units of it.
BoundedIntegrals<3> across(const Projection& q, double c, double k) noexcept {
  const auto& g = kernels::StribeckWave::shared();
  const auto folded = [&](double s, double one_minus_s, double argument) -> std::array<double, 3> {
    const double forth = g(c + k * s), back = g(argument), pressure = q(one_minus_s * (1 + s));
    return {pressure * (forth - back), pressure * s * (forth + back), pressure * (std::fabs(forth) + std::fabs(back))};
  };
  const double jump = c / k;
  if (!(jump < 1)) {
    return integrate<3>([&](double s, double to_hi) { return folded(s, to_hi, k * s - c); }, 0, 1);
  }
  BoundedIntegrals<3> sum =
      integrate<3>([&](double s, double to_jump) { return folded(s, (1 - jump) + to_jump, -k * to_jump); }, 0, jump);
  const BoundedIntegrals<3> beyond = integrate<3>(
      [&](double from_jump, double to_hi) { return folded(jump + from_jump, to_hi, k * from_jump); }, jump, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    sum.value[i] += beyond.value[i];
    sum.error[i] += beyond.error[i];
  }
  return sum;
}

// Force, moment per length, and the errors that their integrands come with.
using Parts = std::array<double, 5>;

BoundedWrench collected(const BoundedIntegrals<5>& sum, double scale, double length) noexcept {
  const auto& [value, error] = sum;
  return {{scale * value[0], scale * value[1], scale * length * value[2]},
          scale * (error[0] + error[1] + value[3]),
          scale * length * (error[2] + value[4])};
}

void add(BoundedIntegrals<5>& sum, const BoundedIntegrals<5>& part) noexcept {
  for (std::size_t i = 0; i < 5; ++i) {
    sum.value[i] += part.value[i];
    sum.error[i] += part.error[i];
  }
}

}  // namespace

PowerEllipse PowerEllipse::of_semi_axes(double a, double b, double n) {
  contact::require_positive("a", a);
  contact::require_positive("b", b);
  contact::require_in("n", n, -0.5, 20);
  return {a, b, n};
}

BoundedWrench stribeck_excess(const PowerEllipse& zone, const Twist& u) noexcept {
  const double a = zone.a(), b = zone.b();
  if (u.w == 0) return of_translation(u, 0, 0);
  const Projection q(zone.n());
  const double w = std::fabs(u.w), length = std::max(a, b);
  const double speed = std::hypot(u.vx, u.vy), ex = speed > 0 ? u.vx / speed : 1, ey = speed > 0 ? u.vy / speed : 0;
  // n at the angle phi from u.
  const auto at = [&](double phi) -> Parts {
    const double c = std::max(std::cos(phi), 0.0), s = std::sin(phi);
    const double nx = c * ex - s * ey, ny = c * ey + s * ex, W = std::hypot(b * nx, a * ny);
    const auto wave = across(q, speed * c, w * W);
    const double rounding = 4 * unit * wave.value[2];
    return {nx * wave.value[0], ny * wave.value[0], W / length * wave.value[1], wave.error[0] + rounding,
            W / length * (wave.error[1] + rounding)};
  };
  // Cuts where the wave's jump leaves the zone (nowhere if the pole is inside), between them, where it comes nearest to
  // the rim, and across a long axis, where W turns.
  std::array<double, 6> cuts{-pi / 2, pi / 2, pi / 2, pi / 2, pi / 2, pi / 2};
  std::size_t count = 1;
  const auto angle = [&](double x, double y) { return std::atan2(ex * y - ey * x, ex * x + ey * y); };
  const double level = std::hypot(u.vx / b, u.vy / a), theta_0 = std::atan2(ey / a, ex / b);
  const double leaves = level > w ? std::atan2(std::sqrt((level - w) * (level + w)), w) : 0;
  const bool round = a == b;
  for (const double theta : {-leaves, 0.0, leaves}) {
    cuts[count++] = round ? theta : angle(std::cos(theta_0 + theta) / b, std::sin(theta_0 + theta) / a);
  }
  if (!round) {
    const double turn = a > b ? angle(1, 0) : angle(0, 1);
    cuts[count++] = turn > pi / 2 ? turn - pi : turn < -pi / 2 ? turn + pi : turn;
  }
  std::sort(cuts.begin(), cuts.begin() + count);
  BoundedIntegrals<5> sum;
  for (std::size_t i = 0; i < count; ++i) {
    if (round && cuts[i + 1] <= 0) continue;  // the same as beyond 0
    add(sum,
        integrate<5>([&, lo = cuts[i]](double from_lo, double) { return at(lo + from_lo); }, cuts[i], cuts[i + 1]));
  }
  BoundedWrench g = collected(sum, (round ? 2 : 1) / pi, length);
  if (round) {
    const double along = g.value.fx * ex + g.value.fy * ey;
    g.value.fx = along * ex;
    g.value.fy = along * ey;
  }
  g.value.m *= std::copysign(1.0, u.w);
  // u . n is rounded against |u|, the jump's place s against W: the integral of that over the directions.
  // Where q is infinite at the rim it counts half as much again.
  const double rounding = (zone.n() < 0 ? 24 : 16) * unit * (1 + std::fabs(std::log(a / b)));
  g.force_error += rounding;
  g.moment_error += rounding * length;
  return g;
}

BoundedWrench stribeck_excess(const FlatPunchDisc& disc, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(disc.radius(), disc.radius(), 0), u);
}

BoundedWrench stribeck_excess(const HertzDisc& disc, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(disc.radius(), disc.radius(), 1), u);
}

BoundedWrench stribeck_excess(const HertzEllipse& ellipse, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(ellipse.a(), ellipse.b(), 1), u);
}

BoundedWrench stribeck_excess(const PowerDisc& disc, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(disc.radius(), disc.radius(), disc.exponent()), u);
}

BoundedWrench stribeck_excess(const Ring& ring, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(ring.radius(), ring.radius(), -0.5), u);
}

BoundedWrench stribeck_excess(const SeedHertzDisc& disc, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(disc.radius(), disc.radius(), 1), u);
}

BoundedWrench stribeck_excess(const UniformDisc& disc, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(disc.radius(), disc.radius(), 0.5), u);
}

BoundedWrench stribeck_excess(const PointLoad&, const Twist& u) noexcept { return of_translation(u, 0, 0); }

namespace {

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
    const auto at = [&](double t) -> Parts {
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
    const auto ray = [&](double from_p, double to_q) -> Parts {
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
  if (u.w == 0) return of_translation(u, s.x, s.y);
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

BoundedWrench with_stribeck_excess(const BoundedWrench& kinetic, double excess_force, const BoundedWrench& excess,
                                   double lever) noexcept {
  const auto& [E, force_error, moment_error] = excess;
  BoundedWrench t = kinetic;
  t.value.fx -= excess_force * E.fx;
  t.value.fy -= excess_force * E.fy;
  t.value.m -= excess_force * E.m;
  const double size = std::fabs(excess_force);
  t.force_error += size * (force_error + 16 * unit) + unit * std::hypot(t.value.fx, t.value.fy);
  t.moment_error += size * (moment_error + 16 * unit * lever) + unit * std::fabs(t.value.m);
  return t;
}

}  // namespace patchgrip::friction
