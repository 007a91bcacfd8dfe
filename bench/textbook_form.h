// The closed form of the Hertz disc as one writes it down, with asin: what the library's polynomials stand against.
//
//     x <= 1:  f = (3 pi/8)(x - x^3/4),                  m / a = (3 pi/16)(1 - x^2 + 3 x^4/8)
//     x >= 1:  f = (3/16) [x (4 - x^2) asin u + (x^2 + 2) sqrt(x^2 - 1) / x]
//              m / a = (3/64) [(8 - 8 x^2 + 3 x^4) asin u + (6 - 3 x^2) sqrt(x^2 - 1)],       u = 1/x = a / r_M
//
// Fails    far away: terms of size x^4 cancel to a moment of size 1/x.
#pragma once

#include <cmath>
#include <numbers>

#include <patchgrip/friction/twist.h>

namespace patchgrip::bench {

struct TextbookForm {
  double radius;  // a [m]

  friction::Wrench gradient(const friction::Twist& v) const noexcept {
    const double V = std::sqrt(v.vx * v.vx + v.vy * v.vy);
    const double x = V / (radius * std::fabs(v.w));
    const double x2 = x * x;
    double f, m;
    if (x <= 1) {
      f = 3 * std::numbers::pi / 8 * x * (1 - x2 / 4);
      m = 3 * std::numbers::pi / 16 * (1 - x2 + 0.375 * x2 * x2);
    } else {
      const double angle = std::asin(1 / x);
      const double root = std::sqrt(x2 - 1);
      f = 3.0 / 16 * (x * (4 - x2) * angle + (x2 + 2) * root / x);
      m = 3.0 / 64 * ((8 - 8 * x2 + 3 * x2 * x2) * angle + (6 - 3 * x2) * root);
    }
    const double k = V > 0 ? f / V : 0;
    return {k * v.vx, k * v.vy, std::copysign(radius * m, v.w)};
  }
};

}  // namespace patchgrip::bench
