#include <patchgrip/cli/input_error.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::cli {
namespace {

using friction::Law;
using friction::PressureMoments;
using friction::Twist;
using friction::Wrench;

// |d mu| for an error of v_m^2, by the mean value theorem.
double error_of_coefficient(const Law& law, double mean_square, double mean_square_error) noexcept {
  const double scale = 1 / (law.stribeck_velocity * law.stribeck_velocity);
  const double error = mean_square_error * scale;
  const double least = std::max(0.0, mean_square * scale - error);
  return std::fabs(law.mu_static - law.mu_kinetic) * std::exp(-least) * error;
}

}  // namespace

Twist moved_to(const friction::Pole& point, const Twist& v) noexcept {
  return {v.vx - v.w * point.y, v.vy + v.w * point.x, v.w};
}

WrenchError error_of_twist(const Law& law, double normal_force, const PressureMoments& moments, const Wrench& gradient,
                           const Twist& v) noexcept {
  const double dv = 0x1p-53 * std::hypot(v.vx, v.vy);
  const Twist at_centroid = moved_to({moments.x, moments.y}, v);
  const double speed = std::hypot(at_centroid.vx, at_centroid.vy);
  const double dmu = error_of_coefficient(law, friction::mean_square_speed(moments, v), (2 * speed + dv) * dv);
  const double viscous = law.mu_viscous * dv;
  return {normal_force * (dmu * std::hypot(gradient.fx, gradient.fy) + viscous),
          normal_force * (dmu * std::fabs(gradient.m) + viscous * std::hypot(moments.x, moments.y))};
}

WrenchError error_of_radius(const Law& law, double normal_force, const DiscMotion& disc, double delta) {
  const auto& [centre, v, moments, g, h] = disc;
  const double spin = std::fabs(v.w);
  const double mean_square_error = 2 * delta * v.w * v.w * moments.polar;
  const double mu = friction::coefficient(law, moments, v);
  const double dmu = error_of_coefficient(law, friction::mean_square_speed(moments, v), mean_square_error);
  const double force = normal_force * (mu * delta * spin * std::hypot(h.xw, h.yw) + dmu * std::hypot(g.fx, g.fy));
  const double moment = normal_force * (mu * delta * (std::fabs(g.m) + spin * std::fabs(h.ww)) + dmu * std::fabs(g.m) +
                                        2 * delta * law.mu_viscous * spin * moments.polar);
  return {force, moment + std::hypot(centre.x, centre.y) * force};
}

WrenchError error_of_shape(const Law& law, double normal_force, const ShapeMotion& motion, double delta) {
  const auto& [centre, extent, v, moments, g, stiffness] = motion;
  const double spin = std::fabs(v.w);
  const Twist moved = moved_to(centre, v);
  const double speed = std::hypot(moved.vx, moved.vy);
  const double mu = friction::coefficient(law, moments, v);
  const double dmu =
      error_of_coefficient(law, friction::mean_square_speed(moments, v), 2 * delta * v.w * v.w * moments.polar);
  const double bent = spin * extent * stiffness;
  const double lever = 2 * extent * spin < speed ? 2 * extent * spin / speed : 1;
  const double force = normal_force * (mu * delta * bent + dmu * std::hypot(g.fx, g.fy));
  const double own_moment = g.m - (centre.x * g.fy - centre.y * g.fx);
  const double moment = normal_force * (mu * delta * extent * (lever + bent) + dmu * std::fabs(own_moment) +
                                        2 * delta * law.mu_viscous * spin * moments.polar);
  return {force, moment + std::hypot(centre.x, centre.y) * force};
}

WrenchError error_of_scatter(const Law& law, double normal_force, const RadiusScatter& scatter,
                             const friction::Pole& centre, const Twist& v) {
  const Twist moved = moved_to(centre, v);
  const PressureMoments moments = scatter.own.moments();
  const friction::BoundedWrench g = scatter.own.bounded_gradient(moved);
  const double mu = friction::coefficient(law, moments, moved);
  double most_mu = mu, dmu = 0, force = 0, moment = 0, viscous = 0;
  for (const friction::AnyPatch* end : {&scatter.narrow, &scatter.wide}) {
    const PressureMoments other = end->moments();
    const friction::BoundedWrench h = end->bounded_gradient(moved);
    const double end_mu = friction::coefficient(law, other, moved);
    most_mu = std::max(most_mu, end_mu);
    dmu = std::max(dmu, std::fabs(end_mu - mu));
    force = std::max(force, std::hypot(h.value.fx - g.value.fx, h.value.fy - g.value.fy) + h.force_error);
    moment = std::max(moment, std::fabs(h.value.m - g.value.m) + h.moment_error);
    viscous = std::max(viscous, std::fabs(other.polar - moments.polar));
  }
  const double df =
      normal_force * (most_mu * (force + g.force_error) + dmu * (std::hypot(g.value.fx, g.value.fy) + g.force_error));
  const double dm =
      normal_force * (most_mu * (moment + g.moment_error) + dmu * (std::fabs(g.value.m) + g.moment_error) +
                      law.mu_viscous * std::fabs(v.w) * viscous);
  return {df, dm + std::hypot(centre.x, centre.y) * df};
}

}  // namespace patchgrip::cli
