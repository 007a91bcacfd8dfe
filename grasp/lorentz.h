// The Lorentz cone Q^d = {(x_0, x) : |x| <= x_0} and its Nesterov-Todd scaling.
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

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace patchgrip::grasp::lorentz {

template <int d>
using Vector = Eigen::Matrix<double, d, 1>;

template <int d>
auto tail(const Vector<d>& x) {
  return x.template tail<d - 1>();
}

template <int d>
double least_eigenvalue(const Vector<d>& x) {
  return x[0] - tail<d>(x).norm();
}

template <int d>
double determinant(const Vector<d>& x) {
  const double size = tail<d>(x).norm();
  return (x[0] - size) * (x[0] + size);
}

// Inside by so much that no root is needed to see it.
template <int d>
bool is_well_inside(const Vector<d>& x) {
  const double most = x[0] * x[0];
  return x[0] > 0 && most - tail<d>(x).squaredNorm() > 1e-12 * most;
}

template <int d>
Vector<d> reflected(Vector<d> x) {
  x.template tail<d - 1>() *= -1;
  return x;
}

template <int d>
Vector<d> product(const Vector<d>& a, const Vector<d>& b) {
  Vector<d> c;
  c[0] = a.dot(b);
  c.template tail<d - 1>() = a[0] * tail<d>(b) + b[0] * tail<d>(a);
  return c;
}

// c with product(a, c) = b.
template <int d>
Vector<d> quotient(const Vector<d>& b, const Vector<d>& a) {
  Vector<d> c;
  c[0] = a.dot(reflected<d>(b)) / determinant<d>(a);
  c.template tail<d - 1>() = (tail<d>(b) - c[0] * tail<d>(a)) / a[0];
  return c;
}

// Largest t with x + t s in the cone, x inside.
template <int d>
double step_to_boundary(const Vector<d>& x, const Vector<d>& s) {
  const double a = determinant<d>(s);
  const double b = x.dot(reflected<d>(s));
  const double c = std::max(determinant<d>(x), 0.0);
  const double discriminant = b * b - a * c;
  double t = std::numeric_limits<double>::max();
  if (a < 0) {
    t = (-b - std::sqrt(std::max(discriminant, 0.0))) / a;
    if (b < 0) t = c / (-b + std::sqrt(std::max(discriminant, 0.0)));
  } else if (discriminant >= 0 && b < 0) {
    t = c / (-b + std::sqrt(discriminant));
  }
  if (s[0] < 0) t = std::min(t, -x[0] / s[0]);
  return t;
}

template <int d>
struct Scaling {
  Vector<d> w = Vector<d>::Unit(0);
  double eta2 = 1, eta = 1;  // eta^2

  // x and z inside the cone.
  void set(const Vector<d>& x, const Vector<d>& z) {
    const double dx = std::sqrt(std::max(determinant<d>(x), std::numeric_limits<double>::min()));
    const double dz = std::sqrt(std::max(determinant<d>(z), std::numeric_limits<double>::min()));
    const Vector<d> a = x / dx;
    const Vector<d> b = z / dz;
    w = (a + reflected<d>(b)) / std::sqrt(2 * (1 + a.dot(b)));
    eta2 = dx / dz;
    eta = std::sqrt(eta2);
  }

  Vector<d> H(const Vector<d>& u) const { return eta2 * (2 * w.dot(u) * w - reflected<d>(u)); }
  Vector<d> T(const Vector<d>& u) const { return eta * applied(w, u); }
  Vector<d> inverse_T(const Vector<d>& u) const { return applied(reflected<d>(w), u) / eta; }

 private:
  static Vector<d> applied(const Vector<d>& a, const Vector<d>& u) {
    const double q = tail<d>(a).dot(tail<d>(u));
    Vector<d> r;
    r[0] = a[0] * u[0] + q;
    r.template tail<d - 1>() = tail<d>(u) + (u[0] + q / (1 + a[0])) * tail<d>(a);
    return r;
  }
};

}  // namespace patchgrip::grasp::lorentz
