#include <patchgrip/friction/limit_surface/kink.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::friction {

namespace {

constexpr double unit = 0x1p-53;

}  // namespace

NearKink Kink::at(const PatchView& patch, const Twist& v) const noexcept {
  NearKink n{v, velocity(v), patch.gradient(patch.patch, v), {}};
  n.rest = n.whole;
  const double speed = length_of(n.z);
  if (speed == 0) return n;
  const Wrench own = through_point({point.share * n.z.x / speed, point.share * n.z.y / speed});
  n.rest.value = {n.whole.value.fx - own.fx, n.whole.value.fy - own.fy, n.whole.value.m - own.m};
  // Rounded: direction and share of the force, sums; their products with the arm.
  const double arm = std::fabs(point.x) + std::fabs(point.y);
  const double error = 8 * unit * point.share + unit * std::hypot(n.whole.value.fx, n.whole.value.fy);
  n.rest.force_error += error;
  n.rest.moment_error += arm * error + 2 * unit * (std::fabs(own.m) + std::fabs(n.whole.value.m));
  return n;
}

Stiffness Kink::stiffness_at(const PatchView& patch, const Twist& v) const noexcept {
  const Planar z = velocity(v);
  const double speed = length_of(z);
  Hessian h;
  if (!(speed > 0) || !patch.hessian(patch.patch, v, h)) return {};
  const double own = point.share / speed;
  const double ex = z.x / speed, ey = z.y / speed;
  return {h.xx - own * ey * ey, h.xy + own * ex * ey, h.yy - own * ex * ex, 8 * unit * own};
}

std::vector<Kink> kinks_of(const PatchView& patch, std::vector<PointShare> shares, double length) {
  std::ranges::sort(shares, {}, [](const PointShare& p) { return std::pair(p.x, p.y); });
  std::vector<Kink> kinks;
  for (const PointShare& p : shares) {
    if (!kinks.empty() && kinks.back().point.x == p.x && kinks.back().point.y == p.y) {
      kinks.back().point.share += p.share;
    } else {
      kinks.push_back({p, {}, {}});
    }
  }
  for (Kink& kink : kinks) {
    kink.at_rest = kink.near(patch, {});
    // Next to the point, as at it the Hessian of D is infinite.
    kink.stiffness = kink.stiffness_at(patch, kink.twist({0.8 * beside * length, 0.6 * beside * length}));
  }
  return kinks;
}

}  // namespace patchgrip::friction
