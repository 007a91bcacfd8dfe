#include <patchgrip/grasp/friction_cone.h>

#include <utility>

#include <patchgrip/contact/require.h>

namespace patchgrip::grasp {

using contact::require_non_negative;
using contact::require_positive;

FrictionCone FrictionCone::frictionless() { return {Model::frictionless, 0, 0}; }

FrictionCone FrictionCone::point(double mu) { return {Model::point, require_non_negative("mu", mu), 0}; }

FrictionCone FrictionCone::soft_elliptic(double mu, double e) {
  return {Model::soft_elliptic, require_non_negative("mu", mu), require_positive("e", e)};
}

FrictionCone FrictionCone::soft_linear(double mu, double e) {
  return {Model::soft_linear, require_non_negative("mu", mu), require_positive("e", e)};
}

FrictionCone FrictionCone::patch(double mu, friction::AnyPatch patch) {
  FrictionCone cone(Model::patch, require_non_negative("mu", mu), patch.dissipation({0, 0, 1}));
  cone.surface_ = std::make_shared<const friction::LimitSurface<friction::AnyPatch>>(std::move(patch));
  return cone;
}

FrictionCone FrictionCone::with_mu(double mu) const {
  FrictionCone other = *this;
  require_non_negative("mu", mu);
  if (model_ != Model::frictionless) other.mu_ = mu;
  return other;
}

}  // namespace patchgrip::grasp
