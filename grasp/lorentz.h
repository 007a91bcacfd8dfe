// The Lorentz cone Q^d = {(x_0, x) : |x| <= x_0} and its Nesterov-Todd scaling, of one cone or of four (packs.h).
//
// With det x = x_0^2 - |x|^2, J = diag(1, -1, ..., -1) and interior points x, z the matrix
//
//     H = eta^2 (2 w w^T - J),   eta^4 = det x / det z,   w ~ x / sqrt(det x) + J z / sqrt(det z),  det w = 1
//
// maps z to x and Q to itself; H = T^2 with T u = eta (w . u, u + (u_0 + w u / (1 + w_0)) w). Products are those of the
// Jordan algebra of Q, (a, b) -> (a . b, a_0 b + b_0 a).
//
// L. Vandenberghe, "The CVXOPT linear and quadratic cone program solvers" (2010), sections 4 and 5.
//
// Error    det as (x_0 - |x|)(x_0 + |x|): x_0^2 - |x|^2 would lose all digits near the boundary.
#pragma once

#include <patchgrip/grasp/packs.h>

namespace patchgrip::grasp::lorentz {

inline constexpr double smallest = 0x1p-1022;

template <std::size_t d, class S>
PATCHGRIP_PACKED S tail_size(const Packed<d, S>& x) {
  return root(dot<1>(x, x));
}

template <std::size_t d, class S>
PATCHGRIP_PACKED S determinant(const Packed<d, S>& x) {
  const S size = tail_size(x);
  return (x[0] - size) * (x[0] + size);
}

// Inside by so much that no root is needed to see it; by more than rounding.
template <std::size_t d, class S>
PATCHGRIP_PACKED auto is_well_inside(const Packed<d, S>& x) {
  const S most = x[0] * x[0];
  return (x[0] > 0.0) & (most - dot<1>(x, x) > 1e-12 * most);
}
template <std::size_t d, class S>
PATCHGRIP_PACKED auto is_inside(const Packed<d, S>& x) {
  return x[0] - tail_size(x) > 1e-15 * x[0];
}

template <std::size_t d, class S>
PATCHGRIP_PACKED Packed<d, S> reflected(Packed<d, S> x) {
  for (std::size_t i = 1; i < d; ++i) x[i] = -x[i];
  return x;
}

template <std::size_t d, class S>
PATCHGRIP_PACKED Packed<d, S> product(const Packed<d, S>& a, const Packed<d, S>& b) {
  Packed<d, S> c;
  c[0] = dot(a, b);
  for (std::size_t i = 1; i < d; ++i) c[i] = a[0] * b[i] + b[0] * a[i];
  return c;
}

// c with product(a, c) = b.
template <std::size_t d, class S>
PATCHGRIP_PACKED Packed<d, S> quotient(const Packed<d, S>& b, const Packed<d, S>& a) {
  Packed<d, S> c;
  c[0] = (a[0] * b[0] - dot<1>(a, b)) / determinant(a);
  for (std::size_t i = 1; i < d; ++i) c[i] = (b[i] - c[0] * a[i]) / a[0];
  return c;
}

// Largest t with x + t s in the cone, x inside.
template <std::size_t d, class S>
PATCHGRIP_PACKED S step_to_boundary(const Packed<d, S>& x, const Packed<d, S>& s) {
  const S none = S{} + 0x1p1023, zero = S{};
  const S a = determinant(s), b = x[0] * s[0] - dot<1>(x, s), c = larger(determinant(x), zero);
  const S discriminant = b * b - a * c, r = root(larger(discriminant, zero));
  const S falling = c / (r - b), rising = (-b - r) / a;
  S t = none;
  t = a < 0.0 ? (b < 0.0 ? falling : rising) : t;
  t = a < 0.0 ? t : (discriminant >= 0.0 ? (b < 0.0 ? falling : none) : none);
  const S apex = s[0] < 0.0 ? -x[0] / s[0] : none;
  return smaller(t, apex);
}

template <std::size_t d, class S>
struct alignas(sizeof(S)) Scaling {
  Packed<d, S> w;
  S eta2, eta;  // eta^2

  // x and z inside the cone.
  PATCHGRIP_PACKED void set(const Packed<d, S>& x, const Packed<d, S>& z) {
    const S least = S{} + smallest;
    const S dx = root(larger(determinant(x), least)), dz = root(larger(determinant(z), least));
    const S of_x = 1.0 / dx, of_z = 1.0 / dz;
    const Packed<d, S> a = of_x * x, b = of_z * z;
    w = S(1.0 / root(S(2.0 * (1.0 + dot(a, b))))) * (a + reflected(b));
    eta2 = dx * of_z;
    eta = root(eta2);
  }

  PATCHGRIP_PACKED Packed<d, S> H(const Packed<d, S>& u) const {
    return eta2 * (S(2.0 * dot(w, u)) * w - reflected(u));
  }
  PATCHGRIP_PACKED Packed<d, S> T(const Packed<d, S>& u) const { return eta * applied(w, u); }
  PATCHGRIP_PACKED Packed<d, S> inverse_T(const Packed<d, S>& u) const {
    return S(1.0 / eta) * applied(reflected(w), u);
  }

 private:
  PATCHGRIP_PACKED static Packed<d, S> applied(const Packed<d, S>& a, const Packed<d, S>& u) {
    const S q = dot<1>(a, u);
    const S k = u[0] + q / (1.0 + a[0]);
    Packed<d, S> r;
    r[0] = a[0] * u[0] + q;
    for (std::size_t i = 1; i < d; ++i) r[i] = u[i] + k * a[i];
    return r;
  }
};

}  // namespace patchgrip::grasp::lorentz
