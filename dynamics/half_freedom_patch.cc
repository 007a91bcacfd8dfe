#include <patchgrip/dynamics/half_freedom_patch.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

namespace patchgrip::dynamics {

double least_damping(const friction::Law& law, double normal_force) noexcept {
  return std::sqrt(2 / std::numbers::e) * (law.mu_static - law.mu_kinetic) * normal_force / law.stribeck_velocity;
}

void HalfFreedomParameters::check(const friction::PressureMoments& s, const friction::Law& law,
                                  double normal_force) const {
  const char* const axes[] = {"x", "y", "turn"};
  for (int i = 0; i < 3; ++i) {
    const std::string axis = axes[i];
    contact::require_positive("stiffness " + axis, stiffness[i]);
    contact::require_positive("damping " + axis, damping[i]);
  }
  contact::require_in("mu_static", law.mu_static, law.mu_kinetic, std::numeric_limits<double>::max());
  Matrix3 Q;
  Q << 1, 0, -s.y, 0, 1, s.x, -s.y, s.x, s.polar + s.x * s.x + s.y * s.y;
  const Vector3 root = damping.cwiseSqrt().cwiseInverse();
  const Matrix3 share = root.asDiagonal() * Q * root.asDiagonal();
  const double least = least_damping(law, normal_force);
  const double largest = Eigen::SelfAdjointEigenSolver<Matrix3>(share, Eigen::EigenvaluesOnly).eigenvalues()[2];
  if (least * largest < 1) return;
  std::ostringstream text;
  text << "damping is not allowed: must be more than " << least * largest << " times as strong, or the patch jumps"
       << " where friction falls with speed by " << least << " N s/m";
  throw std::invalid_argument(text.str());
}

friction::Wrench zone_wrench(const Vector3& kappa, const Vector3& s) noexcept {
  return {s[0], s[1], s[2] - kappa[1] * s[0] + kappa[0] * s[1]};
}

Matrix3 zone_damping(const Vector3& kappa, const Vector3& damping) {
  Matrix3 inverse = Matrix3::Identity();  // U^-1
  inverse(0, 2) = -kappa[1];
  inverse(1, 2) = kappa[0];
  return inverse.transpose() * damping.asDiagonal() * inverse;
}

}  // namespace patchgrip::dynamics
