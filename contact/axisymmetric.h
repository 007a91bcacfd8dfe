// Contact of any body of revolution with an elastic half-space, without friction or adhesion.
//
// A rigid stamp z = f(r) acts through one function of its shape alone (seed 4.6 for a round zone; Sneddon 1965):
//
//     g(x) = x int_0^x f'(r) / sqrt(x^2 - r^2) dr
//
//     delta = g(a)                                          approach at contact radius a
//     F     = 2 E* int_0^a (g(a) - g(x)) dx                 normal force
//     p(r)  = (E*/pi) int_r^a g'(x) / sqrt(x^2 - r^2) dx    pressure, r <= a
//     u_z   = delta - f(r) inside,  (2/pi) int_0^a (g(a) - g(x)) / sqrt(r^2 - x^2) dx outside
//     dF/d(delta) = 2 E* a                                  stiffness, the same for every shape
//
// Read differently: the contact is a stack of flat punches of radius x with loads dF = 2 E* x dg(x), 0 < x <= a. The
// share of each per unit force is the punch load density 2 x g'(x) / (F/E*).
//
// A Profile gives these functions per unit E*. Two elastic bodies of revolution: f is the sum of their heights, E* as
// in material.h.
//
// Domain   f(0) = 0, f never falling, slopes small, a <= max_radius() of the profile; the zone is one circle.
// Units    r, x, a, f, g, delta, u_z [m]; F/E* [m^2]; p/E*, g' [1]; density [1/m]; F [N], E*, p [Pa], stiffness [N/m].
// Signs    pressure and force positive in compression; u_z positive into the half-space.
// Error    each profile states its own (errors()), in units of 2^-53; a contact states what follows from them for the
//          arguments it was made of. tests/contact/axisymmetric_test.cc.
// Fails    p is infinite where the slope of f jumps (r = 0 of a cone, r = b of a flat end), and so is g' at such b > 0:
//          both are integrable, and returned as +infinity. A bound of the error is infinite there, too; pressure_error
//          is no bound where the radius itself is a jump to within rounding.
// Throws   std::invalid_argument, naming the parameter, from the factories alone; std::runtime_error, with the
//          residual, where an inversion does not converge.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>
#include <utility>

#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

// Bounds of relative errors in units of 2^-53, for the arguments as given.
struct ProfileErrors {
  double approach;      // g(a); of g'(a), too
  double force;         // F(a)
  double pressure;      // p(r, a)
  double displacement;  // u_z(r, a) of r > a; inside, delta and f(r) are each good to `approach`
  double radius;        // radius_of_force, radius_of_approach
};

// What radius_of_force returns converts to a double and can stand wherever a radius can. Where neighboring doubles a
// are too coarse (a sphere sunk to its equator, a flat end that just touches), it is a finer type of the profile.
template <class P>
concept Profile = requires(const P& profile, double r, double a) {
  { profile.height(r) } -> std::convertible_to<double>;              // f(r)
  { profile.approach(a) } -> std::convertible_to<double>;            // g(a)
  { profile.approach_slope(a) } -> std::convertible_to<double>;      // g'(a)
  { profile.force(a) } -> std::convertible_to<double>;               // F / E*
  { profile.pressure(r, a) } -> std::convertible_to<double>;         // p / E*, 0 <= r <= a
  { profile.displacement(r, a) } -> std::convertible_to<double>;     // u_z, r >= 0
  { profile.radius_of_approach(r) } -> std::convertible_to<double>;  // a of delta
  { profile.radius_of_force(r) } -> std::convertible_to<double>;     // a of F / E*
  { profile.max_radius() } -> std::convertible_to<double>;           // may be infinite
  { profile.errors() } -> std::convertible_to<ProfileErrors>;
};

// Load of the flat punches of radius x..x+dx, per dx and unit force; 0 < x <= a.
template <Profile P, class X, class Circle>
double punch_load_density(const P& profile, const X& x, const Circle& a) {
  return 2 * x * profile.approach_slope(x) / profile.force(a);
}

template <Profile P>
class AxisymmetricContact {
 public:
  using Circle = decltype(std::declval<const P&>().radius_of_force(1.0));

  static AxisymmetricContact at_radius(P profile, double contact_radius, double contact_modulus) {
    require_positive("contact_radius", contact_radius);
    require_in("contact_radius", contact_radius, 0, profile.max_radius());
    require_positive("contact_modulus", contact_modulus);
    const Circle a = circle(profile, contact_radius);
    const double force = contact_modulus * profile.force(a);
    const double approach = profile.approach(a);
    const ProfileErrors e = profile.errors();
    return {std::move(profile), a, contact_modulus, force, approach, {0, e.force + 1, e.approach}};
  }

  static AxisymmetricContact under_force(P profile, double normal_force, double contact_modulus) {
    require_positive("normal_force", normal_force);
    require_positive("contact_modulus", contact_modulus);
    const double scaled = require_representable("normal_force / contact_modulus", normal_force / contact_modulus);
    if (std::isfinite(profile.max_radius())) {
      require_in("normal_force", normal_force, 0, contact_modulus * profile.force(profile.max_radius()));
    }
    const Circle a = profile.radius_of_force(scaled);
    // What the rounding of a costs is repaired by the stiffness: d(delta) = dF / (2 a).
    const double force = profile.force(a);
    const double approach = profile.approach(a) + (scaled - force) / (2 * static_cast<double>(a));
    const ProfileErrors e = profile.errors();
    const double share = scaled / (2 * static_cast<double>(a) * approach);
    return {std::move(profile), a,        contact_modulus,
            normal_force,       approach, {e.radius + 1, 0, e.approach + (e.force + 2) * share + 2}};
  }

