#include <patchgrip/friction/sampled/gauss_rule.h>

#include <array>

#include <boost/math/special_functions/legendre.hpp>

namespace patchgrip::friction::kernels {
namespace {

std::vector<GaussPoint> make_rule(int count) {
  std::vector<GaussPoint> points;
  for (const long double t : boost::math::legendre_p_zeros<long double>(count)) {
    const long double slope = boost::math::legendre_p_prime(count, t);
    const auto weight = static_cast<double>(2 / ((1 - t) * (1 + t) * slope * slope));
    points.push_back({static_cast<double>(t), weight});
    if (t > 0) points.push_back({static_cast<double>(-t), weight});
  }
  return points;
}

}  // namespace

const std::vector<GaussPoint>& gauss_rule(int count) {
  static const std::array<std::vector<GaussPoint>, most_gauss_points> rules = [] {
    std::array<std::vector<GaussPoint>, most_gauss_points> all;
    for (int n = 1; n <= most_gauss_points; ++n) all[static_cast<std::size_t>(n - 1)] = make_rule(n);
    return all;
  }();
  return rules[static_cast<std::size_t>(count - 1)];
}

}  // namespace patchgrip::friction::kernels
