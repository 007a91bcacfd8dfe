#include <patchgrip/friction/kernels/power_table.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::friction::kernels {

int rim_levels(double edge) noexcept {
  constexpr int most = 62;  // d below 2^-62 is not told from the rim by doubles
  const double value_levels = 56 / (edge + 2);
  const double slope_levels = 48 / std::max(edge + 1, 1e-3);
  return std::clamp(static_cast<int>(std::ceil(std::max(value_levels, slope_levels))), 2, most);
}

std::shared_ptr<const RoundTable> power_table(double n) {
  const RoundLevels levels{rim_levels(n - 0.5), n > 2 ? 4 : 3};
  return std::make_shared<const RoundTable>(RoundTable::build<long double>(PowerFamily<long double>(n), levels));
}

}  // namespace patchgrip::friction::kernels
