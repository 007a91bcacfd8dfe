#include <patchgrip/friction/local_stribeck.h>

#include <cmath>

#include <patchgrip/friction/point_load.h>

namespace patchgrip::friction {
namespace {

constexpr double unit = 0x1p-53;

}  // namespace

BoundedWrench with_change(BoundedWrench E, const PressureMoments& s, double force, double moment) noexcept {
  const double r = std::sqrt(s.polar);
  if (!(force < 1)) force = 1;
  if (!(moment < r)) moment = r;
  E.force_error += 2 * force;
  E.moment_error += 2 * (std::hypot(s.x, s.y) * force + moment);
  return E;
}

BoundedWrench stribeck_excess(const PointLoad&, const Twist& u) noexcept {
  const double speed = std::hypot(u.vx, u.vy);
  if (speed == 0) return {};
  const double size = std::exp(-speed * speed);
  if (size == 0) return {};
  const double error = unit * size * (4 + 4 * speed * speed);
  return {{size * u.vx / speed, size * u.vy / speed, 0}, error, 0};
}

BoundedWrench with_stribeck_excess(const BoundedWrench& kinetic, double excess_force,
                                   const BoundedWrench& excess) noexcept {
  const auto& [E, force_error, moment_error] = excess;
  BoundedWrench t = kinetic;
  t.value.fx -= excess_force * E.fx;
  t.value.fy -= excess_force * E.fy;
  t.value.m -= excess_force * E.m;
  const double size = std::fabs(excess_force);
  t.force_error += size * (force_error + 3 * unit * std::hypot(E.fx, E.fy)) + unit * std::hypot(t.value.fx, t.value.fy);
  t.moment_error += size * (moment_error + 3 * unit * std::fabs(E.m)) + unit * std::fabs(t.value.m);
  return t;
}

}  // namespace patchgrip::friction
