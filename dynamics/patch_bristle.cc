#include <patchgrip/dynamics/patch_bristle.h>

#include <algorithm>
#include <string>

namespace patchgrip::dynamics {
namespace {

Matrix3 lever(const Vector3& kappa) {
  Matrix3 U = Matrix3::Identity();
  U(0, 2) = kappa[1];
  U(1, 2) = -kappa[0];
  return U;
}

double smooth_step(double x) {
  const double y = std::clamp(x, 0., 1.);
  return y * y * (3 - 2 * y);
}

}  // namespace

void PatchBristleParameters::check() const {
  const char* const axes[] = {"x", "y", "turn"};
  for (int i = 0; i < 3; ++i) {
    const std::string axis = axes[i];
    contact::require_positive("stiffness " + axis, stiffness[i]);
    contact::require_non_negative("damping " + axis, damping[i]);
    contact::require_positive("nu0 " + axis, nu0[i]);
  }
  contact::require_positive("length", length);
  contact::require_in("elastic_share", elastic_share, 0, 1, contact::Ends::open);
}

friction::Wrench spring_wrench(const PatchBristleParameters& p, const Vector3& kappa) noexcept {
  return {p.stiffness[0] * kappa[0], p.stiffness[1] * kappa[1], p.stiffness[2] * kappa[2]};
}

friction::Twist zone_twist(const Vector3& kappa, const Vector3& v) noexcept {
  return {v[0] + kappa[1] * v[2], v[1] - kappa[0] * v[2], v[2]};
}

bool relaxes(const PatchBristleParameters& p, const Vector3& kappa, const Vector3& v) noexcept {
  const Vector3 pull = p.form == BristleForm::printed ? kappa : Vector3(p.stiffness.cwiseProduct(kappa));
  return pull.dot(v) < 0 || v.isZero(0);
}

BristleRates bristle_rates(const PatchBristleParameters& p, const Vector3& kappa, const Vector3& v,
                           const friction::Wrench& stribeck, double yields) {
  const double beta = smooth_step((yields - p.elastic_share) / (1 - p.elastic_share));
  Vector3 rate = v;
  const Vector3 springs = p.stiffness.cwiseProduct(kappa), t(stribeck.fx, stribeck.fy, stribeck.m);
  if (beta > 0 && !t.isZero(0)) {
    const Matrix3 U = lever(kappa);
    const Vector3 u = U * v;
    if (p.form == BristleForm::corrected) {
      const Vector3 lengths(1, 1, p.length);
      const double r = u.cwiseProduct(lengths).norm() / t.cwiseQuotient(lengths).norm();
      const Vector3 pull = springs + U.transpose() * t;
      rate = (1 - beta) * v - beta * r * p.nu0.cwiseProduct(pull).cwiseQuotient(lengths.cwiseAbs2());
    } else {
      const Vector3 sliding = p.nu0.cwiseProduct(u) - u.norm() / t.norm() * p.nu0.cwiseProduct(springs);
      rate = (1 - beta) * v + beta * (lever(-kappa) * sliding);  // U^-1 = U(-kappa)
    }
  }
  return {rate, -(p.damping.cwiseProduct(rate) + springs), beta};
}

}  // namespace patchgrip::dynamics
