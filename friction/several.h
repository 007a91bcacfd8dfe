// Friction of several patches at once, each with its own normal force and its own coefficient of friction.
//
// With the normal force F_i and the coefficient mu_i of part i the friction wrench is -R grad D(v), where
//
//     D(v) = sum of w_i D_i(v),    w_i = mu_i F_i / R,    R = sum of mu_i F_i
//
// (linearity of 4.45 and 4.47 in the pressure). R is the resistance: what the parts bear in a translation. So D is a
// patch like any other, that of the friction stress mu p per unit of its integral R, and is asked as any other: a
// load t is held while its gauge max t.v / D(v) <= R. Where all mu_i are equal D is that of the pressure, w_i the
// shares of the normal force, and R = mu F_N.
//
// The moments of the concept, moments(), are those of mu p, as D is its integral: start and certificate of the gauge
// need them so. Mean speeds (4.48) and viscous friction (4.49) ask for those of p alone: pressure_moments().
//
// Parts     lie where their own frames say: Placed(HertzDisc::of_radius(a), x, y), a polygon by its vertices. They are
//           added as they are; zones that overlap add their pressures.
// Units     normal_force [N] or any share of it, mu [1]; resistance [N]; the rest as patch.h.
// Error     that of the parts by their weights and two roundings a part: `bounds --kind several`.
// At rest, and with the pole on a point load among the parts: gradient() answers a subgradient, 0 for the part at rest.
// Throws    std::invalid_argument, naming the part, unless there is one, all F_i > 0, all mu_i >= 0, and R > 0.
//           hessian(): std::domain_error where that of a part does.
#pragma once

#include <memory>
#include <vector>

#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

class Several {
 public:
  struct Part {
    AnyPatch patch;
    double normal_force;  // F_i [N], > 0
    double mu = 1;        // mu_i [1], >= 0
  };

  static Several of_parts(std::vector<Part> parts);

  double dissipation(const Twist& v) const noexcept;
  Wrench gradient(const Twist& v) const noexcept;
  BoundedWrench bounded_gradient(const Twist& v) const noexcept;
  Hessian hessian(const Twist& v) const;
  PressureMoments moments() const noexcept;  // of mu p
  double area_radius() const noexcept;
  std::vector<PointShare> point_shares() const;

  double resistance() const noexcept;                 // R [N]
  double normal_force() const noexcept;               // sum of F_i [N]
  PressureMoments pressure_moments() const noexcept;  // of p
  const std::vector<Part>& parts() const noexcept;

  friend BoundedWrench stribeck_excess(const Several& several, const Twist& u) noexcept;

 private:
  struct Data;
  template <class F>
  BoundedWrench sum_of(const F& wrench_of) const noexcept;
  explicit Several(std::shared_ptr<const Data> data) noexcept : data_(std::move(data)) {}

  std::shared_ptr<const Data> data_;
};

// Coulomb friction wrench -R grad D(v) of the parts, each with its own coefficient.
BoundedWrench friction_wrench(const Several& several, const Twist& v) noexcept;

}  // namespace patchgrip::friction
