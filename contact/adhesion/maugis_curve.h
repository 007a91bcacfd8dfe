// Equilibria of the Maugis-Dugdale model in dimensionless form, along the width of the zone of attraction.
//
// With n = m - 1 = c/a - 1, s = sqrt(m^2 - 1), t = arctan s = arccos(1/m) and H = s + m^2 t, the condition of Maugis is
// a quadratic in A = a (K / (pi w R^2))^(1/3), so the curve of equilibria is explicit in n:
//
//     (lambda A^2 / 2) G_1 + (4 lambda^2 A / 3) G_2 = 1,   G_1 = s + (m^2 - 2) t = (s - t) + s^2 t,   G_2 = s t - n
//     F / (pi w R) = A^3 - lambda A^2 H,   delta (K^2 / (pi^2 w^2 R))^(1/3) = A^2 - (4/3) lambda A s
//
// As n grows, A falls, and F falls to its least value, the pull-off, and then rises. s - t = s - arctan s comes from
// the continued fraction of the arctangent where s is small; no other difference cancels.
//
// Domain   lambda > 0, n > 0.
// Error    A <= 16 units of rounding of T, relative; F and delta as much of the larger of their two terms.
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>

#include <patchgrip/contact/falling_root.h>

namespace patchgrip::contact {

template <class T>
struct MaugisCurve {
  struct Point {
    T n;           // c/a - 1
    T A;           // dimensionless radius
    T force;       // F / (pi w R)
    T force_term;  // the larger of its terms
    T approach;    // dimensionless
    T slope;       // dF/dA, dimensionless: positive on the branch that is stable under load
  };

  Point at(const T& n) const;
  Point at_radius(const T& A) const;
  Point pull_off() const;
  // On the stable branch; `least` is pull_off().
  Point under_force(const T& force, const Point& least) const;

  T lambda;

 private:
  // Root of a function that is positive for n below it and negative above, in ln n.
  template <class F>
  T root_in_log(const F& f, T below, T above) const;
};

// s - arctan s = s v / (1 + v),  v = s^2 / (3 + 4 s^2 / (5 + 9 s^2 / (7 + ...)))
template <class T>
T excess_over_arctangent(const T& s, const T& arctangent) {
  if (s > T(1) / 4) return s - arctangent;
  const T s2 = s * s;
  T tail = 0;
  const int levels = std::numeric_limits<T>::digits10 * 2 / 3;
  for (int i = levels; i >= 1; --i) tail = (i + 1) * (i + 1) * s2 / (2 * i + 3 + tail);
  const T v = s2 / (3 + tail);
  return s * v / (1 + v);
}

template <class T>
typename MaugisCurve<T>::Point MaugisCurve<T>::at(const T& n) const {
  using std::atan;
  using std::sqrt;
  const T m = 1 + n;
  const T s = sqrt(n * (n + 2));
  const T t = atan(s);
  const T excess = excess_over_arctangent(s, t);
  const T C = lambda / 2 * (excess + s * s * t);  // C A^2 + B A = 1
  const T B = 4 * lambda * lambda / 3 * (s * t - n);
  const T A = 2 / (B + sqrt(B * B + 4 * C));
  const T H = s + m * m * t;

  const T tension = lambda * A * A * H;

  // dF/dA from the derivatives of both equations in A and c; what is large in them has been taken out by hand.
  const T widening = lambda * A * (s / m + m * t) + 4 * lambda * lambda / 3 * (m * t / s + 1 / m - 1);
  const T falling =
      lambda * A * (2 * m * s * t * t + (s * s * t - excess) / m) + 4 * lambda * lambda / 3 * (n / m + m * t * t);
  const T slope = A * (3 * A - 2 * lambda / s * falling / widening);
  return {n, A, A * A * A - tension, A * A * A > tension ? A * A * A : tension, A * A - 4 * lambda * A * s / 3, slope};
}

template <class T>
template <class F>
T MaugisCurve<T>::root_in_log(const F& f, T below, T above) const {
  using std::abs;
  using std::exp;
  using std::log;
  for (T factor = 4; !(f(below) > 0); factor *= factor) {
    below /= factor;
    if (below == 0) throw std::runtime_error("maugis_dugdale: no bracket below n = 0");
  }
  for (T factor = 4; !(f(above) < 0); factor *= factor) {
    above *= factor;
    if (above > std::numeric_limits<T>::max() / 2) throw std::runtime_error("maugis_dugdale: no bracket above");
  }
  return exp(falling_root<T>([&](const T& x) -> T { return f(exp(x)); }, log(below), log(above)));
}

template <class T>
typename MaugisCurve<T>::Point MaugisCurve<T>::at_radius(const T& A) const {
  using std::log;
  const T start = 1 / (lambda * lambda * A) + 1 / A;
  return at(root_in_log([&](const T& n) { return log(at(n).A / A); }, start, start));
}

template <class T>
typename MaugisCurve<T>::Point MaugisCurve<T>::pull_off() const {
  using std::sqrt;
  // Leading orders for large and for small lambda: m = 0.66 / lambda^2 + 1 and 0.56 / lambda^(3/2).
  const T start = 0.66 / (lambda * lambda) + 0.56 / (lambda * sqrt(lambda));
  return at(root_in_log([&](const T& n) { return at(n).slope; }, start, start));
}

template <class T>
typename MaugisCurve<T>::Point MaugisCurve<T>::under_force(const T& force, const Point& least) const {
  if (!(force > least.force)) return least;
  return at(root_in_log([&](const T& n) { return at(n).force - force; }, least.n, least.n));
}

}  // namespace patchgrip::contact
