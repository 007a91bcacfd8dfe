#include <patchgrip/contact/principal_curvatures.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <limits>

namespace patchgrip::contact {
namespace {

using Real = long double;
using Wide = std::array<Real, 3>;

struct ShapeOperator {
  Real h11, h12, h22;
  Real det;  // h11 h22 - h12^2, without its cancellation
};

PrincipalCurvatures principal(const ShapeOperator& h, const Wide& first, const Wide& second, const Wide& normal) {
  const Real sum = h.h11 + h.h22;
  const Real difference = std::hypot(h.h11 - h.h22, 2 * h.h12);
  const Real larger = (sum < 0 ? sum - difference : sum + difference) / 2;
  const Real other = larger == 0 ? 0 : h.det / larger;
  const Real angle = std::atan2(2 * h.h12, h.h11 - h.h22) / 2;
  const Real c = std::cos(angle), s = std::sin(angle);
  PrincipalCurvatures k{
      static_cast<double>(sum < 0 ? other : larger), static_cast<double>(sum < 0 ? larger : other), {}, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    k.direction_of_k_max[i] = static_cast<double>(c * first[i] + s * second[i]);
    k.direction_of_k_min[i] = static_cast<double>(c * second[i] - s * first[i]);
    k.normal[i] = static_cast<double>(normal[i]);
  }
  return k;
}

// a d - b c with the rounding of the products undone (Kahan).
Real determinant(Real a, Real b, Real c, Real d) {
  const Real product = b * c;
  return std::fma(a, d, -product) + std::fma(-b, c, product);
}

double radius(double curvature) { return curvature == 0 ? std::numeric_limits<double>::infinity() : 1 / curvature; }

}  // namespace

PrincipalRadii PrincipalCurvatures::radii() const { return {radius(k_max), radius(k_min)}; }

PrincipalCurvatures curvatures_of_graph(double fx, double fy, double fxx, double fxy, double fyy) {
  require_finite("fx", fx);
  require_finite("fy", fy);
  require_finite("fxx", fxx);
  require_finite("fxy", fxy);
  require_finite("fyy", fyy);
  const Real slope = std::hypot(Real(fx), Real(fy));
  const Real c = slope > 0 ? fx / slope : 1, s = slope > 0 ? fy / slope : 0;
  const Real W = 1 + slope * slope, root = std::sqrt(W);
  const Real along = c * c * fxx + 2 * c * s * fxy + s * s * fyy;
  const Real mixed = c * s * (Real(fyy) - fxx) + (c - s) * (c + s) * fxy;
  const Real across = s * s * fxx - 2 * c * s * fxy + c * c * fyy;
  return principal({along / (W * root), mixed / W, across / root, determinant(fxx, fxy, fxy, fyy) / (W * W)},
                   {c / root, s / root, slope / root}, {-s, c, 0}, {-fx / root, -fy / root, 1 / root});
}

Ellipsoid Ellipsoid::of_axes(double ax, double ay, double az) {
  return {require_positive("ax", ax), require_positive("ay", ay), require_positive("az", az)};
}

Vector Ellipsoid::point(double u, double v) const {
  const Real cv = std::cos(Real(require_finite("v", v))), sv = std::sin(Real(v));
  const Real cu = std::cos(Real(require_finite("u", u))), su = std::sin(Real(u));
  return {static_cast<double>(ax * cv * cu), static_cast<double>(ay * cv * su), static_cast<double>(az * sv)};
}

PrincipalCurvatures Ellipsoid::curvatures(double u, double v) const {
  const Real cv = std::cos(Real(require_finite("v", v))), sv = std::sin(Real(v));
  const Real cu = std::cos(Real(require_finite("u", u))), su = std::sin(Real(u));
  const Wide gradient{cv * cu / ax, cv * su / ay, sv / az};  // Q x
  const Real size = std::hypot(gradient[0], gradient[1], gradient[2]);
  const Wide n{gradient[0] / size, gradient[1] / size, gradient[2] / size};

  // A basis of the tangent plane: the horizontal tangent, and what is perpendicular to it.
  const Real level = std::hypot(n[0], n[1]);
  const Real c = level > 0 ? n[0] / level : 1, s = level > 0 ? n[1] / level : 0;
  const Wide first{-s, c, 0}, second{-n[2] * c, -n[2] * s, level};
  const Wide Q{1 / (Real(ax) * ax), 1 / (Real(ay) * ay), 1 / (Real(az) * az)};
  const auto product = [&](const Wide& p, const Wide& q) {
    return (Q[0] * p[0] * q[0] + Q[1] * p[1] * q[1] + Q[2] * p[2] * q[2]) / size;
  };
  const Real root_of_det = 1 / (Real(ax) * ay * az * size * size);
  return principal({product(first, first), product(first, second), product(second, second), root_of_det * root_of_det},
                   first, second, n);
}

}  // namespace patchgrip::contact
