// Any number of presses at a given approach, as exact as rounding: every spring of the foundation in closed form.
//
//     F(t) = 2 int_0^a q(x, t) dx,        p(r, t) = -(1/pi) int_r^a q_x(x, t) / sqrt(x^2 - r^2) dx
//
// q(x, t) from spring.h. It is smooth in x but where the springs change in other pieces of the approach: at the radii
// of its corners, and the greatest and least of the cycles so far. Those are found by bisection, the panels between
// them are integrated in s, x = lo + (hi - lo) s^2 (3 - 2 s), which takes the roots of their ends.
//
// Domain   approaches that are linear between points, with jumps; M without a bare dashpot; exact while the zone is one
//          circle: `is_one_circle`. p >= 0 is certain while q falls outward: `stress_falls`.
// Units    x, r, a [m], F [N], p [Pa], q [Pa m], t [s].
// Error    force and pressure: the estimate; radius: to the last digits. tests/contact/cycles_test.cc.
// Fails    changes that come and go within a 1/48 of the largest radius are not seen as ends of panels: the estimate
//          grows. The pressure loses digits close to the edge and to the axis: the estimate says how many.
// Throws   std::invalid_argument for sines, and for times before the start.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/creep/history.h>
#include <patchgrip/contact/creep/panels.h>
#include <patchgrip/contact/creep/spring.h>

namespace patchgrip::contact {

// The zone at one time.
struct CyclicZone {
  double radius;   // a [m]
  Estimate force;  // F [N]
  bool is_one_circle;
  bool stress_falls;  // q_x <= 0, as far as the points of the quadrature tell
};

// A spring whose point of the stamp is `height` (g) above the lowest, after the approach so far.
struct PressedSpring {
  double stress;  // q [Pa m]
  double depth;   // u [m]
  bool is_touching;
  std::uint64_t course;  // alike where the spring was met and let go in the same pieces of the approach
};

// The course after one more change, in the given piece: a hash (FNV-1a, with a final shift) whose values meet by chance
// alone, once in 2^64.
constexpr std::uint64_t next_course(std::uint64_t course, std::size_t piece) {
  const std::uint64_t mixed = (course ^ (piece + 1)) * 0x100000001b3;
  return mixed ^ (mixed >> 29);
}

PressedSpring press_spring(const SpringLaw& law, const History& approach, double height, double t);

template <Profile P>
class Cycles {
 public:
  static Cycles of(P profile, ContactCreep creep, History approach) {
    for (const auto& piece : approach.pieces()) {
      if (piece.amplitude != 0) refuse("amplitude", piece.amplitude, "must be 0: straight pieces only");
    }
    return {std::move(profile), SpringLaw(std::move(creep)), std::move(approach)};
  }

  PressedSpring spring(double x, double t) const {
    return press_spring(law_, approach_, x > 0 ? static_cast<double>(profile_.approach(x)) : 0, t);
  }

  CyclicZone zone(double t) const {
    const Ends ends = ends_of(t);
    CyclicZone zone{ends.radius, {0, 0}, ends.is_one_circle, true};
    std::vector<std::pair<double, double>> stresses;
    zone.force = integral(
        ends.places,
        [&](double x) {
          const double q = spring(x, t).stress;
          stresses.emplace_back(x, q);
          return 2 * q;
        },
        // q is what is left of stresses of this size.
        16 * 0x1p-53 * law_.creep().modulus.instantaneous() * deepest(t) * ends.radius);
    std::sort(stresses.begin(), stresses.end());
    for (std::size_t k = 1; k < stresses.size(); ++k) {
      const double rounding = stress_rounding * stresses.front().second;
      if (stresses[k].second > stresses[k - 1].second + rounding) zone.stress_falls = false;
    }
    return zone;
  }

  double radius(double t) const { return ends_of(t).radius; }

