// Complete elliptic integrals of a Hertz ellipse, from the ratio of its semi-axes k = b / a, e^2 = 1 - k^2.
//
//     K = RF(0, k^2, 1),   D = (K - E) / e^2 = RD(0, k^2, 1) / 3,   B = (E - k^2 K) / e^2 = k^2 RD(0, 1, k^2) / 3
//
// (Carlson's forms, DLMF 19.25; K = B + D). With the arithmetic-geometric mean of 1 and k (DLMF 19.8) all three follow
// from one loop of positive terms:
//
//     K = pi / (2 M),   T = sum_{n >= 1} 2^(n-1) c_n^2 / e^4,   D = K (1/2 + e^2 T),   B = K (1/2 - e^2 T)
//
// so that nothing is 0/0 for a circle. B is a difference that loses a factor K ~ ln(4/k) to rounding, no more.
//
// Domain   0 < k <= 1; 1 - k is an argument of its own: it has to be right where k rounds to 1.
// Error    a few units of rounding of T; B: times K.
#pragma once

#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>

namespace patchgrip::contact {

template <class T>
struct CompleteElliptic {
  T K, B, D;  // K [1], B [1], D [1]
  T excess;   // (D - B) / (2 K e^2) [1]: 1/16 for a circle, 1/2 for a line

  static CompleteElliptic of_axes(const T& k, const T& one_minus_k) {
    using std::sqrt;
    const T e2 = one_minus_k * (1 + k);
    T mean = (1 + k) / 2;
    T geometric = sqrt(k);
    T c2 = one_minus_k * one_minus_k / 4;  // c_n^2
    T term = 1 / (4 * (1 + k) * (1 + k));  // 2^(n-1) c_n^2 / e^4
    T sum = term;
    while (c2 > std::numeric_limits<T>::epsilon() * mean * mean) {
      const T next = (mean + geometric) / 2;
      geometric = sqrt(mean * geometric);
      const T shrink = c2 / (16 * next * next);
      mean = next;
      term *= 2 * shrink;
      sum += term;
      c2 *= shrink;
    }
    // What is left of the mean after the last c_n is c_(n+1)^2 / 4 of it, far below rounding.
    mean = (mean + geometric) / 2;
    const T K = boost::math::constants::half_pi<T>() / mean;
    return {K, K * (T(1) / 2 - e2 * sum), K * (T(1) / 2 + e2 * sum), sum};
  }
};

}  // namespace patchgrip::contact
