#include <patchgrip/dynamics/point_law.h>

#include <cmath>

namespace patchgrip::dynamics {
namespace {

double against(double size, double v) noexcept { return v == 0 ? 0 : std::copysign(size, -v); }

// (mu_s - mu_k) exp(-v^2 / v_S^2)
double excess(const Law& law, double v) noexcept {
  const double u = v / law.stribeck_velocity;
  return (law.mu_static - law.mu_kinetic) * std::exp(-u * u);
}

}  // namespace

double coulomb_force(const Law& law, double normal_force, double v) noexcept {
  return against(law.mu_kinetic * normal_force, v);
}

double stribeck_force(const Law& law, double normal_force, double v) noexcept {
  return against((law.mu_kinetic + excess(law, v)) * normal_force, v);
}

double viscous_force(const Law& law, double normal_force, double v) noexcept {
  return -law.mu_viscous * normal_force * v;
}

double friction_slope(const Law& law, double normal_force, double v) noexcept {
  const double u = std::fabs(v) / law.stribeck_velocity;
  return (2 * u / law.stribeck_velocity * excess(law, v) - law.mu_viscous) * normal_force;
}

double tanh_force(const Law& law, double normal_force, double a, double v) noexcept {
  return std::tanh(a * std::fabs(v)) * stribeck_force(law, normal_force, v);
}

double karnopp_force(const Law& law, double normal_force, double dead_band, double load, double v) noexcept {
  if (std::fabs(v) <= dead_band && std::fabs(load) <= law.mu_static * normal_force) return -load;
  return coulomb_force(law, normal_force, v);
}

}  // namespace patchgrip::dynamics
