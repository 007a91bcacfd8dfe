// A round pressure as a stack of uniform discs: p(r) = int_0^1 [r < R(q)] dq, with p(0) = 1 and the level q at the
// radius R(q).
//
// With the uniform disc's f_u, m_u, f_u' (round_functions.h) and N = int_0^1 R^2 dq,
//
//     f(x) = (1/N) int R^2 f_u(x/R) dq,   m(x) = (1/N) int R^3 m_u(x/R) dq,   f'(x) = (1/N) int R f_u'(x/R) dq
//
// every integrand positive. The level whose rim passes through the pole, R = x, is a weak singularity; the integrals
// are split there and each part is done by tanh-sinh quadrature (Takahasi, Mori 1974), which takes any integrable end
// point.
//
// Here p is the pressure of Xydas and Kao, p = (1 - r^alpha)^(1/alpha): R(q) = (1 - q^alpha)^(1/alpha) is its own
// inverse.
// Error   about 1 unit of rounding of double (it inherits the uniform table's); xydas_kao_disc_test.cc.
#pragma once

#include <vector>

#include <patchgrip/friction/kernels/round_table.h>

namespace patchgrip::friction::kernels {

class XydasKaoStack {
 public:
  XydasKaoStack(double alpha, const RoundTable& uniform);

  RoundValues<long double> inside(long double d) const;
  RoundValues<long double> outside(long double d) const;
  long double rim_slope() const { return inside(0).slope; }

 private:
  struct Number {
    double value;
    double complement;  // 1 - value, to full relative precision
  };
  struct Node {
    double x;           // in (0, 1)
    double complement;  // 1 - x
    double weight;
  };

  Number conjugate(const Number& number) const;  // R(q), or q(R)

  template <class Integrand>
  RoundValues<long double> integrate(const Number& from, const Number& to, const Integrand& integrand) const;

  double alpha_;
  long double normal_force_;  // N
  const RoundTable& uniform_;
  std::vector<Node> nodes_;
};

}  // namespace patchgrip::friction::kernels
