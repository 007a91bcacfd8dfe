// Carlson's integrals in 100 digits, at the very twist that the double code is given: reference of the Hertz ellipse.
//
// With al = a^2 + lambda, be = b^2 + lambda, lambda the confocal ellipse through the pole (0 inside), c = a^2 - b^2,
// F = 2 R_F(lambda, al, be), A = (2/3) R_D(lambda, be, al), B = (2/3) R_D(lambda, al, be), d = sqrt(lambda al be):
//
//     Pa = F - a^2 A,   Pb = F - b^2 B,   Qab = (a^2 A - b^2 B)/c,
//     Qaa = A/3 - (2/3c)(a^2 A - F/2 + d/al^2),   Qbb = B/3 + (2/3c)(b^2 B - F/2 + d/be^2)
//     S_x = (3/4) x (Pa - x^2 Qaa - y^2 Qab),     S_y = (3/4) y (Pb - x^2 Qab - y^2 Qbb)
//     S = (3/16)[4 R_G(lambda, al, be) - lambda F + 2 x^2 Pa + 2 y^2 Pb - x^4 Qaa - 2 x^2 y^2 Qab - y^4 Qbb]
//
// Neither these combinations nor a table are in the code under test. They cancel: 1e8 semi-axes away, at the aspect 1e6
// or 1 + 1e-7, some 50 digits are lost. Not for a circle.
#pragma once

#include <utility>

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {

class EllipseReference {
 public:
  using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

  EllipseReference(double a, double b) : a2_(Real(a) * a), b2_(Real(b) * b) {}

  // Not at rest.
  Wrench50 gradient(const Real50& vx, const Real50& vy, const Real50& w) const {
    if (w == 0) {
      const Real50 V = sqrt(vx * vx + vy * vy);
      return {vx / V, vy / V, 0};
    }
    const Real x = -Real(vy) / Real(w), y = Real(vx) / Real(w);
    const Real x2 = x * x, y2 = y * y;
    const Real q = a2_ + b2_ - x2 - y2;
    const Real r = a2_ * b2_ - x2 * b2_ - y2 * a2_;
    const Real lambda = r < 0 ? (sqrt(q * q - 4 * r) - q) / 2 : Real(0);
    const Real al = a2_ + lambda, be = b2_ + lambda, c = a2_ - b2_;
    const Real F = 2 * boost::math::ellint_rf(lambda, al, be);
    const Real A = 2 * boost::math::ellint_rd(lambda, be, al) / 3;
    const Real B = 2 * boost::math::ellint_rd(lambda, al, be) / 3;
    const Real G = al * F - a2_ * c * A + 2 * sqrt(lambda * be / al);  // 4 R_G (DLMF 19.21.10)
    const Real d = sqrt(lambda * al * be);
    const Real Pa = F - a2_ * A, Pb = F - b2_ * B;
    const Real Qab = (a2_ * A - b2_ * B) / c;
    const Real Qaa = A / 3 - 2 * (a2_ * A - F / 2 + d / (al * al)) / (3 * c);
    const Real Qbb = B / 3 + 2 * (b2_ * B - F / 2 + d / (be * be)) / (3 * c);
    const Real Sx = 3 * x * (Pa - x2 * Qaa - y2 * Qab) / 4;
    const Real Sy = 3 * y * (Pb - x2 * Qab - y2 * Qbb) / 4;
    const Real S =
        3 * (G - lambda * F + 2 * x2 * Pa + 2 * y2 * Pb - x2 * x2 * Qaa - 2 * x2 * y2 * Qab - y2 * y2 * Qbb) / 16;
    const int sense = w < 0 ? -1 : 1;
    return {Real50(sense * Sy), Real50(-sense * Sx), Real50(sense * (S - x * Sx - y * Sy))};
  }

  Wrench50 gradient(const Twist& v) const { return gradient(v.vx, v.vy, v.w); }

 private:
  Real a2_, b2_;
};

}  // namespace patchgrip::friction
