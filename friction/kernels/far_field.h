// Friction of any patch whose pole is far away or at infinity: a polynomial in the inverse pole.
//
// About a centre c, with v = velocity at c, V = |v|, e = (-vy, vx) / V (towards the pole for w > 0), rho the radius of
// the patch about c and A = rho w / V, the dissipation is analytic in xi = A e, the pole inverted at the circle rho:
//
//     D = V Q(xi),   Q = 1 + sum_k <(rho_P / rho)^k C_k(cos(P, e))> A^k
//     C_1(x) = -x,   C_k(x) = (1 - x^2) P'_(k-1)(x) / (k (k-1))
//
// so that it needs no pole and is regular at w = 0. Written with t = P x e, s = P . e as t^2 rho_P^(k-2) P'_(k-1)(s /
// rho_P), and with xi in the axes of the pressure's second moments, the coefficients of a slender patch do not cancel
// on its axis.
//
//     force = (v/V)(Q - 2 xi . G) + A (G_y, -G_x),   moment about c = rho e . G,   G = grad Q
//
// Domain   A <= 1 / nearest; the truncation at `degree` is then below 1e-17 of each result.
// Error    force and moment about c <= 8 u times the sizes of their terms; far_field_test.cc.
//
// A uniform patch is given by its boundary, any other as point loads that have its moments up to `degree`.
#pragma once

#include <array>
#include <vector>

#include <patchgrip/friction/kernels/pair_polynomial.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::friction::kernels {

// A point on the boundary of a uniform patch, relative to c. With weight = h ds / area (h the distance of c from the
// edge), the mean of a homogeneous term of degree k over the patch is sum weight * term / (k + 2).
struct BoundarySample {
  long double x, y;
  long double weight;
};

// A share of the normal force at a point relative to c: the mean of a term is sum share * term.
struct PointLoad {
  long double x, y;
  long double share;
};

class FarField {
 public:
  static constexpr int degree = 22;
  static constexpr double nearest = 6;  // of rho

  FarField() = default;

  // `offset` [m] is the true centroid minus c: what rounding c has left.
  FarField(const std::vector<BoundarySample>& samples, double rho, long double offset_x, long double offset_y);
  FarField(const std::vector<PointLoad>& loads, double rho, long double offset_x, long double offset_y);

  bool reaches(double V, double w) const noexcept { return V >= nearest * rho_ * (w < 0 ? -w : w); }

  // Of the twist (vx, vy, w) at c, V > 0; the moment is about c.
  double dissipation(const Twist& v) const noexcept;
  Wrench gradient(const Twist& v) const noexcept;
  BoundedWrench bounded_gradient(const Twist& v) const noexcept;
  Hessian hessian(const Twist& v) const noexcept;

 private:
  template <class Sample>
  void expand(const std::vector<Sample>& samples, long double offset_x, long double offset_y);

  struct Local;
  struct Slope;
  Local local(const Twist& v) const noexcept;
  template <bool with_terms>
  Slope slope(const Local& l) const noexcept;
  Wrench wrench(const Local& l, const Slope& s) const noexcept;

  double rho_ = 1;
  double axis_x_ = 1, axis_y_ = 0;  // first principal axis
  // Degree after degree, k = 1, 2, ...: coefficients of e_1^j e_2^(k-j), j = 0..k, as their two derivatives in
  // e_1^j e_2^(k-1-j), j = 0..k-1.
  std::array<Pair, degree*(degree + 1) / 2> derivatives_{};
};

}  // namespace patchgrip::friction::kernels
