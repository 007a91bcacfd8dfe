// The integrals over confocal ellipses that friction of a Hertz ellipse consists of.
//
// In units of the major semi-axis, b = minor / major; lambda >= 0 is the confocal ellipse through the pole, 0 for the
// rim and for a pole inside. With alpha = 1 + lambda, beta = b^2 + lambda, s running from lambda to infinity, and
//
//     D = s - lambda,   P = 1/(1 + s),   Q = 1/(b^2 + s)
//
//     u_major = (3/4) alpha^(1/2) int D s^(1/2) P^(5/2) Q^(1/2) ds
//     u_mixed = (3/4) alpha^(1/2) int D s^(1/2) P^(3/2) Q^(3/2) ds
//     u_minor = (3/4) beta^(1/2)  int D s^(1/2) P^(1/2) Q^(5/2) ds
//     m_pure  = (3/16) alpha^(1/2) int D^2 s^(-1/2) P^(3/2) Q^(3/2) ds
//     m_mixed = (3/16) alpha^(1/2) int {4 (1-b^2) beta D s^(1/2) P^(3/2) Q^(5/2)
//                                       + 2 b^2 [1 + (1-b^2) Q] D^2 s^(-1/2) P^(3/2) Q^(3/2)} ds
//     h_pure  = (3/4) alpha^(3/2) int D s^(-1/2) P^(3/2) Q^(3/2) ds
//     h_cross = (3/2) alpha^(3/2) int s^(1/2) P^(3/2) Q^(3/2) ds
//     h_mixed = (3/4) alpha^(3/2) int D s^(-1/2) P^(3/2) Q^(1/2) [2 (1-b^2) s P Q + P] ds
//
// They are what integration by parts makes of
//
//     S = (3/16) {2 sqrt(lambda) - int [w^2 sqrt(s P Q) - s^(-1/2)] ds},   w = 1 - x^2 P - y^2 Q,
//
// of its gradient, its Hessian and T = S - x S_x - y S_y: no integrand changes sign, so nothing cancels, neither far
// away nor along a slender ellipse.
//
// Error    of the quadrature: < 1e-18 of each integral, whatever b and lambda.
#pragma once

#include <cmath>

namespace patchgrip::friction::kernels {

template <class Real>
struct EllipseIntegrals {
  Real u_major{0}, u_mixed{0}, u_minor{0};
  Real m_pure{0}, m_mixed{0};
  Real h_pure{0}, h_cross{0}, h_mixed{0};
};

// What a pole inside needs besides, all at lambda = 0.
template <class Real>
struct EllipseCentre {
  Real major{0};  // (3/4) int s^(1/2) P^(3/2) Q^(1/2) ds
  Real minor{0};  // (3/4) int s^(1/2) P^(1/2) Q^(3/2) ds
};

template <class Real>
struct ConfocalSample {
  Real s, D, P, Q;
  Real density;  // sqrt(s P Q) ds
};

// Trapezoidal rule in z, ln D = z + e^(z - high) - e^(low - z): between the scales e^low and e^high every decade of D
// has its points, beyond them the integrands die doubly exponentially.
template <class Real, class Visit>
void over_confocal_ellipses(const Real& lambda, const Real& b2, const Visit& visit) {
  using std::exp;
  using std::log;
  using std::sqrt;
  const Real step = Real(11) / 50;
  const Real reach = Real(22) / 5;
  const Real beta = b2 + lambda;
  const Real low = log(lambda > 0 && lambda < beta ? lambda : beta) - 1;
  const Real high = log(1 + lambda) + 1;
  const Real factor = exp(step);
  Real up = exp(low - reach - high);
  Real down = exp(reach);
  for (Real z = low - reach; z < high + reach; z += step, up *= factor, down /= factor) {
    const Real D = exp(z + up - down);
    const Real s = lambda + D;
    const Real P = 1 / (1 + s);
    const Real Q = 1 / (b2 + s);
    visit(ConfocalSample<Real>{s, D, P, Q, sqrt(s * P * Q) * D * (1 + up + down) * step});
  }
}

template <class Real>
EllipseIntegrals<Real> ellipse_integrals(const Real& lambda, const Real& b2) {
  using std::sqrt;
  const Real excess = 1 - b2;
  const Real alpha = 1 + lambda;
  const Real beta = b2 + lambda;
  EllipseIntegrals<Real> sum;
  over_confocal_ellipses(lambda, b2, [&](const ConfocalSample<Real>& at) {
    const Real first = at.density * at.D * at.P;
    const Real mixed = first * at.Q;
    const Real second = mixed * at.D / at.s;
    sum.u_major += first * at.P;
    sum.u_mixed += mixed;
    sum.u_minor += at.density * at.D * at.Q * at.Q;
    sum.m_pure += second;
    sum.m_mixed += 4 * excess * beta * mixed * at.Q + 2 * b2 * (1 + excess * at.Q) * second;
    sum.h_pure += mixed / at.s;
    sum.h_cross += at.density * at.P * at.Q;
    sum.h_mixed += first * (2 * excess * at.P * at.Q + at.P / at.s);
  });
  const Real root = sqrt(alpha);
  sum.u_major *= root * 3 / 4;
  sum.u_mixed *= root * 3 / 4;
  sum.u_minor *= sqrt(beta) * 3 / 4;
  sum.m_pure *= root * 3 / 16;
  sum.m_mixed *= root * 3 / 16;
  sum.h_pure *= alpha * root * 3 / 4;
  sum.h_cross *= alpha * root * 3 / 2;
  sum.h_mixed *= alpha * root * 3 / 4;
  return sum;
}

template <class Real>
EllipseCentre<Real> ellipse_centre(const Real& b2) {
  EllipseCentre<Real> sum;
  over_confocal_ellipses(Real(0), b2, [&](const ConfocalSample<Real>& at) {
    sum.major += at.density * at.P * 3 / 4;
    sum.minor += at.density * at.Q * 3 / 4;
  });
  return sum;
}

}  // namespace patchgrip::friction::kernels
