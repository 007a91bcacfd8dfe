// Indentation of a Rabotnov power-law material without creep: a model, not a solution of the half-space.
//
//     E c(mu) delta^mu = w_1 a^(mu d),   C = w_1 / (E c(mu) F_1^(mu d / (2 + mu (d - 1))))              (seed 4.28)
//     F = (delta^mu / C)^((2 + mu (d - 1)) / (mu d)),   a = delta^(1/d) C^(-1/(mu d)) F_1^(-1/(2 + mu (d - 1)))
//     gamma = 1 / (2 + mu (d - 1)):   a ~ F^gamma,   delta ~ F^(d gamma)             (Example 4.3, corrected exponents)
//
// for a profile that is homogeneous of degree d, a pressure p_1 of the zone of radius 1, F_1 = int p_1 dA and
// w_1 = int p_1 / r^(2 - mu) dA at its centre.
//
// Sure is the similarity: gamma, and how F goes with delta. Not sure is the number: 4.18 adds the point-load fields
// p / r^(2 - mu) linearly, which holds for mu = 1 alone. c(mu) is therefore an input; c(1) = pi / (1 - nu^2). A gamma
// below 1/3 at d = 2, as measured on fingers, asks for mu > 1, against the range 0 < mu <= 1 of 4.17.
//
// Domain   mu, d, w_1, F_1, c, E > 0; delta, F >= 0.
// Units    E [Pa]; delta, a [m]; F [N]; mu, d, c [1]; F_1, w_1 per 1 m of a, so [N m^(-1/gamma)], [N m^(-mu d)].
// Error    <= 8 units of 2^-53 times 1 + the exponent times |ln| of the base, relative, each;
//          tests/contact/rabotnov_test.cc.
// Throws   std::invalid_argument outside the domain, and where C overflows or underflows.
#pragma once

#include <cmath>

#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

template <class Real>
struct BasicRabotnovModel {
  static BasicRabotnovModel of(Real mu, Real degree, Real unit_displacement, Real unit_force, Real c, Real modulus) {
    const auto positive = [](const char* name, const Real& value) {
      require_positive(name, static_cast<double>(value));
    };
    positive("mu", mu);
    positive("d", degree);
    positive("w1", unit_displacement);
    positive("F1", unit_force);
    positive("c", c);
    positive("E", modulus);
    using std::pow;
    const Real gamma = 1 / (2 + mu * (degree - 1));
    require_positive("gamma", static_cast<double>(gamma));
    const Real C = unit_displacement / (modulus * c * pow(unit_force, mu * degree * gamma));
    require_representable("C", static_cast<double>(C));
    return {mu, degree, unit_force, gamma, C};
  }

  Real force(const Real& approach) const {
    using std::pow;
    return approach > 0 ? pow(pow(approach, mu) / compliance, 1 / (mu * degree * gamma)) : Real(0);
  }

  Real radius(const Real& approach) const {
    using std::pow;
    return approach > 0 ? pow(approach, 1 / degree) * pow(compliance, -1 / (mu * degree)) * pow(unit_force, -gamma)
                        : Real(0);
  }

  Real approach(const Real& force) const {
    using std::pow;
    return force > 0 ? pow(compliance * pow(force, mu * degree * gamma), 1 / mu) : Real(0);
  }

  Real mu;          // hardening exponent [1]
  Real degree;      // d of the profile [1]
  Real unit_force;  // F_1
  Real gamma;       // a ~ F^gamma
  Real compliance;  // C
};

using RabotnovModel = BasicRabotnovModel<double>;

}  // namespace patchgrip::contact
