// Stamp whose height is a sum of powers, f = sum_k h_k (r / l_k)^(m_k) with positive heights: at equal contact radius
// approach, force, pressure and displacement are the sums of those of the powers (power_profile.h), since seed 4.9 is
// linear.
//
// The truncated series of the sphere is one of them,
//
//     f = R sum_(k=1)^n c_k (r / R)^(2k),   c_k = |binomial(1/2, k)| = (2k-3)!! / (2k)!!      (seed 4.14, superposed)
//
// and needs n = 2 terms from a/R = 1/2 on to stay below 2 % of force, n = 10 at a/R = 0.9; sphere.h has the whole.
//
// Domain   at least one power, each within the domain of power_profile.h.
// Units    as in power_profile.h.
// Error    the largest of the errors of the powers; the radius is found by iteration (increasing_root.h) and is good to
//          errors().radius. tests/contact/power_sum_test.cc.
// Fails    p(0) is +infinity if any m_k <= 1.
// Throws   std::invalid_argument outside the domain; std::runtime_error where the radius is not found.
#pragma once

#include <limits>
#include <vector>

#include <patchgrip/contact/power_profile.h>

namespace patchgrip::contact {

class PowerSum {
 public:
  static PowerSum of(std::vector<PowerProfile> powers);

  // The first `terms` even powers of a sphere of radius R; 1 <= terms <= 500.
  static PowerSum sphere_series(double radius, int terms);

  template <class Real>
  Real height(const Real& r) const {
    return sum<Real>([&](const PowerProfile& power) { return power.height(r); });
  }

  template <class Real>
  Real approach(const Real& a) const {
    return sum<Real>([&](const PowerProfile& power) { return power.approach(a); });
  }

  template <class Real>
  Real approach_slope(const Real& a) const {
    return sum<Real>([&](const PowerProfile& power) { return power.approach_slope(a); });
  }

  template <class Real>
  Real force(const Real& a) const {
    return sum<Real>([&](const PowerProfile& power) { return power.force(a); });
  }

  template <class Real>
  Real pressure(const Real& r, const Real& a) const {
    return sum<Real>([&](const PowerProfile& power) { return power.pressure(r, a); });
  }

  template <class Real>
  Real displacement(const Real& r, const Real& a) const {
    if (r <= a) return approach(a) - height(r);
    return sum<Real>([&](const PowerProfile& power) { return power.displacement(r, a); });
  }

  double radius_of_approach(double approach) const;
  double radius_of_force(double force) const;
  double max_radius() const noexcept { return std::numeric_limits<double>::infinity(); }
  ProfileErrors errors() const noexcept;

  const std::vector<PowerProfile>& powers() const noexcept { return powers_; }

 private:
  explicit PowerSum(std::vector<PowerProfile> powers) : powers_(std::move(powers)) {}

  template <class Real, class Part>
  Real sum(const Part& part) const {
    Real total = 0;
    for (const PowerProfile& power : powers_) total += part(power);
    return total;
  }

  std::vector<PowerProfile> powers_;
};

}  // namespace patchgrip::contact
