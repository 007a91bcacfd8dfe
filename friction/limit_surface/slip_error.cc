#include <patchgrip/friction/limit_surface/slip_error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <patchgrip/friction/limit_surface/point_slip.h>
#include <patchgrip/friction/limit_surface/scaled_load.h>

namespace patchgrip::friction {
namespace {

constexpr double unit = 0x1p-53;
constexpr double infinity = std::numeric_limits<double>::infinity();

Vector times(const Hessian& h, const Vector& u) noexcept {
  return {h.xx * u[0] + h.xy * u[1] + h.xw * u[2], h.xy * u[0] + h.yy * u[1] + h.yw * u[2],
          h.xw * u[0] + h.yw * u[1] + h.ww * u[2]};
}

// Two unit vectors across `t` and each other.
std::array<Vector, 2> plane_across(const Vector& t) noexcept {
  const Vector n = scaled(t, 1 / std::sqrt(dot(t, t)));
  Vector axis{};
  const auto least = std::ranges::min_element(n, {}, [](double a) { return std::fabs(a); });
  axis[static_cast<std::size_t>(least - n.begin())] = 1;
  Vector first = cross(n, axis);
  first = scaled(first, 1 / std::sqrt(dot(first, first)));
  return {first, cross(n, first)};
}

// Length of the Newton step for the residual, twice, and of that for an error `noise` of it; in the plane t . u = 1.
// `rounding` is that of the stiffness: where it is all there is, nothing is known, and above that it softens the least.
double distance_to_maximiser(const Hessian& h, double rounding, const Vector& t, const Vector& residual,
                             double noise) noexcept {
  const auto [a, b] = plane_across(t);
  const Vector ha = times(h, a), hb = times(h, b);
  const double aa = dot(a, ha), ab = dot(a, hb), bb = dot(b, hb);
  const double ra = dot(a, residual), rb = dot(b, residual);
  const double mean = 0.5 * (aa + bb);
  const double apart = std::hypot(0.5 * (aa - bb), ab);
  const double determinant = aa * bb - ab * ab;
  const double least = determinant > 0 ? determinant / (mean + apart) : mean - apart;
  if (!(least > rounding)) return infinity;
  const double step = std::hypot(bb * ra - ab * rb, aa * rb - ab * ra) / determinant;
  return (2 * step * least + noise) / (least - rounding);
}

// Velocity and spin about the centroid that the slip is off by, the spin made a speed by the radius of gyration.
double smooth_error(const Gauge& gauge, const Wrench& load, const PatchView& patch, const PressureFrame& frame,
                    double shape_error) noexcept {
  Hessian h;
  if (!patch.hessian(patch.patch, gauge.twist, h)) return infinity;
  h = frame.about_centroid(h);
  const BoundedWrench g = patch.gradient(patch.patch, gauge.twist);
  const Vector t = scaled(frame.about_centroid(load), 1 / gauge.value);
  const Vector residual = moved(t, -1, frame.about_centroid(g.value));
  // Taken to the centroid: forces times the arm, and of the moments three roundings each.
  const double arm = std::hypot(frame.x, frame.y);
  const auto moved_by = [&](const Wrench& q) { return std::fabs(q.m) + arm * std::hypot(q.fx, q.fy); };
  const double moment_error =
      g.moment_error + arm * g.force_error + 3 * unit * (moved_by(load) / gauge.value + moved_by(g.value));
  // A shape that is wider by delta bears a moment that is greater by delta, and takes its pole along.
  const double shape = 2 * shape_error * std::fabs(t[2]);
  const double far = 1 + arm / frame.length;
  const double rounding = 8 * unit * far * far * 0.5 * (h.xx + h.yy + h.ww);
  return distance_to_maximiser(h, rounding, t, residual, g.force_error + moment_error / frame.length + shape);
}

// Velocity of the point, at unit spin, that it is off by. 0: the pole is the point.
double error_at(const Kink& kink, const Gauge& gauge, const Wrench& load, const PatchView& patch,
                const PressureFrame& frame, double shape_error) noexcept {
  const Twist& v = gauge.twist;
  const double sense = v.w < 0 ? -1 : 1;
  const Wrench t{sense * load.fx, sense * load.fy, sense * load.m};
  const NearKink near = gauge.status == GaugeStatus::facet ? kink.at_rest : kink.at(patch, {v.vx / v.w, v.vy / v.w, 1});
  const Planar a = point_force(kink, near, t).asked;
  const double w = kink.point.share;
  const double asked = length_of(a), speed = length_of(near.z);
  const double force = std::hypot(load.fx, load.fy) / gauge.value;
  const double noise = near.rest.force_error + 4 * unit * (force + w) +
                       force * (gauge.upper - gauge.lower) / gauge.value +
                       shape_error * std::fabs(kink.moment(t)) / (gauge.value * frame.length);
  if (speed == 0 && asked + noise < w) return 0;
  const double along = stiffness_along(kink.stiffness, a);
  if (!(along > 0)) return infinity;
  const double turned = asked > 0 ? std::hypot(speed * a.x / asked - near.z.x, speed * a.y / asked - near.z.y) : 0;
  const double stiffness = kink.stiffness.xx + kink.stiffness.yy;
  return turned + 2 * (std::fabs(asked - w) + noise + stiffness * turned) / along;
}

// Load and gauge near 1; a gauge that is subnormal is rounded to the last bit that it has.
Gauge scaled_with(const ScaledLoad& scaled, Gauge g) noexcept {
  constexpr double last = std::numeric_limits<double>::denorm_min();
  g.value = std::scalbn(g.value, -scaled.exponent);
  g.lower = std::scalbn(g.lower - last, -scaled.exponent);
  g.upper = std::scalbn(g.upper + last, -scaled.exponent);
  return g;
}

}  // namespace

SlipError slip_error(const Gauge& gauge, const Wrench& load, const PatchView& patch, const PressureFrame& frame,
                     double shape_error) noexcept {
  const Pole pole{-gauge.twist.vy / gauge.twist.w, gauge.twist.vx / gauge.twist.w};
  const bool known = gauge.status == GaugeStatus::converged || gauge.status == GaugeStatus::facet;
  if (!known || !(gauge.value > 0) || std::isinf(gauge.value)) return {infinity, infinity, pole, infinity};
  const double arm = std::hypot(frame.x, frame.y);
  const ScaledLoad scaled(load, arm + frame.length);
  const Gauge g = scaled_with(scaled, gauge);
  const Twist& v = gauge.twist;
  const Vector u = frame.about_centroid(v);
  const double speed = std::hypot(u[0], u[1]);  // of the centroid
  const double spin = std::fabs(v.w);
  // D(v) is rounded as the terms of grad D . v are, about the origin.
  const double D_rounding = 8 * unit * (1 + std::hypot(v.vx, v.vy) + (arm + frame.length) * spin);
  const double pole_rounding = 2 * unit * (std::fabs(pole.x) + std::fabs(pole.y));

  double moved = infinity;
  if (gauge.status != GaugeStatus::facet) {
    moved = D_rounding * (speed + frame.length * spin) + shape_error * speed +
            smooth_error(g, scaled.load, patch, frame, shape_error);
  }
  const Kink* kink = nearest_kink(frame, v);
  if (kink && spin > 0 && !(4 * moved < length_of(kink->velocity(v)))) {
    const double z = error_at(*kink, g, scaled.load, patch, frame, shape_error);
    // D = 1, and D changes by no more than |z| spin.
    const double scale = D_rounding + (g.upper - g.lower) / g.value + spin * z + shape_error;
    const double speed_error = spin * z + scale * std::hypot(v.vx, v.vy);
    if (gauge.status == GaugeStatus::facet && z == 0) {
      return {speed_error, spin * scale, {kink->point.x, kink->point.y}, 0};
    }
    return {speed_error, spin * scale, pole, z + pole_rounding};
  }
  const double spin_error = moved / frame.length;
  // dM = (e_z x dv + (c - M) dw) / w about the centroid c, |c - M| = speed / |w|.
  const double pole_error =
      spin > spin_error ? (moved + speed / spin * spin_error) / (spin - spin_error) + pole_rounding : infinity;
  return {moved + arm * spin_error, spin_error, pole, pole_error};
}

}  // namespace patchgrip::friction
