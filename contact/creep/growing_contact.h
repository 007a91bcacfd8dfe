// Contact that creeps and grows, one step at a time: Lee and Radok's solution for a force that is given.
//
//     X = int C(t - s) dF(s);     radius, approach: the elastic ones with F / E* = X          (seed 4.28, corrected)
//     z_j <- z_j exp(-h / lambda_j) + F (1 - exp(-h / lambda_j)) + F' lambda_j (h / lambda_j - 1 + exp(-h / lambda_j))
//     X = C_0 F + sum C_j z_j + fluidity int F dt
//
// Exact for a force that is linear over each step, whatever its length; one number a mode is all of the past.
//
// Domain   right while X does not fall; `is_growing` says whether it did so at every step so far. When it fell, the
//          contact has shrunk and neither radius nor approach is that of X: press_under_force.h, springs.h.
// Units    F [N], h [s], X [m^2].
// Error    X: as if by the closed form (load_integral.h), and 2 units of rounding (2^-53) a step, h / lambda normal;
//          tests/contact/growing_contact_test.cc.
// Throws   std::invalid_argument unless duration and force are >= 0 and finite, or where X would overflow.
#pragma once

#include <vector>

#include <patchgrip/contact/creep/contact_creep.h>

namespace patchgrip::contact {

class GrowingContact {
 public:
  explicit GrowingContact(const CreepCompliance& compliance);

  // The force goes to `force` linearly, within `duration` [s]; at once if that is 0.
  void advance(double duration, double force);

  double load_integral() const noexcept { return load_integral_; }  // X [m^2]
  double force() const noexcept { return force_; }                  // F [N]
  bool is_growing() const noexcept { return is_growing_; }

  // Radius and approach [m] of a profile (axisymmetric.h).
  template <class P>
  double radius(const P& profile) const {
    return load_integral_ > 0 ? static_cast<double>(profile.radius_of_force(load_integral_)) : 0;
  }
  template <class P>
  double approach(const P& profile) const {
    return load_integral_ > 0 ? static_cast<double>(profile.approach(profile.radius_of_force(load_integral_))) : 0;
  }

 private:
  CreepCompliance compliance_;
  std::vector<double> lagged_;  // z_j [N]
  double force_ = 0;
  double impulse_ = 0;  // int F dt
  double load_integral_ = 0;
  bool is_growing_ = true;
};

}  // namespace patchgrip::contact
