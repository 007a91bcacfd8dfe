// One press of viscoelastic bodies at a given approach: the contact grows, then shrinks.
//
//     growing     a(t): elastic at delta(t);   F(t) = int_0^t M(t - s) dF_1(a(s))                 (Lee and Radok 1960)
//     shrinking   a(t) = a(t_1);               F(t) = int_0^t1 M(t - s) dF_1(a(s))                         (Ting 1966)
//     both        p(r, t) = int_0^t1 M(t - s) dp_1(r, a(s))
//
// F_1, p_1: force and pressure of the elastic contact for E* = 1; for a paraboloid F_1 = (4/3) sqrt(R) delta^(3/2).
// t_1 is the earlier time at which the growing contact had the radius of now (receding_approach.h).
//
// Domain   any profile; t from the start of the approach to valid_until(): until the contact is lost, or grows again
//          (then cycles.h). No bare dashpot.
// Units    a, r, delta [m], F [N], p [Pa], t [s].
// Error    radius: the profile's own, and the root of Ting's equation; force and pressure with an estimate.
//          tests/contact/creep_press_test.cc.
// Fails    p is +infinity where the profile's own pressure is (the tip of a cone).
// Throws   std::invalid_argument from the factory (receding_approach.h), and for times and places outside the domain.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/creep/fading.h>
#include <patchgrip/contact/creep/load_integral.h>
#include <patchgrip/contact/creep/receding_approach.h>
#include <patchgrip/contact/falling_root.h>

namespace patchgrip::contact {

template <Profile P>
class PressAtApproach {
 public:
  static PressAtApproach of(P profile, const ContactCreep& creep, History approach, double until) {
    return {std::move(profile), RecedingApproach(creep.modulus, std::move(approach), until)};
  }

  double grows_until() const noexcept { return zone_.grows_until(); }    // t_m
  double contact_lost() const noexcept { return zone_.contact_lost(); }  // +infinity if it is not
  double valid_until() const noexcept { return zone_.valid_until(); }

  double earlier_time(double t) const { return zone_.past(checked(t)).time; }  // t_1
  double radius(double t) const { return radius_of(zone_.past(checked(t)).measure); }

  Estimate force(double t) const {
    return past_integral([&](double a) { return a > 0 ? static_cast<double>(profile_.force(a)) : 0; },
                         zone_.approach().start(), t);
  }

  Estimate pressure(double r, double t) const {
    require_non_negative("r", r);
    const Past now = zone_.past(checked(t));
    if (r >= radius_of(now.measure)) return {0, 0};
    const auto elastic = [&](double a) { return a > r ? static_cast<double>(profile_.pressure(r, a)) : 0; };
    const double last = elastic(radius_of(now.measure));
    if (std::isinf(last)) return {last, last};
    return past_integral(elastic, reached(r, now.time), t);
  }

 private:
  PressAtApproach(P profile, RecedingApproach zone) : profile_(std::move(profile)), zone_(std::move(zone)) {}

  double checked(double t) const { return require_in("time", t, zone_.approach().start(), zone_.valid_until()); }

  double radius_of(double approach) const {
    return approach > 0 ? static_cast<double>(profile_.radius_of_approach(approach)) : 0;
  }

  template <class Elastic>
  Estimate past_integral(const Elastic& elastic, double from, double t) const {
    const Past now = zone_.past(checked(t));
    std::vector<double> breaks;
    for (const auto& piece : zone_.approach().pieces()) breaks.push_back(piece.start);
    return hereditary_integral(
        zone_.modulus(), [&](double s) { return elastic(radius_of(zone_.approach()(s))); }, 0,
        elastic(radius_of(now.measure)), from, now.time, t, breaks);
  }

  // When the edge of the growing contact came to r, up to time t.
  double reached(double r, double t) const {
    double lo = zone_.approach().start(), hi = t;
    if (radius_of(zone_.approach()(lo)) >= r) return lo;
    const double depth = profile_.approach(r);
    for (const auto& piece : zone_.approach().pieces()) {
      if (piece.start >= t) break;
      (zone_.approach()(piece.start) < depth ? lo : hi) = piece.start;
      if (hi == piece.start) break;
    }
    return falling_root([&](double s) { return depth - zone_.approach()(s); }, lo, hi);
  }

  P profile_;
  RecedingApproach zone_;
};

}  // namespace patchgrip::contact
