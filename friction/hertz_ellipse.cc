#include <patchgrip/friction/hertz_ellipse.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/ellipse_table.h>

namespace patchgrip::friction {
namespace {

using kernels::EllipseCentre;
using kernels::EllipseIntegrals;
using kernels::EllipseTable;
using kernels::Pair;
using kernels::polynomial;

// Squares of squares of speeds stay finite and normal in this range.
constexpr double smallest = 0x1p-200;
constexpr double largest = 0x1p200;

// The twist in the axes of the ellipse, as the pole times |w|.
struct Seen {
  Seen(double pole_x, double pole_y, double major, double w) noexcept
      : x(pole_x),
        y(pole_y),
        W(major * std::fabs(w)),
        x2(x * x),
        y2(y * y),
        W2(W * W),
        ahead(std::fma(major, std::fabs(w), -std::fabs(x)) * (W + std::fabs(x))) {}

  // False, too, if one of them is not a number.
  bool in_range() const noexcept {
    const double size = x2 + y2 + W2;
    return size > smallest && size < largest;
  }

  double x, y;  // of the pole, x along the major axis
  double W;     // major semi-axis times |w|
  double x2, y2, W2;
  double ahead;  // W^2 - x^2, on which the moment depends at the tip of a slender ellipse
};

// alpha, beta, lambda of the header times W2.
struct Confocal {
  double lambda, alpha, beta;
  double root;  // sqrt(alpha)
  double kappa, sigma;
};

// grad S and T / major semi-axis, x along the major axis.
struct Slope {
  double x, y, T;
};

// Hess S, Hess S . M and M . Hess S . M, over |w|; in units of the major semi-axis, which takes as many powers.
struct Curvature {
  double xx, xy, yy;
  double x, y;
  double M;
};

}  // namespace

struct HertzEllipse::Data {
  double b;   // minor / major
  double b2;  // b^2
  EllipseIntegrals<double> rim;
  EllipseCentre<double> centre;
  EllipseTable table;

  explicit Data(long double ratio)
      : b(static_cast<double>(ratio)), b2(static_cast<double>(ratio * ratio)), table(ratio * ratio) {
    const auto r = kernels::ellipse_integrals(0.0L, ratio * ratio);
    const auto number = [](long double value) { return static_cast<double>(value); };
    rim = {number(r.u_major), number(r.u_mixed), number(r.u_minor), number(r.m_pure),
           number(r.m_mixed), number(r.h_pure),  number(r.h_cross), number(r.h_mixed)};
    const auto c = kernels::ellipse_centre(ratio * ratio);
    centre = {number(c.major), number(c.minor)};
  }

  // W2 (1 - x^2 - y^2/b^2) b^2: positive inside.
  double depth(const Seen& v) const noexcept { return b2 * v.ahead - v.y2; }

  // The larger root of lambda^2 + q lambda + r = 0; r < 0 outside, so its square root cancels nothing.
  Confocal confocal(const Seen& v, double depth) const noexcept {
    const double q = v.ahead + (b2 * v.W2 - v.y2);
    const double r = v.W2 * depth;
    const double far = std::fabs(q) + std::sqrt(q * q - 4 * r);
    const double lambda = q > 0 ? -2 * r / far : far / 2;
    const double alpha = v.W2 + lambda;
    const double beta = b2 * v.W2 + lambda;
    return {lambda, alpha, beta, std::sqrt(alpha), v.x2 / alpha, v.y2 / beta};
  }

  Slope slope(const Seen& v) const noexcept {
    const double d = depth(v);
    if (d >= 0) return slope_inside(v, d);
    const Confocal c = confocal(v, d);
    const auto [row, t] = table.find(c.lambda, v.W2);
    const Pair u = polynomial(row.u_major_mixed, t);
    const Pair um = polynomial(row.u_minor_m_pure, t);
    const Pair m = polynomial(row.m_mixed_h_pure, t);
    const double inverse = 1 / c.root;
    return {v.x * inverse * (c.kappa * u[0] + c.sigma * u[1]),
            v.y * (c.kappa * u[1] * inverse + c.sigma * um[0] / std::sqrt(c.beta)),
            v.W * inverse * (um[1] * (b2 * c.kappa * c.kappa + c.sigma * c.sigma) + m[0] * c.kappa * c.sigma)};
  }

  Slope slope_inside(const Seen& v, double depth) const noexcept {
    const double inverse = 1 / v.W2;
    const double kappa = v.x2 * inverse;
    const double sigma = v.y2 * inverse / b2;
    const double omega = depth * inverse / b2;
    const double reciprocal = v.W * inverse;
    // With cos, sin of the lines' direction in the axes scaled to a circle, <(omega + kappa sin^2 + sigma cos^2)^2>.
    const double major = centre.major / 2;
    const double minor = b2 * centre.minor / 2;
    return {v.x * reciprocal * (kappa * rim.u_major + sigma * rim.u_mixed + omega * centre.major),
            v.y * reciprocal * (kappa * rim.u_mixed + sigma * rim.u_minor / b + omega * centre.minor),
            rim.m_pure * (b2 * kappa * kappa + sigma * sigma) + rim.m_mixed * kappa * sigma +
                omega * (major * (sigma + omega / 2) + minor * (kappa + omega / 2))};
  }

  Curvature curvature(const Seen& v) const noexcept {
    const double d = depth(v);
    if (d >= 0) return curvature_inside(v, d);
    const Confocal c = confocal(v, d);
    const auto [row, t] = table.find(c.lambda, v.W2);
    const Pair h = polynomial(row.h_cross_h_mixed, t);
    EllipseIntegrals<double> at;
    at.u_mixed = polynomial(row.u_major_mixed, t)[1];
    at.h_pure = polynomial(row.m_mixed_h_pure, t)[1];
    at.h_cross = h[0];
    at.h_mixed = h[1];
    return curvature(v, c, at);
  }

