// Radius of the contact of a soft fingertip as a power of the load, and its fit to measurements.
//
//     a = c F^gamma,   0 <= gamma <= 1/3                                                  (seed 4.3.2; Xydas, Kao 1999)
//
// Hertz has gamma = 1/3. Measured: rubber 0.25 .. 0.32, silicone 0.25, a human finger 0.11 .. 0.17 (the seed lost two
// decimal points). A material with eps^mu of stress gives 1/(2 + mu (d - 1)) for a tip r^d.
//
// A ball pressed deep needs no such material: by its shape alone (sphere.h, 1 / growth_exponent()) gamma falls from 1/3
// to 0.307, 0.236, 0.175 at a/R = 0.5, 0.8, 0.9.
//
// fit() is the least squares line of ln a on ln F, unweighted; its confidence limits are those of a normal error of ln
// a, by Student's t with n - 2 degrees of freedom; those of a radius at a force F from
//
//     var(ln a) = var(ln c) + 2 ln F cov(ln c, gamma) + ln^2 F var(gamma) = s^2 / n + (ln F - mean ln F)^2 var(gamma)
//
// Domain   fit: n >= 2 points, not all at one load; limits: n >= 3.
// Units    F [N], a [m], c [m N^-gamma], gamma, rms_log [1].
// Error    units of 2^-53: a <= 3, F <= (2 + |ln(a/c)|) / gamma, relative. fit: gamma absolute, c relative: 1.6, and
//          2^-7 times the square of the largest |ln F|, |ln a| over the range of ln F: error_units;
//          tests/contact/power_law_test.cc.
// Throws   std::invalid_argument, naming the parameter, outside the domain.
#pragma once

#include <span>

namespace patchgrip::contact {

struct MeasuredRadius {
  double normal_force;    // F [N]
  double contact_radius;  // a [m]
};

struct Limits {
  double low, high;
};

struct PowerLaw {
  static PowerLaw of(double c, double gamma);

  double contact_radius(double normal_force) const;
  double normal_force(double contact_radius) const;  // gamma > 0

  double c;      // radius at 1 N [m N^-gamma]
  double gamma;  // exponent [1]
};

struct PowerLawFit {
  static PowerLawFit to(std::span<const MeasuredRadius> points);

  // Of the stated probability that they hold the true value, e.g. 0.95; n >= 3.
  Limits gamma_limits(double confidence) const;
  Limits c_limits(double confidence) const;
  // Of the law's radius at a force > 0 [N], from the errors of ln c and gamma together [m].
  Limits radius_limits(double normal_force, double confidence) const;

  PowerLaw law;
  double rms_log;       // root mean square of the residuals of ln a [1]
  double gamma_spread;  // standard error of gamma [1]
  double log_c_spread;  // standard error of ln c [1]
  double mean_log;      // of ln F, where errors of ln c and gamma are least together: cov = -mean_log gamma_spread^2
  double mean_spread;   // standard error of ln a there [1]
  int points;           // n
  double log_range;     // of ln F over the points [1]
  double error_units;   // bound of the errors of gamma, absolute, and of c, relative, in units of 2^-53
};

}  // namespace patchgrip::contact
