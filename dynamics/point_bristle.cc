#include <patchgrip/dynamics/point_bristle.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

#include <patchgrip/contact/require.h>

namespace patchgrip::dynamics {
namespace {

// c_0 kappa / S(v); 0 at rest, where it is multiplied by v = 0.
double load_share(const PointBristle& b, double friction, double kappa) noexcept {
  return friction == 0 ? 0 : b.c0 * kappa / friction;
}

bool is_pressed(const Law& law, double normal_force) noexcept { return law.mu_static * normal_force > 0; }

// dkappa/dt of a bristle that yields by `share` of v.
double yielding_rate(const Law& law, double normal_force, double v, double share) noexcept {
  return is_pressed(law, normal_force) ? -v * (1 - share) : 0;
}

}  // namespace

void PointBristle::check() const {
  contact::require_positive("c0", c0);
  contact::require_non_negative("c1", c1);
  contact::require_in("viscous_share", viscous_share, 0, 1);
  contact::require_in("elastic_share", elastic_share, 0, 1, contact::Ends::right_open);
  contact::require_positive("nu0", nu0);
}

double plastic_share(const PointBristle& bristle, double stribeck, double kappa, double v) noexcept {
  const double size = std::fabs(kappa), end = std::fabs(stribeck) / bristle.c0, start = bristle.elastic_share * end;
  if (kappa * v >= 0 || size <= start) return 0;
  if (size >= end) return 1;
  const double d = end - start, x = (size - start) / d;
  return x * x * (3 - 2 * x);
}

double dahl_rate(const PointBristle& bristle, const Law& law, double normal_force, double kappa, double v) noexcept {
  return yielding_rate(law, normal_force, v, load_share(bristle, stribeck_force(law, normal_force, v), kappa));
}

double elastoplastic_rate(const PointBristle& bristle, const Law& law, double normal_force, double kappa,
                          double v) noexcept {
  const double S = stribeck_force(law, normal_force, v);
  return yielding_rate(law, normal_force, v, plastic_share(bristle, S, kappa, v) * load_share(bristle, S, kappa));
}

double extended_rate(const PointBristle& bristle, const Law& law, double normal_force, double kappa,
                     double v) noexcept {
  const double S = stribeck_force(law, normal_force, v), beta = plastic_share(bristle, S, kappa, v);
  return yielding_rate(law, normal_force, v,
                       beta * (1 - bristle.nu0) + beta * bristle.nu0 * load_share(bristle, S, kappa));
}

double half_freedom_gain(const PointBristle& bristle, const Law& law, double normal_force, double v) noexcept {
  const double speed = std::fabs(v);
  const double friction = std::fabs(stribeck_force(law, normal_force, v) + viscous_force(law, normal_force, v));
  return friction / (speed * (bristle.c1 - friction_slope(law, normal_force, v)));
}

double half_freedom_rate(const PointBristle& bristle, const Law& law, double normal_force, double alpha, double kappa,
                         double v) noexcept {
  if (alpha == 0 || v == 0) return -v;
  const double nu = half_freedom_gain(bristle, law, normal_force, v);
  const double friction = stribeck_force(law, normal_force, v) + viscous_force(law, normal_force, v);
  return -v * (1 - alpha * (1 - nu * (1 - load_share(bristle, friction, kappa))));
}

double half_freedom_linearised_rate(const PointBristle& bristle, const Law& law, double normal_force, double kappa,
                                    double v) noexcept {
  const double size = std::fabs(bristle.c1 * v - bristle.c0 * kappa), held = law.mu_static * normal_force;
  const double alpha = size > held ? switch_ramp(size / held) : 0;
  return half_freedom_rate(bristle, law, normal_force, alpha, kappa, v);
}

double half_freedom_exact_rate(const PointBristle& bristle, const Law& law, double normal_force, double kappa,
                               double v) noexcept {
  const double pull = bristle.c1 * v - bristle.c0 * kappa, size = std::fabs(pull);
  const double held = law.mu_static * normal_force;
  if (!(size > held)) return -v;
  const auto excess = [&](double u) {
    const double dry = u > 0 ? -stribeck_force(law, normal_force, u) : held;  // at u = 0 from above
    return bristle.c1 * u + dry - viscous_force(law, normal_force, u) - size;
  };
  const double most = size / bristle.c1, at_most = excess(most);
  if (!(at_most > 0)) return std::copysign(most, pull) - v;
  std::uintmax_t steps = 100;
  const auto [lo, hi] = boost::math::tools::toms748_solve(excess, 0., most, held - size, at_most,
                                                          boost::math::tools::eps_tolerance<double>(52), steps);
  return std::copysign((lo + hi) / 2, pull) - v;
}

double boundary_layer_force(const BoundaryLayer& zone, const Law& law, double normal_force, double u) noexcept {
  return tanh_force(law, normal_force, zone.steepness, u) + viscous_force(law, normal_force, u);
}

double switch_ramp(double x) noexcept { return std::clamp((x - 1) / 0.01, 0., 1.); }

double bristle_pull(const PointBristle& bristle, double kappa, double rate) noexcept {
  return bristle.c0 * kappa + bristle.c1 * rate;
}

double bristle_force(const PointBristle& bristle, const Law& law, double normal_force, double kappa, double rate,
                     double v) noexcept {
  const double pull = is_pressed(law, normal_force) ? bristle_pull(bristle, kappa, rate) : 0;
  return pull + bristle.viscous_share * viscous_force(law, normal_force, v);
}

}  // namespace patchgrip::dynamics
