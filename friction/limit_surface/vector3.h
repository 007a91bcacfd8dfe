// Vectors of three: twists and wrenches in one unit, spins and moments made speeds and forces by a length.
#pragma once

#include <array>

namespace patchgrip::friction {

using Vector = std::array<double, 3>;

inline double dot(const Vector& a, const Vector& b) noexcept { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Vector cross(const Vector& a, const Vector& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// a + k b
inline Vector moved(const Vector& a, double k, const Vector& b) noexcept {
  return {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]};
}

inline Vector scaled(const Vector& a, double k) noexcept { return {k * a[0], k * a[1], k * a[2]}; }

}  // namespace patchgrip::friction
