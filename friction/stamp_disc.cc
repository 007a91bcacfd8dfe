#include <patchgrip/friction/stamp_disc.h>

#include <cmath>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/disc_stack.h>
#include <patchgrip/friction/kernels/power_table.h>

namespace patchgrip::friction {
namespace {

// Level q is the flat punch of radius s = (1 - q) a.
struct PunchLevels {
  const std::function<double(double)>& share_per_radius;
  double radius;
  double carried;  // what the shares add up to, for lack of digits: 1

  kernels::StackNumber conjugate(const kernels::StackNumber& number) const { return {number.complement, number.value}; }
  double share(const kernels::StackNumber&, const kernels::StackNumber& R) const {
    return radius * share_per_radius(radius * R.value) / carried;
  }
};

constexpr double polar_of_punch = 2. / 3.;  // <r^2> / a^2

}  // namespace

StampDisc StampDisc::of_punches(double radius, const std::function<double(double)>& share_per_radius, double order) {
  contact::require_positive("radius", radius);
  contact::require_in("order", order, 0.5, 1000);
  static const auto punch = kernels::power_table(0);
  const kernels::DiscStack given(PunchLevels{share_per_radius, radius, 1}, *punch);
  const double carried = static_cast<double>(given.outside(1).force);  // the pole at infinity
  constexpr double tolerance = 1e-12;
  contact::require_in("share of the normal force", carried, 1 - tolerance, 1 + tolerance);
  const kernels::DiscStack stack(PunchLevels{share_per_radius, radius, carried}, *punch);
  // The pressure has a root at the rim; at the centre f / x and m carry a singular part of order x^order.
  const kernels::RoundLevels levels{kernels::rim_levels(0.5), std::max(4, static_cast<int>(std::ceil(56 / order)))};
  auto table = std::make_shared<const kernels::RoundTable>(kernels::RoundTable::build<long double>(stack, levels));
  return {radius, stack.polar(polar_of_punch), kernels::TableKernel(std::move(table))};
}

}  // namespace patchgrip::friction
