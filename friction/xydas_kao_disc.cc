#include <patchgrip/friction/xydas_kao_disc.h>

#include <cmath>

#include <boost/math/special_functions/beta.hpp>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/disc_stack.h>
#include <patchgrip/friction/kernels/power_table.h>

namespace patchgrip::friction {
namespace {

// The level q of p / p(0): a uniform disc of radius R = (1 - q^alpha)^(1/alpha), whose share of the force is its area.
class XydasKaoLevels {
 public:
  explicit XydasKaoLevels(double alpha)
      : alpha_(alpha),
        area_(static_cast<double>(
            2 / static_cast<long double>(alpha) *
            boost::math::beta(2 / static_cast<long double>(alpha), 1 / static_cast<long double>(alpha) + 1))) {}

  kernels::StackNumber conjugate(const kernels::StackNumber& number) const {
    // log(1 - value^alpha), from whichever of value and complement is small.
    const double log_value = number.value < 0.5 ? std::log(number.value) : std::log1p(-number.complement);
    const double power = std::exp(alpha_ * log_value);
    const double log_rest = power < 0.5 ? std::log1p(-power) : std::log(-std::expm1(alpha_ * log_value));
    return {std::exp(log_rest / alpha_), -std::expm1(log_rest / alpha_)};
  }

  double share(const kernels::StackNumber&, const kernels::StackNumber& R) const { return R.value * R.value / area_; }

 private:
  double alpha_;
  double area_;  // int_0^1 R^2 dq
};

// <r^2> / a^2 = (3/5) Gamma(4/alpha) Gamma(3/alpha) / (Gamma(5/alpha) Gamma(2/alpha))
double polar_moment(double alpha) {
  const auto g = [alpha](long double k) { return std::tgamma(k / alpha); };
  return static_cast<double>(3 * g(4) * g(3) / (5 * g(5) * g(2)));
}

}  // namespace

XydasKaoDisc XydasKaoDisc::of_radius(double radius, double alpha) {
  contact::require_positive("radius", radius);
  contact::require_in("alpha", alpha, 0.5, 50);
  static const auto uniform = kernels::power_table(0.5);
  // At the centre f / x and m carry a singular part of order x^(alpha + 1), f' one of the same order.
  const int centre = std::max(4, static_cast<int>(std::ceil(56 / (alpha + 1))));
  const kernels::RoundLevels levels{kernels::rim_levels(1 / alpha), centre};
  auto table = std::make_shared<const kernels::RoundTable>(
      kernels::RoundTable::build<long double>(kernels::DiscStack(XydasKaoLevels(alpha), *uniform), levels));
  return {radius, alpha, polar_moment(alpha), kernels::TableKernel(std::move(table))};
}

}  // namespace patchgrip::friction
