// What one contact can transmit: a cone over the limit surface of its friction.
//
// Normal force F >= 0, friction t = (R_u, R_v, R_M) in the tangent plane and about the normal:
//
//     t . v <= mu F D(v)  for all v = (v_u, v_v, w)                                     (seed 4.51, 4.67b)
//
//     frictionless   D = 0
//     point          D = |(v_u, v_v)|                        |R| <= mu F, R_M = 0
//     soft elliptic  D = sqrt(v_u^2 + v_v^2 + e^2 w^2)       R^2 + (R_M / e)^2 <= (mu F)^2
//     soft linear    D = max(|(v_u, v_v)|, e |w|)            |R| + |R_M| / e <= mu F
//     patch          D of the patch (friction/patch.h)       its exact limit surface, g(t) <= mu F
//
// The soft models need a length e: D(0, 0, 1) of the patch that they stand for, 3 pi a / 16 for a Hertz disc, 2 a / 3
// under uniform pressure, pi a / 4 for a flat punch. For pressures symmetric about their centre the linear model then
// lies inside the exact cone; the elliptic one promises too much.
//
// Units    e [m]; mu [-].
// Throws   std::invalid_argument unless mu >= 0 is finite, e is positive and finite, and the patch bears a moment about
//          itself (a single point load is `point`).
#pragma once

#include <memory>

#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>

namespace patchgrip::grasp {

class FrictionCone {
 public:
  enum class Model { frictionless, point, soft_elliptic, soft_linear, patch };

  static FrictionCone frictionless();
  static FrictionCone point(double mu);
  static FrictionCone soft_elliptic(double mu, double e);
  static FrictionCone soft_linear(double mu, double e);
  static FrictionCone patch(double mu, friction::AnyPatch patch);

  // The same with another coefficient; a frictionless contact stays one.
  FrictionCone with_mu(double mu) const;

  Model model() const noexcept { return model_; }
  bool has_friction() const noexcept { return mu_ > 0; }
  double mu() const noexcept { return mu_; }

  // D(0, 0, 1) about the contact point [m]; 0 where no moment is borne.
  double moment_length() const noexcept { return e_; }

  // Of the model `patch` only.
  const friction::LimitSurface<friction::AnyPatch>& surface() const noexcept { return *surface_; }

 private:
  FrictionCone(Model model, double mu, double e) : model_(model), mu_(mu), e_(e) {}

  Model model_;
  double mu_;
  double e_;
  std::shared_ptr<const friction::LimitSurface<friction::AnyPatch>> surface_;
};

}  // namespace patchgrip::grasp
