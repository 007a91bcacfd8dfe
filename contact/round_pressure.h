// Inverse problem of a round contact: a pressure is given, sought is the stamp that makes it.
//
//     G(x) = int_x^a t p(t) / sqrt(t^2 - x^2) dt
//     u_z  = (4 / (pi E*)) int_0^min(r, a) G(x) / sqrt(r^2 - x^2) dx,   F = 2 pi int_0^a r p dr,   f = u_z(0) - u_z(r)
//
// (Abel's transform of seed 4.6; Johnson, Contact Mechanics, 3.3.) Both integrals by quadrature, nested.
//
// Domain   p integrable on [0, a], smooth in between; it may be singular at r = 0 and, like a flat punch's, at r = a.
// Units    r, a, u_z, f [m], p, E* [Pa], F [N].
// Error    comes along with every result: the quadrature's estimate (endpoint_quadrature.h). For a p that is smooth in
//          between and accurate to rounding it is below 1e-11 of the result, and true errors are far smaller; jumps and
//          kinks between 0 and a make it grow. tests/contact/round_pressure_test.cc.
// Fails    a p that is given with relative error e next to a makes errors of e, which nothing here can see.
// Throws   std::invalid_argument, naming the parameter, outside the domain; std::runtime_error where p is not a number.
#pragma once

#include <functional>

#include <patchgrip/contact/estimate.h>

namespace patchgrip::contact {

class RoundPressure {
 public:
  // pressure(r, a - r), for 0 < r < a.
  static RoundPressure of(double contact_radius, double contact_modulus,
                          std::function<double(double, double)> pressure);

  Estimate force() const;
  Estimate displacement(double r) const;  // u_z, every r
  Estimate height(double r) const;        // f, r <= a

 private:
  RoundPressure(double radius, double modulus, std::function<double(double, double)> pressure)
      : radius_(radius), modulus_(modulus), pressure_(std::move(pressure)) {}

  Estimate density(double x, double before_rim) const;  // G

  double radius_;
  double modulus_;
  std::function<double(double, double)> pressure_;
};

}  // namespace patchgrip::contact
