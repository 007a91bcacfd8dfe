// A wrench or twist in the plane, in axes that differ by an angle [rad].
#pragma once

#include <cmath>

#include <patchgrip/dynamics/bristle_metric.h>

namespace patchgrip::cli {

inline dynamics::Vector3 turned(const dynamics::Vector3& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
}

}  // namespace patchgrip::cli
