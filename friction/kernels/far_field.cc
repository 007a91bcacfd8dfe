#include <patchgrip/friction/kernels/far_field.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::friction::kernels {
namespace {

constexpr double unit = 0x1p-53;
constexpr std::size_t size_of(int n) { return static_cast<std::size_t>(n); }
// Where the k + 1 coefficients of degree k start.
constexpr std::size_t start(int k) { return size_of((k - 1) * (k + 2) / 2); }
// Where its k pairs of derivative coefficients start.
constexpr std::size_t derivative_start(int k) { return size_of((k - 1) * k / 2); }

// A homogeneous polynomial in (e_1, e_2): coefficient j belongs to e_1^j e_2^(k-j).
using Form = std::vector<long double>;

Form times_linear(const Form& p, long double a, long double b) {  // (a e_1 + b e_2) p
  Form result(p.size() + 1);
  for (std::size_t j = 0; j < p.size(); ++j) {
    result[j + 1] += a * p[j];
    result[j] += b * p[j];
  }
  return result;
}

Form times_square(const Form& p) {  // (e_1^2 + e_2^2) p
  Form result(p.size() + 2);
  for (std::size_t j = 0; j < p.size(); ++j) {
    result[j + 2] += p[j];
    result[j] += p[j];
  }
  return result;
}

// What a term of degree k at the sample is multiplied by in the mean.
long double factor(const BoundarySample& p, int k) { return p.weight / (k + 2); }
long double factor(const PointLoad& p, int) { return p.share; }

}  // namespace

FarField::FarField(const std::vector<BoundarySample>& samples, double rho, long double offset_x, long double offset_y)
    : rho_(rho) {
  expand(samples, offset_x, offset_y);
}

FarField::FarField(const std::vector<PointLoad>& loads, double rho, long double offset_x, long double offset_y)
    : rho_(rho) {
  expand(loads, offset_x, offset_y);
}

template <class Sample>
void FarField::expand(const std::vector<Sample>& samples, long double offset_x, long double offset_y) {
  long double xx = 0, xy = 0, yy = 0;
  for (const Sample& p : samples) {
    xx += factor(p, 2) * p.x * p.x;
    xy += factor(p, 2) * p.x * p.y;
    yy += factor(p, 2) * p.y * p.y;
  }
  const long double angle = std::atan2(2 * xy, xx - yy) / 2;
  const long double c = std::cos(angle);
  const long double s = std::sin(angle);
  axis_x_ = static_cast<double>(c);
  axis_y_ = static_cast<double>(s);

  std::array<long double, start(degree + 1)> sum{};
  sum[0] = -(c * offset_y - s * offset_x) / rho_;  // C_1 = -cos: coefficient of e_2, then of e_1
  sum[1] = -(c * offset_x + s * offset_y) / rho_;
  for (const Sample& p : samples) {
    const long double x = (c * p.x + s * p.y) / rho_;
    const long double y = (c * p.y - s * p.x) / rho_;
    const long double square = x * x + y * y;
    // rho^(n-1) P'_n(s / rho), n = k - 1: (n) P'_(n+1) = (2n + 1) s P'_n - (n + 1) rho^2 P'_(n-1)
    Form previous;
    Form current{1};
    for (int k = 2; k <= degree; ++k) {
      const Form term = times_linear(times_linear(current, -y, x), -y, x);  // t^2 P', t = x e_2 - y e_1
      const long double scale = factor(p, k) / (k * (k - 1.0L));
      for (std::size_t j = 0; j < term.size(); ++j) sum[start(k) + j] += scale * term[j];
      const int n = k - 1;
      Form next = times_linear(current, x, y);
      for (long double& a : next) a *= (2 * n + 1) / static_cast<long double>(n);
      if (!previous.empty()) {
        const Form back = times_square(previous);
        for (std::size_t j = 0; j < back.size(); ++j) next[j] -= (n + 1) * square * back[j] / n;
      }
      previous = std::move(current);
      current = std::move(next);
    }
  }
  for (int k = 1; k <= degree; ++k) {
    const long double* a = &sum[start(k)];
    Pair* d = &derivatives_[derivative_start(k)];
    for (int j = 0; j < k; ++j)
      d[j] = Pair{static_cast<double>((j + 1) * a[j + 1]), static_cast<double>((k - j) * a[j])};
  }
}

// The twist in the principal axes.
struct FarField::Local {
  double V, A;
  double ux, uy;  // v / V in the contact frame
  double vx, vy;  // in the principal axes
  double e1, e2;  // (-vy, vx)
  int last;       // degree that is needed
};

struct FarField::Slope {
  double Q;       // Q(xi)
  double g1, g2;  // grad Q
  double terms;   // e . grad Q with all its terms positive
  double turn;    // bound of its derivative in the direction of e
};

FarField::Local FarField::local(const Twist& v) const noexcept {
  Local l{};
  l.V = std::hypot(v.vx, v.vy);
  l.A = rho_ * v.w / l.V;
  l.ux = v.vx / l.V;
  l.uy = v.vy / l.V;
  l.vx = axis_x_ * l.ux + axis_y_ * l.uy;
  l.vy = axis_x_ * l.uy - axis_y_ * l.ux;
  l.e1 = -l.vy;
  l.e2 = l.vx;
  // A^k < 1e-17 of the leading term of the moment, A^2.
  const double size = std::fabs(l.A);
  l.last = size > 1e-9 ? std::min(degree, 3 + static_cast<int>(39.2 / -std::log(size))) : 3;
  return l;
}

