// One press of viscoelastic bodies under a given force: the contact grows, then shrinks.
//
//     growing     a, delta: elastic with F / E* = X(t)                                            (Lee and Radok 1960)
//     shrinking   a(t) = a(t_1),  delta(t) = delta(t_m) - C_0 I(t) - int_tm^t C'(t - s) I(s) ds            (Ting 1966)
//                 I(s) = int_t1(s)^tm M(s - s') d delta(s'):  the springs at the edge carry nothing
//     both        p(r, t) = int_0^t1 M(t - s) dp_1(r, a(s)),  p_1 the elastic pressure for E* = 1
//
// p is not Hertz's, as it is not the pressure that belongs to a(t): M(t - s) weights where each part of the zone was
// reached, when. The seed's 4.28 keeps the elastic shape and is 17 % too deep at alpha t = 1 of a step with E1 = E2:
// seed_creep.h.
//
// Domain   any profile; t from the start of the force to valid_until(): until the contact is lost, or grows again.
//          pressure() asks for C_0 > 0: behind a bare dashpot (Kelvin-Voigt) it is not given.
// Units    a, r, delta [m], F [N], p [Pa], t [s].
// Error    growing: radius and approach as the profile's own with X good to 12 + n / 2 units of 2^-53; shrinking:
//          radius to the root of Ting's equation, approach and pressure with an estimate.
//          tests/contact/creep_press_test.cc.
// Fails    p is +infinity where the profile's own pressure is (the tip of a cone).
// Throws   std::invalid_argument from the factory (receding_load.h), and for times and places outside the domain.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/creep/fading.h>
#include <patchgrip/contact/creep/receding_load.h>
#include <patchgrip/contact/falling_root.h>

namespace patchgrip::contact {

template <Profile P>
class PressUnderForce {
 public:
  static PressUnderForce of(P profile, ContactCreep creep, History force, double until) {
    return {std::move(profile), RecedingLoad(std::move(creep), std::move(force), until)};
  }

  double grows_until() const noexcept { return load_.grows_until(); }  // t_m
  double valid_until() const noexcept { return load_.valid_until(); }
  const RecedingLoad& load() const noexcept { return load_; }

  // t_1: when the growing contact had the radius of time t.
  double earlier_time(double t) const { return load_.past(checked(t)).time; }

  double radius(double t) const { return radius_of(load_.past(checked(t)).measure); }

  Estimate approach(double t) const {
    checked(t);
    const double end = load_.grows_until();
    const double deepest = approach_of(load_.grown(std::min(t, end)));
    if (t <= end) return {deepest, 32 * 0x1p-53 * deepest};
    const auto& compliance = load_.creep().compliance;
    double inner_error = 0;
    const auto lost = [&](double s) {
      const Estimate lost_stress = edge_stress(s, deepest);
      inner_error = std::max(inner_error, lost_stress.error);
      return lost_stress.value;
    };
    const double now = lost(t);
    Estimate crept{0, 0};
    if (!compliance.modes().empty() || compliance.fluidity() > 0) {
      const double shortest = compliance.modes().empty() ? t - end : compliance.modes().front().time;
      crept = fading::over_past([&](double s) { return compliance.slope(t - s) * lost(s); }, end, t, shortest,
                                load_.passes(t), 8 * 0x1p-53 * deepest);
    }
    const double value = deepest - compliance.instantaneous() * now - crept.value;
    return {value, crept.error + compliance(t - end) * inner_error + 32 * 0x1p-53 * deepest};
  }

  Estimate pressure(double r, double t) const {
    require_non_negative("r", r);
    require_positive("instantaneous compliance", load_.creep().compliance.instantaneous());
    const Past now = load_.past(checked(t));
    const double edge = radius_of(now.measure);
    if (r >= edge) return {0, 0};
    const auto elastic = [&](double a) { return a > r ? static_cast<double>(profile_.pressure(r, a)) : 0; };
    const double last = elastic(edge);
    if (std::isinf(last)) return {last, last};
    return hereditary_integral(
        load_.creep().modulus, [&](double s) { return elastic(radius_of(load_.grown(s))); }, 0, last,
        reached(r, now.time), now.time, t, breaks());
  }

 private:
  PressUnderForce(P profile, RecedingLoad load) : profile_(std::move(profile)), load_(std::move(load)) {}

  double checked(double t) const { return require_in("time", t, load_.force().start(), load_.valid_until()); }

  double radius_of(double X) const { return X > 0 ? static_cast<double>(profile_.radius_of_force(X)) : 0; }
  double approach_of(double X) const {
    return X > 0 ? static_cast<double>(profile_.approach(profile_.radius_of_force(X))) : 0;
  }

  // I(s), s >= t_m.
  Estimate edge_stress(double s, double deepest) const {
    const Past past = load_.past(s);
    return hereditary_integral(
        load_.creep().modulus, [&](double at) { return approach_of(load_.grown(at)); }, approach_of(past.measure),
        deepest, past.time, load_.grows_until(), s, breaks());
  }

  // When the edge of the growing contact came to r, up to time t.
  double reached(double r, double t) const {
    double lo = load_.force().start(), hi = t;
    if (radius_of(load_.grown(lo)) >= r) return lo;
    const double X = profile_.force(r);
    for (const auto& piece : load_.force().pieces()) {
      if (piece.start >= t) break;
      (load_.grown(piece.start) < X ? lo : hi) = piece.start;
      if (hi == piece.start) break;
    }
    return falling_root([&](double s) { return X - load_.grown(s); }, lo, hi);
  }

  std::vector<double> breaks() const {
    std::vector<double> times;
    for (const auto& piece : load_.force().pieces()) times.push_back(piece.start);
    return times;
  }

  P profile_;
  RecedingLoad load_;
};

}  // namespace patchgrip::contact
