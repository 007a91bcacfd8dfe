// Adhesion between JKR and DMT: a constant attraction sigma_0 in a ring a < r < c around the contact.
//
//     lambda = 2 sigma_0 (R / (pi w K^2))^(1/3),   K = 4 E*/3
//     A = a (K / (pi w R^2))^(1/3),   m = c/a,   t = arccos(1/m)
//     (lambda A^2/2)[sqrt(m^2 - 1) + (m^2 - 2) t] + (4 lambda^2 A/3)[sqrt(m^2 - 1) t - m + 1] = 1
//     F = pi w R {A^3 - lambda A^2 [sqrt(m^2 - 1) + m^2 t]}
//     delta = (pi^2 w^2 R / K^2)^(1/3) [A^2 - (4/3) lambda A sqrt(m^2 - 1)]
//     p(r) = (2 E* / (pi R)) sqrt(a^2 - r^2) - (2 sigma_0 / pi) arctan sqrt((c^2 - a^2)/(a^2 - r^2)) for r < a,
//     p(r) = -sigma_0 in the ring
//
// (Maugis, J. Colloid Interface Sci. 150, 1992.) Solved along the curve of its equilibria (maugis_curve.h); lambda -> 0
// is DMT, lambda -> infinity JKR. The branch stable under load ends at the pull-off, the largest tension.
//
// Domain   1e-8 <= lambda <= 1e8; F not below the pull-off; a, c much smaller than R.
// Units    F [N], a, c, r, delta [m], sigma_0, p [Pa], lambda [1].
// Error    units of 2^-53: at a given radius c - a, c <= 1.1, relative; F, delta <= 1.1 of the larger of their two
//          terms; at the pull-off F <= 1.1, a, c - a <= 2. Under a load the radius is the less certain the closer the
//          pull-off: relative_radius_error of the state, which is 1.1 units away from it;
//          tests/contact/maugis_dugdale_test.cc.
// Throws   std::invalid_argument, naming the parameter, outside the domain; std::runtime_error, with the residual,
//          should the root not be found.
#pragma once

#include <patchgrip/contact/adhesion/adhesive_sphere.h>
#include <patchgrip/contact/adhesion/maugis_curve.h>

namespace patchgrip::contact {

struct MaugisState {
  double normal_force;           // F [N]
  double approach;               // delta [m]
  double contact_radius;         // a [m]
  double outer_radius;           // c [m], where attraction ends
  double ring_width;             // c - a [m], right where c is close to a
  double relative_radius_error;  // bound, of a and of c - a [1]
};

class MaugisDugdale {
 public:
  static MaugisDugdale of(const AdhesiveSphere& sphere, double attraction);

  MaugisState at_radius(double contact_radius) const;  // stable or not
  MaugisState under_force(double normal_force) const;  // stable under load
  MaugisState pull_off() const;

  double pressure(const MaugisState& state, double r) const;

  const AdhesiveSphere& sphere() const noexcept { return sphere_; }
  double attraction() const noexcept { return attraction_; }                               // sigma_0 [Pa]
  double maugis_parameter() const noexcept { return static_cast<double>(curve_.lambda); }  // lambda [1]

 private:
  using Point = MaugisCurve<long double>::Point;

  MaugisDugdale(const AdhesiveSphere& sphere, double attraction, long double lambda)
      : sphere_(sphere), attraction_(attraction), curve_{lambda}, pull_off_(curve_.pull_off()) {}

  MaugisState state(const Point& point, double relative_radius_error) const;

  AdhesiveSphere sphere_;
  double attraction_;
  MaugisCurve<long double> curve_;
  Point pull_off_;
};

// Least force over -pi w R for every lambda: 7/4 - (1/4)(4.04 lambda^1.4 - 1)/(4.04 lambda^1.4 + 1)
// (Carpick, Ogletree, Salmeron, J. Colloid Interface Sci. 211, 1999). Error within -1.8 .. +0.7 % of pull_off().
double pull_off_fit(double maugis_parameter);

}  // namespace patchgrip::contact