  Estimate pressure(double r, double t) const {
    require_non_negative("r", r);
    const Ends ends = ends_of(t);
    if (r >= ends.radius) return {0, 0};
    const double elastic = profile_.pressure(r, ends.radius);
    if (std::isinf(elastic)) return {elastic, elastic};
    // By parts, without the slope: int (q(r) - q(x)) / z^2 dz + q(r) / z(a), z = sqrt(x^2 - r^2).
    const double q = spring(r, t).stress;
    const auto z_of = [&](double x) { return std::sqrt((x - r) * (x + r)); };
    const double edge = z_of(ends.radius);
    std::vector<double> places{0};
    for (const double x : ends.places) {
      if (x > r) places.push_back(z_of(x));
    }
    const auto fall = [&](double z) { return (q - spring(std::hypot(r, z), t).stress) / (z * z); };
    // Next to r the difference is rounding: up to `near` its value there, and the slope in z^2 (no corner is so close).
    // Close to the axis that slope changes too fast.
    const double panel = places[1], shortest = first_point * panel;
    const double near = nearest * std::min(r, panel) > shortest ? nearest * std::min(r, panel) : 0;
    const double there = near > 0 ? fall(near) : 0;
    const double bend = near > 0 ? (fall(2 * near) - there) / (3 * near * near) : 0;
    const auto smooth_fall = [&](double z) { return z < near ? there + bend * (z - near) * (z + near) : fall(z); };
    // q is what is left of stresses of the size of M(0) times the depth; 8 units of 2^-53 of them are off by 2.5 / near
    // of that, or by what the first of the 21 points of a panel makes of it.
    const double rounding = 8 * 0x1p-53 * law_.creep().modulus.instantaneous() * deepest(t);
    const Estimate rest = integral(places, smooth_fall, rounding * (near > 0 ? 2.5 / near : first_weight / panel));
    constexpr double inverse_pi = std::numbers::inv_pi;
    return {inverse_pi * (q / edge + rest.value), inverse_pi * (4 * 0x1p-53 * q / edge + rest.error)};
  }

 private:
  static constexpr double stress_rounding = 1e-13;  // of q, relative to the one at the axis
  static constexpr double nearest = 1e-3;           // z, over r and over the panel next to it
  // Of a panel: z of the first point over its length, and the sum over its points of their weights over z^2.
  static constexpr double first_point = 1.4e-5, first_weight = 4e5;

  struct Ends {
    std::vector<double> places;  // 0 .. a
    double radius;
    bool is_one_circle;
  };

  Cycles(P profile, SpringLaw law, History approach)
      : profile_(std::move(profile)), law_(std::move(law)), approach_(std::move(approach)) {}

  template <class Function>
  static Estimate integral(const std::vector<double>& places, const Function& f, double floor) {
    std::vector<Panel> panels;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) panels.push_back({0, 1, k});
    return integral_over(
        [&](std::size_t k, double s) {
          const double width = places[k + 1] - places[k];
          return 6 * s * (1 - s) * width * f(places[k] + width * (s * s * (3 - 2 * s)));
        },
        std::move(panels), floor);
  }

  double deepest(double t) const {
    double deepest = 0;
    const auto& pieces = approach_.pieces();
    for (std::size_t k = 0; k < pieces.size() && pieces[k].start <= t; ++k) {
      const double end = k + 1 < pieces.size() ? std::min(t, pieces[k + 1].start) : t;
      deepest = std::max({deepest, pieces[k].value, pieces[k].at(end)});
    }
    return deepest;
  }

  Ends ends_of(double t) const {
    require_in("time", t, approach_.start(), 1e300);
    Ends ends{{0}, 0, true};
    if (!(deepest(t) > 0)) return ends;
    const double reach = static_cast<double>(profile_.radius_of_approach(deepest(t)));
    const auto same = [&](const PressedSpring& one, const PressedSpring& other) {
      return one.course == other.course && one.is_touching == other.is_touching;
    };
    constexpr int looks = 48;
    std::size_t last = 1;  // places up to the edge
    double x = 0;
    PressedSpring here = spring(0, t);
    bool was_left = !here.is_touching;
    for (int k = 1; k <= looks; ++k) {
      const double to = reach * k / looks;
      const PressedSpring there = spring(to, t);
      while (!same(here, there)) {
        double lo = x, hi = to;
        while (true) {
          const double middle = lo + (hi - lo) / 2;
          if (!(middle > lo && middle < hi)) break;
          (same(here, spring(middle, t)) ? lo : hi) = middle;
        }
        const PressedSpring next = spring(hi, t);
        ends.places.push_back(hi);
        if (here.is_touching && !next.is_touching) {
          ends.radius = lo;
          last = ends.places.size();
          was_left = true;
        }
        if (!here.is_touching && next.is_touching && was_left) ends.is_one_circle = false;
        here = next;
        x = hi;
      }
      x = to;
    }
    if (here.is_touching) {
      ends.radius = reach;
      ends.places.push_back(reach);
      last = ends.places.size();
    }
    ends.places.resize(last);
    return ends;
  }

  P profile_;
  SpringLaw law_;
  History approach_;
};

}  // namespace patchgrip::contact
