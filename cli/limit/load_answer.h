// What a contact says to one load: how much friction it needs, how much is left, and how it would slip.
//
//     gauge g       smallest mu F_N (with parts of their own mu: smallest sum of mu_i F_i) that holds the load
//     margin        mu F_N / g: the load may grow by this factor
//     slip          the twist that the load starts, scaled to a mean sliding speed D = 1 m/s; then load . slip = g
//                   watts
//     stick radius  rho_H = sqrt(F^2 + (M / a_K)^2) / g                                             (seed 4.51, 4.52)
//
// Errors   gauge: the bracket of the library's certificate, and what the rounding of a shape that follows from bodies
//          does to it. Points of a pressure that is symmetric about its centre, moved by at most delta of their
//          distance from it, change D by no more than delta |w| S(centre) <= delta D, and so g by delta / (1 - delta).
//          Of a fitted radius, what it may be finitely off by: gauge and slip change one way with it, and lie between
//          those of the ends.
//          Where the pressure is computed on a grid, the difference from half as many cells is added to all.
//          slip and pole: estimates (slip_error.h), infinite where the load starts no one slip: on a ridge, and where
//          the bracket is all that is known. Gauge, margin and verdict hold there as elsewhere.
#pragma once

#include <cmath>
#include <limits>

#include <patchgrip/contact/estimate.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/limit_surface/slip_error.h>
#include <patchgrip/friction/patch.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::cli {

using contact::Estimate;

enum class Verdict { holds, slips, undecided };

struct Slip {
  friction::Twist twist;
  double speed_error;  // of (vx, vy), length of the difference [m/s]; infinite where the slip is not determined
  double spin_error;   // [rad/s]
  friction::Pole pole;
  double pole_error;  // distance [m]; infinite where the spin is 0 within its error
};

struct LoadAnswer {
  friction::Wrench load;
  friction::Gauge gauge;
  double gauge_error;     // [N]
  Estimate margin;        // [1]; infinite without a load
  Estimate stick_radius;  // [1]; not-a-number without a load or an area
  Verdict verdict;
  Slip slip;

  bool loaded() const noexcept { return load.fx != 0 || load.fy != 0 || load.m != 0; }
  bool turns() const noexcept { return std::isfinite(slip.pole_error); }
  // Not on a ridge, where the slip is one of several.
  bool starts_one_slip() const noexcept { return loaded() && std::isfinite(slip.speed_error + slip.spin_error); }
};

// mu F_N of a contact [N], its own relative error, and that of a gauge that its shape causes.
struct Capacity {
  double value = std::numeric_limits<double>::quiet_NaN();  // not-a-number where friction is not given
  double relative_error = 0;
  double shape_error = 0;
};

namespace limit {

Slip slip_of(const friction::Gauge& gauge, const friction::Wrench& load, const friction::PatchView& patch,
             const friction::PressureFrame& frame, double shape_error) noexcept;

LoadAnswer answer_of(const friction::Wrench& load, const friction::Gauge& gauge, const Slip& slip, double area_radius,
                     const Capacity& capacity) noexcept;

LoadAnswer answer_between(const LoadAnswer& answer, double area_radius, const LoadAnswer& narrow, double narrow_radius,
                          const LoadAnswer& wide, const friction::Pole& centre, const Capacity& capacity) noexcept;

}  // namespace limit

template <friction::Patch P>
LoadAnswer answer_load(const friction::LimitSurface<P>& surface, const Capacity& capacity,
                       const friction::Wrench& load) noexcept {
  const friction::Gauge gauge = surface.gauge(load);
  const Slip slip = limit::slip_of(gauge, load, friction::view(surface.patch()), surface.frame(), capacity.shape_error);
  return limit::answer_of(load, gauge, slip, surface.patch().area_radius(), capacity);
}

// The same with what a coarser solution of the pressure says of the error.
template <friction::Patch P>
LoadAnswer answer_load(const friction::LimitSurface<P>& surface, const friction::LimitSurface<P>& coarse,
                       Capacity capacity, const friction::Wrench& load) noexcept {
  const LoadAnswer fine = answer_load(surface, capacity, load);
  const LoadAnswer other = answer_load(coarse, capacity, load);
  if (!fine.loaded()) return fine;
  capacity.shape_error += std::fabs(other.gauge.value - fine.gauge.value) / fine.gauge.value;
  const Slip slip =
      limit::slip_of(fine.gauge, load, friction::view(surface.patch()), surface.frame(), capacity.shape_error);
  LoadAnswer answer = limit::answer_of(load, fine.gauge, slip, surface.patch().area_radius(), capacity);
  const friction::Twist &u = fine.slip.twist, &v = other.slip.twist;
  answer.slip.speed_error += std::hypot(u.vx - v.vx, u.vy - v.vy);
  answer.slip.spin_error += std::fabs(u.w - v.w);
  answer.slip.pole_error += std::hypot(fine.slip.pole.x - other.slip.pole.x, fine.slip.pole.y - other.slip.pole.y);
  return answer;
}

// The same of a round patch about `centre` whose radius lies between two that are finitely apart: those of `narrow` and
// `wide`.
template <friction::Patch P>
LoadAnswer answer_load(const friction::LimitSurface<P>& surface, const friction::LimitSurface<P>& narrow,
                       const friction::LimitSurface<P>& wide, const friction::Pole& centre, const Capacity& capacity,
                       const friction::Wrench& load) noexcept {
  const LoadAnswer answer = answer_load(surface, capacity, load);
  if (!answer.loaded()) return answer;
  return limit::answer_between(answer, surface.patch().area_radius(), answer_load(narrow, capacity, load),
                               narrow.patch().area_radius(), answer_load(wide, capacity, load), centre, capacity);
}

}  // namespace patchgrip::cli
