// Antiderivatives in 100 digits, at the very twist that the double code is given: reference of the line load.
//
// With s = vy + w x from t_0 to t_1, q = sqrt(vx^2 + s^2), A = [asinh(s / |vx|)], [.] the difference of both ends:
//
//     fx = vx A / (L w),   fy = [q] / (L w),   m = ([s q] / 2 - vx^2 A / 2 - vy [q]) / (L w^2)
//
// They cancel, 1e8 lengths away 25 digits, and share nothing with the code under test.
#pragma once

#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {

class LineReference {
 public:
  using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

  explicit LineReference(double length) : length_(length) {}

  // Not at rest.
  Wrench50 gradient(const Real50& vx, const Real50& vy, const Real50& w) const {
    if (w == 0) {
      const Real50 V = sqrt(vx * vx + vy * vy);
      return {vx / V, vy / V, 0};
    }
    const Real u(vx), y(vy), spin(w), turn = spin * length_;
    const Real t0 = y - turn / 2, t1 = y + turn / 2;
    const Real q0 = sqrt(u * u + t0 * t0), q1 = sqrt(u * u + t1 * t1);
    const Real A = u == 0 ? Real(0) : Real(asinh(t1 / abs(u)) - asinh(t0 / abs(u)));
    const Real fy = (q1 - q0) / turn;
    const Real m = ((t1 * q1 - t0 * q0) / 2 - u * u * A / 2 - y * (q1 - q0)) / (turn * spin);
    return {Real50(u * A / turn), Real50(fy), Real50(m)};
  }

  Wrench50 gradient(const Twist& v) const { return gradient(v.vx, v.vy, v.w); }

 private:
  Real length_;
};

}  // namespace patchgrip::friction
