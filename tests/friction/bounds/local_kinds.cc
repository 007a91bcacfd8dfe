// Stribeck's law at each point (local_stribeck.h): its excess against other ways to the same number, in 64 bits.
#include <algorithm>
#include <cmath>

#include <patchgrip/friction/line_load.h>
#include <patchgrip/friction/local_stribeck.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/friction/bounds/kind.h>
#include <patchgrip/tests/friction/bounds/polygon_ring.h>
#include <patchgrip/tests/friction/local_motions.h>
#include <patchgrip/tests/friction/local_reference.h>

namespace patchgrip::friction::bounds {
namespace {

constexpr double reference_error = 1e-17;

Case local_case(const BoundedWrench& found, const LocalExcess& exact, const Twist& u, double length) {
  const bool far = std::hypot(u.vx, u.vy) > 2 * length * std::fabs(u.w);
  return judged(far, found, {exact.fx, exact.fy, exact.m}, reference_error, length);
}

Case ring(Draw& draw) {
  const double a = draw.log_uniform(1e-3, 10);
  const Twist u = random_twist(draw.engine(), a, a);
  return local_case(stribeck_excess(Ring::of_radius(a), u), ring_excess(a, u), u, a);
}

Case power_ellipse(Draw& draw, double n, double least_aspect, double largest_aspect) {
  const double a = draw.log_uniform(1e-3, 10), aspect = draw.log_uniform(least_aspect, largest_aspect);
  const double b = draw.coin() ? a * aspect : a / aspect;
  const Twist u = random_twist(draw.engine(), a, b);
  return local_case(stribeck_excess(PowerEllipse::of_semi_axes(a, b, n), u), power_ellipse_excess(a, b, n, u), u,
                    std::max(a, b));
}

// From `least` up, next to it, too, and those in closed form.
double draw_exponent(Draw& draw, double least) {
  const double closed[] = {least, 0, 0.5, 1};
  return draw.coin() ? closed[draw.index(4)] : draw.coin() ? least + draw.log_uniform(1e-6, 1) : draw.uniform(0.5, 20);
}

Case line(Draw& draw) {
  const double L = draw.log_uniform(1e-3, 10), width = draw.coin() ? L / 2 : L * draw.log_uniform(1e-16, 1);
  const Twist u = random_twist(draw.engine(), L / 2, width);
  return local_case(stribeck_excess(LineLoad::of_length(L), u), line_excess(L, u), u, L / 2);
}

// Turned, with poles along its axes; one of three lies away from the origin.
Case polygon(Draw& draw, double aspect) {
  const double size = draw.log_uniform(1e-3, 10), away = draw.integer(0, 2) == 0 ? 20 * size : 0;
  const double x = draw.uniform(-away, away), y = draw.uniform(-away, away), turn = draw.angle();
  const double c = std::cos(turn), s = std::sin(turn);
  const auto ring = draw_ring(draw, x, y, size, aspect, turn);
  const Polygon patch = Polygon::uniform(ring);
  const Twist own = random_twist(draw.engine(), size, aspect * size);
  const Twist u{c * own.vx - s * own.vy + own.w * y, s * own.vx + c * own.vy - own.w * x, own.w};
  const bool far = std::hypot(own.vx, own.vy) > 2 * size * std::fabs(u.w);
  const LocalExcess exact = polygon_excess({vertices(ring)}, patch.moments(), u);
  const double length = size + std::hypot(x, y);
  return judged(far, stribeck_excess(patch, u), {exact.fx, exact.fy, exact.m}, reference_error, length);
}

// That of a disc at (x, y) about the origin.
LocalExcess disc_excess(double a, const Quad& x, const Quad& y, const Twist& v, double v_S) {
  const Quad ux = (v.vx - v.w * y) / v_S, uy = (v.vy + v.w * x) / v_S;
  return about_origin(uniform_ellipse_excess(a, a, {Long(ux), Long(uy), Long(Quad(v.w) / v_S)}), Long(x), Long(y));
}

// A motion about (x, y) in units of v_S, as the origin sees it.
Twist moved_to_origin(const Twist& own, double x, double y, double v_S) {
  return {v_S * own.vx + v_S * own.w * y, v_S * own.vy - v_S * own.w * x, v_S * own.w};
}

// A disc down to a ten thousandth of its distance from the origin, turned or not, by the law.
Case placed(Draw& draw) {
  const double a = draw.log_uniform(1e-4, 1), v_S = draw.log_uniform(1e-2, 10), F_N = draw.log_uniform(1e-3, 1e3);
  const PlanarFrame frame = draw_frame(draw, 1);
  const Placed<UniformDisc> patch(UniformDisc::of_radius(a), frame);
  const Twist own = random_twist(draw.engine(), a, a), v = moved_to_origin(own, frame.x, frame.y, v_S);
  const LocalExcess exact = -F_N * disc_excess(a, frame.x, frame.y, v, v_S);
  const bool far = std::hypot(own.vx, own.vy) > 2 * a * std::fabs(own.w);
  const BoundedWrench found = local_friction_wrench(Law::stribeck(1, 0, v_S), F_N, patch, v);
  return judged(far, found, {exact.fx, exact.fy, exact.m}, F_N * reference_error, a + std::hypot(frame.x, frame.y));
}

// A disc and a light one far from it, which the motion is about, in a frame of their own.
Case light_part(Draw& draw) {
  const double a = 0.01, b = draw.log_uniform(1e-5, 0.1), share = draw.log_uniform(1e-4, 0.1);
  const double v_S = draw.log_uniform(1e-2, 10), x = draw.uniform(-1, 1), y = draw.uniform(-1, 1);
  const PlanarFrame frame = draw.coin() ? draw_frame(draw, 1) : PlanarFrame{};
  const Placed patch(
      Several::of_parts({{UniformDisc::of_radius(a), 1}, {Placed(UniformDisc::of_radius(b), x, y), share}}), frame);
  const Quad c = cos(Quad(frame.angle)), s = sin(Quad(frame.angle));
  const Quad X = frame.x + c * x - s * y, Y = frame.y + s * x + c * y;
  const Twist own = random_twist(draw.engine(), b, b);
  const Twist v = moved_to_origin(own, static_cast<double>(X), static_cast<double>(Y), v_S);
  const LocalExcess exact =
      -1 / (1 + Long(share)) * (disc_excess(a, frame.x, frame.y, v, v_S) + share * disc_excess(b, X, Y, v, v_S));
  const bool far = std::hypot(own.vx, own.vy) > 2 * b * std::fabs(own.w);
  const BoundedWrench found = local_friction_wrench(Law::stribeck(1, 0, v_S), 1, patch, v);
  return judged(far, found, {exact.fx, exact.fy, exact.m}, reference_error,
                std::hypot(x, y) + std::hypot(frame.x, frame.y));
}

}  // namespace

// Errors of the moment are judged against the size of the patch, however small it is far from the pole.
Kinds local_kinds() {
  Kinds kinds{{"local_ring", ring},
              {"local_line", line},
              {"local_placed", placed},
              {"local_light_part", light_part},
              {"local_polygon", [](Draw& draw) { return polygon(draw, draw.coin() ? 1 : draw.log_uniform(1e-2, 1)); }},
              {"local_needle_polygon", [](Draw& draw) { return polygon(draw, draw.log_uniform(1e-6, 1e-3)); }},
              {"local_power_disc", [](Draw& draw) { return power_ellipse(draw, draw_exponent(draw, -0.5), 1, 1); }},
              {"local_power_ellipse", [](Draw& draw) { return power_ellipse(draw, draw_exponent(draw, 0), 1, 10); }},
              {"local_needle", [](Draw& draw) { return power_ellipse(draw, draw_exponent(draw, 0), 1e3, 1e6); }}};
  for (Kind& kind : kinds) kind.tight = false;
  return kinds;
}

}  // namespace patchgrip::friction::bounds
