#include <patchgrip/friction/limit_surface/support_function.h>

#include <numbers>

namespace patchgrip::friction {

std::vector<Twist> half_of_all_directions(int count) {
  std::vector<Twist> result;
  result.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double w = (k + 0.5) / count, phi = 2 * std::numbers::pi * std::numbers::phi * k;
    const double speed = std::sqrt((1 - w) * (1 + w));
    result.push_back({speed * std::cos(phi), speed * std::sin(phi), w});
  }
  return result;
}

}  // namespace patchgrip::friction
