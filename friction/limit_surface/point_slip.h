// The gauge of loads whose slip turns about a point load, or so close by that D is not smooth for Newton's method.
//
// On the facet   the force q that the point bears has no moment about it. With moments M_P of the load and R_P of the
//                rest (kink.h) about the point, gauge and force follow without iteration,
//
//                    g = |M_P| / R_P,      q = F / g - F_R
//
//                and |q| <= w proves it: the slip turns about the point itself, to the last digit.
// Next to it     |q| > w, and the point moves at a velocity z (unit spin) along the force that it bears:
//
//                    F_R(z) + w z / |z| = F / g
//
//                Newton's method linearises F_R alone, (H_R + w / |z|) z = F / g - F_R + H_R z: one equation in |z|,
//                which is met exactly. g is stationary in z, t . v / D(v) will do.
// Certificate    grad R + (q shortened to w) is a point of B wherever R is differentiated, so that rounding of z, which
//                turns z / |z| however it likes, costs the bracket nothing.
//
// Domain   force and moment of which M_P is not 0; a point with a rest.
// Error    carried by the bracket; tests/friction/limit_surface/point_loads_test.cc.
#pragma once

#include <optional>

#include <patchgrip/friction/limit_surface/certificate.h>
#include <patchgrip/friction/limit_surface/gauge.h>
#include <patchgrip/friction/limit_surface/kink.h>
#include <patchgrip/friction/limit_surface/pressure_frame.h>

namespace patchgrip::friction {

// A slip about the point or next to it, for a load that turns about it counter-clockwise (turned by -1 if it does not).
struct PointForce {
  double gauge;        // t . v / D(v)
  double dissipation;  // D(v)
  Planar asked;        // F / g - F_R: what the rest leaves to the point
};

PointForce point_force(const Kink& kink, const NearKink& near, const Wrench& load) noexcept;

// z with (H + w / |z|) z = a, where |a| > w. Shortened to `longest` where it is longer.
Planar velocity_of_point(const Stiffness& h, double w, const Planar& a, double longest) noexcept;

// a . H a / |a|^2, of the force by the velocity along it; 0 where rounding of H would not tell it from that.
double stiffness_along(const Stiffness& h, const Planar& a) noexcept;

// The gauge of the load if it starts a slip about the kink or next to it, within `relative_gap`; else none. Adds to
// `evaluations`.
std::optional<Gauge> gauge_at(const Kink& kink, const PatchView& patch, const PressureFrame& frame, const Wrench& load,
                              const GaugeSettings& settings, int& evaluations) noexcept;

// The kink at or next to which the load's slip is expected; null if none.
const Kink* likely_kink(const PressureFrame& frame, const Wrench& load) noexcept;

// The kink that is nearest to the pole of a slip; null if there is none.
const Kink* nearest_kink(const PressureFrame& frame, const Twist& v) noexcept;

// A slip away from the kink, of a greater t . v / D(v) than that about it: whoever climbs from there does not come
// back.
std::optional<Twist> away_from(const Kink& kink, const PatchView& patch, const PressureFrame& frame, const Wrench& load,
                               int& evaluations) noexcept;

}  // namespace patchgrip::friction