  Curvature curvature_inside(const Seen& v, double depth) const noexcept {
    const double kappa = v.x2 / v.W2;
    const double sigma = v.y2 / v.W2 / b2;
    const double omega = depth / v.W2 / b2;
    Curvature s = curvature(v, {0, v.W2, b2 * v.W2, v.W, kappa, sigma}, rim);
    s.xx += omega * centre.major / v.W;
    s.yy += omega * centre.minor / v.W;
    s.x += omega * centre.major * v.x / v.W2;
    s.y += omega * centre.minor * v.y / v.W2;
    s.M += omega * (centre.major * kappa + centre.minor * b2 * sigma) / v.W;
    return s;
  }

  Curvature curvature(const Seen& v, const Confocal& c, const EllipseIntegrals<double>& at) const noexcept {
    const double near = v.W2 / c.alpha;
    const double flat = c.beta / c.alpha;
    const double turned = at.h_mixed - (1 - b2) * at.h_cross;
    const double k = c.kappa, s = c.sigma;
    return {(b2 * k * at.h_pure * near + s * at.u_mixed) / c.root,
            -(v.x / c.root) * (v.y / c.root) * at.h_cross / c.root,
            (s * at.h_pure * near + k * at.u_mixed) / c.root,
            v.x * (v.W / c.root) * (b2 * k * at.h_pure + s * at.h_mixed) / c.alpha,
            v.y * (v.W / c.root) * (s * at.h_pure + k * turned) / c.alpha,
            ((b2 * k * k + flat * s * s) * at.h_pure + k * s * (at.h_mixed + flat * turned)) / c.root};
  }
};

namespace {

constexpr double force_error = 12 * 0x1p-53;
constexpr double moment_error = 20 * 0x1p-53;

struct Rescaled {
  Twist twist;
  double scale;  // v = scale * twist
};

// To speeds of about 1, if the twist is finite and not at rest.
Rescaled rescaled(const Twist& v, double length) noexcept {
  const double size = std::max({std::fabs(v.vx), std::fabs(v.vy), length * std::fabs(v.w)});
  if (!(size > 0) || !std::isfinite(size)) return {v, 1};
  const int e = std::ilogb(size);
  return {{std::scalbn(v.vx, -e), std::scalbn(v.vy, -e), std::scalbn(v.w, -e)}, std::scalbn(1.0, e)};
}

// In the axes of the ellipse: as it is, or turned by a right angle if the major axis is along y.
Seen seen(const Twist& v, double a, double b) noexcept {
  return b > a ? Seen(v.vx, v.vy, b, v.w) : Seen(-v.vy, v.vx, a, v.w);
}

}  // namespace

HertzEllipse HertzEllipse::of_semi_axes(double a, double b) {
  contact::require_positive("a", a);
  contact::require_positive("b", b);
  const long double ratio = a < b ? static_cast<long double>(a) / b : static_cast<long double>(b) / a;
  contact::require_in("aspect ratio of the semi-axes", static_cast<double>(1 / ratio), 1, largest_aspect);
  return {a, b, std::make_shared<const Data>(ratio)};
}

double HertzEllipse::dissipation(const Twist& v) const noexcept {
  const auto [u, scale] = rescaled(v, std::max(a_, b_));
  return scale * power(gradient(u), u);  // terms of one sign
}

Wrench HertzEllipse::gradient(const Twist& v) const noexcept {
  const Seen s = seen(v, a_, b_);
  if (!s.in_range()) [[unlikely]]
    return rescaled_gradient(v);
  const Slope g = data_->slope(s);
  if (b_ > a_) return {g.x, g.y, std::copysign(b_ * g.T, v.w)};
  return {g.y, -g.x, std::copysign(a_ * g.T, v.w)};
}

Wrench HertzEllipse::rescaled_gradient(const Twist& v) const noexcept {
  const Twist u = rescaled(v, std::max(a_, b_)).twist;
  if (u.vx == 0 && u.vy == 0 && u.w == 0) return {};
  if (seen(u, a_, b_).in_range()) return gradient(u);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, nan};
}

BoundedWrench HertzEllipse::bounded_gradient(const Twist& v) const noexcept {
  const Wrench g = gradient(v);
  return {g, force_error * std::hypot(g.fx, g.fy), moment_error * std::fabs(g.m)};
}

Hessian HertzEllipse::hessian(const Twist& v) const {
  const double major = std::max(a_, b_);
  const auto [u, scale] = rescaled(v, major);
  if (u.vx == 0 && u.vy == 0 && u.w == 0)
    throw std::domain_error("twist = 0 is not allowed: the Hessian of D exists only in motion");
  const Curvature s = data_->curvature(seen(u, a_, b_));
  // H = B Hess S B^T / |w|, B = [0 1; -1 0; -M_x -M_y].
  const double k = 1 / scale;
  const double moment = std::copysign(major, u.w) * k;
  const double spin = major * major * k * s.M;
  if (b_ > a_) return {k * s.xx, k * s.xy, moment * -s.x, k * s.yy, moment * -s.y, spin};
  return {k * s.yy, k * -s.xy, moment * -s.y, k * s.xx, moment * s.x, spin};
}

PressureMoments HertzEllipse::moments() const noexcept { return {0, 0, (a_ * a_ + b_ * b_) / 5}; }
double HertzEllipse::area_radius() const noexcept { return std::sqrt(a_) * std::sqrt(b_); }

}  // namespace patchgrip::friction