template <bool with_terms>
FarField::Slope FarField::slope(const Local& l) const noexcept {
  std::array<double, degree> p2;  // powers of e_2
  p2[0] = 1;
  for (std::size_t i = 1; i < size_of(l.last); ++i) p2[i] = p2[i - 1] * l.e2;
  Pair G{0, 0};
  double Q = 0, terms = 0, turn = 0;
  for (int k = l.last; k >= 1; --k) {
    const Pair* c = &derivatives_[derivative_start(k)];
    Pair form{0, 0};  // gradient of the form of degree k in (e_1, e_2)
    double p1 = 1;    // power of e_1
    double size = 0;
    for (std::size_t i = 0; i < size_of(k); ++i) {
      const double monomial = p1 * p2[size_of(k) - 1 - i];
      form += c[i] * monomial;
      if constexpr (with_terms) size += std::fabs(monomial) * (std::fabs(c[i][0] * l.e1) + std::fabs(c[i][1] * l.e2));
      p1 *= l.e1;
    }
    // Horner's rule in A, smallest terms first; by Euler the form itself is e . gradient / k.
    G = G * l.A + form;
    Q = Q * l.A + (l.e1 * form[0] + l.e2 * form[1]) / k;
    if constexpr (with_terms) {
      terms = terms * std::fabs(l.A) + size;
      turn = turn * std::fabs(l.A) + k * std::fabs(l.e1 * form[1] - l.e2 * form[0]);
    }
  }
  return {1 + l.A * Q, G[0], G[1], terms, turn};
}

double FarField::dissipation(const Twist& v) const noexcept {
  const Local l = local(v);
  return l.V * slope<false>(l).Q;
}

Wrench FarField::wrench(const Local& l, const Slope& s) const noexcept {
  const double radial = l.e1 * s.g1 + l.e2 * s.g2;
  const double along = s.Q - 2 * l.A * radial;
  // Force in the principal axes, then back.
  const double f1 = l.vx * along + l.A * s.g2;
  const double f2 = l.vy * along - l.A * s.g1;
  return {axis_x_ * f1 - axis_y_ * f2, axis_y_ * f1 + axis_x_ * f2, rho_ * radial};
}

Wrench FarField::gradient(const Twist& v) const noexcept {
  const Local l = local(v);
  return wrench(l, slope<false>(l));
}

BoundedWrench FarField::bounded_gradient(const Twist& v) const noexcept {
  const Local l = local(v);
  const Slope s = slope<true>(l);
  const Wrench g = wrench(l, s);
  // Neither the velocity at c nor the axes are exact: e may be turned by some units, which a slender patch feels.
  return {g, 10 * unit, unit * (8 * (rho_ * s.terms + std::fabs(g.m)) + 4 * rho_ * s.turn)};
}

Hessian FarField::hessian(const Twist& v) const noexcept {
  const Local l = local(v);
  const Slope s = slope<false>(l);
  double k11 = 0, k12 = 0, k22 = 0;  // Hess Q
  for (int k = l.last; k >= 2; --k) {
    const Pair* c = &derivatives_[derivative_start(k)];
    double h11 = 0, h12 = 0, h22 = 0;
    for (int i = 0; i < k; ++i) {
      const int j = k - 1 - i;
      if (i > 0) h11 += i * c[i][0] * std::pow(l.e1, i - 1) * std::pow(l.e2, j);
      if (i > 0) h12 += i * c[i][1] * std::pow(l.e1, i - 1) * std::pow(l.e2, j);
      if (j > 0) h22 += j * c[i][1] * std::pow(l.e1, i) * std::pow(l.e2, j - 1);
    }
    k11 = k11 * l.A + h11;
    k12 = k12 * l.A + h12;
    k22 = k22 * l.A + h22;
  }
  const double y1 = k11 * l.e1 + k12 * l.e2;  // K e
  const double y2 = k12 * l.e1 + k22 * l.e2;
  const double eKe = l.e1 * y1 + l.e2 * y2;
  const double vKe = l.vx * y1 + l.vy * y2;
  const double vKv = l.vx * (k11 * l.vx + k12 * l.vy) + l.vy * (k12 * l.vx + k22 * l.vy);
  const double eG = l.e1 * s.g1 + l.e2 * s.g2;
  const double vG = l.vx * s.g1 + l.vy * s.g2;
  // In the directions along v, across it (e) and of w. D is homogeneous: H (v, w) = 0 gives the components along v.
  const double ww = rho_ * rho_ / l.V * eKe;
  const double w_along = -rho_ * l.A / l.V * eKe;
  const double w_across = -rho_ / l.V * (vG + l.A * vKe);
  const double ratio = l.A / rho_;  // w / V
  const double along = -ratio * w_along;
  const double mixed = -ratio * w_across;
  const double across = (s.Q - 2 * l.A * eG + l.A * l.A * vKv) / l.V;
  const double ux = l.ux, uy = l.uy;
  return {along * ux * ux - 2 * mixed * ux * uy + across * uy * uy,
          (along - across) * ux * uy + mixed * (ux * ux - uy * uy),
          w_along * ux - w_across * uy,
          along * uy * uy + 2 * mixed * ux * uy + across * ux * ux,
          w_along * uy + w_across * ux,
          ww};
}

}  // namespace patchgrip::friction::kernels
