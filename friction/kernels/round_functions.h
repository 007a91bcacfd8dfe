// The three numbers that a round pressure needs at a pole, and their closed forms for p ~ (1 - r^2)^(n - 1/2).
//
// Unit radius, unit normal force, pole at the distance x from the centre, u = 1/x, d = 1 - x (inside) or 1 - u
// (outside). f is the force, m the moment about the centre, f' = df/dx. What is tabulated stays bounded at x = 0 and x
// = infinity:
//
//     inside:   f / x,  m,      f'
//     outside:  f,      m / u,  f' / u^3
//
// For the family, z = x^2 or u^2, c = n + 3/2 and B = Beta(1/2, n + 1):
//
//     f/x = (pi / 2B) 2F1(-n, 1/2; 2; z)          f     = 2F1(-1/2, 1/2; c; z)
//     m   = (pi / 2(n+1)B) 2F1(-n-1, 1/2; 1; z)   m/u   = (1 / 2c) 2F1(1/2, 1/2; c + 1; z)
//     f'  = (pi / 2B) 2F1(-n, 3/2; 2; z)          f'/u^3 = (1 / 2c) 2F1(1/2, 3/2; c + 1; z)
//
// They follow from the projection q(s) ~ (1 - s^2)^n of the pressure, f/x = 2 int q(x cos t) sin^2 t dt and alike
// (Radon form of |P - M|): every integrand is positive, so nothing cancels at any pole. n = -1/2 ring, 0 flat punch,
// 1/2 uniform, 1 Hertz. f' is infinite at x = 1 for n = -1/2.
#pragma once

#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/beta.hpp>

#include <patchgrip/friction/kernels/hypergeometric.h>

namespace patchgrip::friction::kernels {

template <class Real>
struct RoundValues {
  Real force;
  Real moment;
  Real slope;
};

template <class Real>
class PowerFamily {
 public:
  explicit PowerFamily(const Real& n)
      : scale_(boost::math::constants::half_pi<Real>() / boost::math::beta(Real(0.5), n + 1)),
        n_(n),
        force_in_(-n, half(), 2, levels),
        moment_in_(-n - 1, half(), 1, levels),
        slope_in_(-n, 3 * half(), 2, levels),
        force_out_(-half(), half(), n + 3 * half(), levels),
        moment_out_(half(), half(), n + 5 * half(), levels),
        slope_out_(half(), 3 * half(), n + 5 * half(), levels) {}

  RoundValues<Real> inside(const Real& d) const {
    const Real w = d * (2 - d);
    return {scale_ * force_in_.at_complement(w), scale_ / (n_ + 1) * moment_in_.at_complement(w),
            scale_ * slope_in_.at_complement(w)};
  }

  RoundValues<Real> outside(const Real& d) const {
    const Real w = d * (2 - d);
    const Real twice_c = 2 * n_ + 3;
    return {force_out_.at_complement(w), moment_out_.at_complement(w) / twice_c, slope_out_.at_complement(w) / twice_c};
  }

  // f' at the rim: Gauss's theorem for 2F1(1/2, 3/2; c + 1; 1) / (2 c).
  Real rim_slope() const {
    using std::tgamma;
    if (n_ <= -0.5) return std::numeric_limits<Real>::infinity();
    const Real c = n_ + 3 * half();
    return tgamma(c) * tgamma(c - 1) / (2 * tgamma(c + half()) * tgamma(c - half()));
  }

 private:
  static constexpr int levels = 72;
  static Real half() { return Real(0.5); }

  Real scale_;
  Real n_;
  Hypergeometric<Real> force_in_, moment_in_, slope_in_;
  Hypergeometric<Real> force_out_, moment_out_, slope_out_;
};

}  // namespace patchgrip::friction::kernels
