// The integrals of ellipse_integrals.h as a table over lambda: one row of polynomials per octave of sqrt(lambda).
//
// As functions of l = sqrt(lambda) they are analytic but for l = +-i b and +-i; far away, as functions of 1/lambda, but
// for -1 and -1/b^2. On an octave of l, on [0, h] with h <= b/2, and on 1/lambda in [0, 1] these points lie where
// Chebyshev interpolation converges at least like 5.8^-degree. The exponent of l picks the row; a slender ellipse has
// log2(1/b) more of them.
//
// Error    <= 8 units of 2^-53 of each integral, evaluation included; tests/friction/ellipse_table_test.cc.
#pragma once

#include <array>
#include <vector>

#include <patchgrip/friction/kernels/ellipse_integrals.h>
#include <patchgrip/friction/kernels/pair_polynomial.h>

namespace patchgrip::friction::kernels {

class EllipseTable {
 public:
  static constexpr std::size_t terms = 23;

  explicit EllipseTable(long double b2);

  struct alignas(64) Row {
    std::array<Pair, terms> u_major_mixed;
    std::array<Pair, terms> u_minor_m_pure;
    std::array<Pair, terms> m_mixed_h_pure;
    std::array<Pair, terms> h_cross_h_mixed;
  };

  struct Place {
    const Row& row;
    double t;  // in [-1, 1]
  };

  // lambda = Lambda / W2, Lambda > 0; W2 = 0 is infinity.
  Place find(double Lambda, double W2) const noexcept;

 private:
  int last_;  // row k < last_ holds l in [2^-(k+1), 2^-k), row last_ what is below, the one after it lambda >= 1
  std::vector<Row> rows_;
};

}  // namespace patchgrip::friction::kernels
