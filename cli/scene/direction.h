// A unit vector by its angle: (cos a, sin a), exact along the axes.
//
// An angle within four roundings of a multiple of pi/2 is that multiple: no double is pi/2, and its cosine, 6e-17,
// would tilt what is meant to lie on an axis.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace patchgrip::cli {

struct Direction {
  double x;
  double y;
};

inline Direction direction_at(double angle) noexcept {
  constexpr std::array<Direction, 4> axes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  int quarters = 0;
  const double rest = std::remquo(angle, std::numbers::pi / 2, &quarters);
  if (std::fabs(rest) <= 0x1p-51 * std::fabs(angle)) return axes[static_cast<unsigned>(quarters) % 4];
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace patchgrip::cli
