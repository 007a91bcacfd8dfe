// Stamp given by points (r_k, f_k), linear in between: a measured profile.
//
// A kink of the slope by m at radius b is a cone of slope m with a flat end of radius b (flat_end_cone.h), a first
// segment that rises is a cone (cone.h). At equal contact radius approach, force, pressure and displacement are the
// sums over the kinks inside:
//
//     g(x) = x sum_k m_k arccos(r_k / x),   F/E* = sum_k m_k (a^2 arccos(r_k / a) + r_k sqrt(a^2 - r_k^2))
//
// Domain   r_0 = 0 < r_1 < ... < r_n, f_0 = 0, slopes >= 0 and nowhere falling (at a concave kink contact is lost, and
//          the zone is no circle); a <= r_n.
// Units    [m].
// Error    units of 2^-53, relative: n more than flat_end_cone.h states; tests/contact/point_profile_test.cc. That is
//          the error for the polygon; the polygon itself misses the force of a smooth shape at equal radius by the
//          power 3/2 of the spacing.
// Fails    p has a logarithmic peak at every kink, +infinity on it: a smooth profile given as points should be asked
//          for p between nodes. Beyond r_n height() follows the last segment.
// Throws   std::invalid_argument outside the domain; std::runtime_error where the radius is not found.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include <patchgrip/contact/cone.h>
#include <patchgrip/contact/flat_end_cone.h>

namespace patchgrip::contact {

struct ProfilePoint {
  double radius;  // r_k [m]
  double height;  // f_k [m]
};

class PointProfile {
 public:
  static PointProfile through(std::span<const ProfilePoint> points);

  template <class Real>
  Real height(const Real& r) const {
    Real sum = tip_slope_ * r;
    for (const FlatEndCone& kink : kinks_) sum += kink.height(r);
    return sum;
  }

  template <class Real>
  Real approach(const Real& a) const {
    return sum<Real>(a, [&](const auto& part) -> Real { return part.approach(a); });
  }

  template <class Real>
  Real approach_slope(const Real& a) const {
    return sum<Real>(a, [&](const auto& part) -> Real { return part.approach_slope(a); });
  }

  template <class Real>
  Real force(const Real& a) const {
    return sum<Real>(a, [&](const auto& part) -> Real { return part.force(a); });
  }

  template <class Real>
  Real pressure(const Real& r, const Real& a) const {
    return sum<Real>(a, [&](const auto& part) -> Real { return part.pressure(r, a); });
  }

  template <class Real>
  Real displacement(const Real& r, const Real& a) const {
    if (r <= a) return approach(a) - height(r);
    return sum<Real>(a, [&](const auto& part) -> Real { return part.displacement(r, a); });
  }

  double radius_of_approach(double approach) const;
  double radius_of_force(double force) const;

  double max_radius() const noexcept { return nodes_.back(); }

  ProfileErrors errors() const noexcept {
    const double n = static_cast<double>(nodes_.size());
    return {6 + n, 8 + n, 32 + n, 96 + n, 12 + n};
  }

 private:
  PointProfile() = default;

  // A kink counts from the radius where it touches.
  template <class Real, class Part>
  Real sum(const Real& a, const Part& part) const {
    Real total = 0;
    if (tip_slope_ > 0) total += part(Cone::of_slope(tip_slope_));
    for (const FlatEndCone& kink : kinks_) {
      if (!(kink.end_radius() <= a)) break;
      total += part(kink);
    }
    return total;
  }

  double tip_slope_ = 0;
  std::vector<FlatEndCone> kinks_;  // by rising end radius
  std::vector<double> nodes_;       // r_1, ..., r_n
};

}  // namespace patchgrip::contact