  static AxisymmetricContact at_approach(P profile, double approach, double contact_modulus) {
    require_positive("approach", approach);
    require_positive("contact_modulus", contact_modulus);
    if (std::isfinite(profile.max_radius())) {
      require_in("approach", approach, 0, profile.approach(profile.max_radius()));
    }
    const Circle a = profile.radius_of_approach(approach);
    const double scaled = profile.force(a) + 2 * static_cast<double>(a) * (approach - profile.approach(a));
    const ProfileErrors e = profile.errors();
    const double share = 2 * static_cast<double>(a) * approach / scaled;
    return {std::move(profile),       a,        contact_modulus,
            contact_modulus * scaled, approach, {e.radius, e.force + (e.approach + 1) * share + 3, 0}};
  }

  const P& profile() const noexcept { return profile_; }
  const Circle& circle() const noexcept { return circle_; }
  double radius() const noexcept { return radius_; }            // a
  double force() const noexcept { return force_; }              // F
  double approach() const noexcept { return approach_; }        // delta
  double contact_modulus() const noexcept { return modulus_; }  // E*
  double stiffness() const { return 2 * modulus_ * radius_; }   // dF / d(delta)
  double growth_exponent() const {                              // d ln F / d ln a
    return radius_ * punch_load_density(circle_);
  }
  double mean_pressure() const { return force_ / (std::numbers::pi * radius_ * radius_); }

  // Even in r; NaN of NaN.
  double pressure(double r) const {
    return at_distance(r, [&](double d) { return d < radius_ ? modulus_ * profile_.pressure(d, circle_) : 0; });
  }
  double displacement(double r) const {
    return at_distance(r, [&](double d) -> double { return profile_.displacement(d, circle_); });
  }
  double gap(double r) const {
    return at_distance(
        r, [&](double d) { return d > radius_ ? std::max(profile_.height(d) - approach_ + displacement(d), 0.) : 0; });
  }
  template <class X>
  double punch_load_density(const X& x) const {
    return contact::punch_load_density(profile_, x, circle_);
  }

  // Bounds for the arguments of the factory, as if those were exact.
  double radius_error() const { return unit * errors_.radius * radius_; }
  double force_error() const { return unit * errors_.force * force_; }
  double approach_error() const { return unit * errors_.approach * approach_; }
  double stiffness_error() const { return unit * (errors_.radius + 1) * stiffness(); }

  // A radius that is off by h changes p by the flat punches between a - h and a + h: g'(a) int dx / (pi sqrt(x^2-r^2)).
  double pressure_error(double r) const {
    r = std::fabs(r);
    const double h = spread();
    if (r >= radius_ + h) return 0;
    const double own = unit * (profile_.errors().pressure + 1) * pressure(r);
    if (h == 0) return own;
    const double outer = std::max(radius_ - r, 0.);
    const double inner = std::max(outer - h, 0.);
    const double punches = 2 * h / (std::sqrt(radius_ + r) * (std::sqrt(std::max(outer, h)) + std::sqrt(inner)));
    return own + 2 * modulus_ * profile_.approach_slope(circle_) / std::numbers::pi * punches;
  }

  double displacement_error(double r) const {
    r = std::fabs(r);
    const double u = displacement(r);
    const double moved = profile_.approach_slope(circle_) * spread() * std::min(1., radius_ / r);
    if (r > radius_) return unit * profile_.errors().displacement * u + moved;
    return unit * ((profile_.errors().approach + 1) * (approach_ + profile_.height(r)) + errors_.approach * approach_);
  }

  double gap_error(double r) const {
    r = std::fabs(r);
    if (r <= radius_) return 0;
    return displacement_error(r) + unit * (2 + profile_.errors().approach) * (profile_.height(r) + approach_) +
           approach_error();
  }

 private:
  static constexpr double unit = 0x1p-53;

  struct Units {
    double radius, force, approach;
  };

  AxisymmetricContact(P profile, Circle a, double modulus, double force, double approach, Units errors)
      : profile_(std::move(profile)),
        circle_(a),
        radius_(require_representable("contact_radius", static_cast<double>(a))),
        modulus_(modulus),
        force_(require_representable("normal_force", force)),
        approach_(require_representable("approach", approach)),
        errors_(errors) {}

  template <class F>
  static double at_distance(double r, F&& f) {
    return std::isnan(r) ? r : f(std::fabs(r));
  }

  static Circle circle(const P& profile, double radius) {
    if constexpr (std::same_as<Circle, double>) {
      return radius;
    } else {
      return profile.circle(radius);
    }
  }

  double spread() const {
    if constexpr (std::same_as<Circle, double>) {
      return unit * errors_.radius * radius_;
    } else {
      return circle_.spread(unit * errors_.radius);
    }
  }

  P profile_;
  Circle circle_;
  double radius_;    // a [m]
  double modulus_;   // E* [Pa]
  double force_;     // F [N]
  double approach_;  // delta [m]
  Units errors_;
};

}  // namespace patchgrip::contact
