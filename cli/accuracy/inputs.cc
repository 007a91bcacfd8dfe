#include <patchgrip/cli/accuracy/inputs.h>

namespace patchgrip::cli {

double distance(std::span<const double> value, std::span<const double> effect, std::span<const Exact> reference,
                const Exact& scale) {
  Exact sum = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!std::isfinite(value[i]) || !std::isfinite(effect[i])) return std::numeric_limits<double>::infinity();
    const Exact difference = Exact(value[i]) + effect[i] - reference[i];
    sum += difference * difference;
  }
  return sum == 0 ? 0 : static_cast<double>(sqrt(sum) / scale);
}

}  // namespace patchgrip::cli
