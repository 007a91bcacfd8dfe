#include <patchgrip/contact/fingertip/xydas_kao.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <numbers>

#include <boost/math/special_functions/gamma.hpp>

namespace patchgrip::contact {
namespace {

using Real = long double;

}  // namespace

XydasKaoPressure XydasKaoPressure::of(double normal_force, double contact_radius, double alpha) {
  const Real force = require_positive("normal_force", normal_force);
  const Real a = require_positive("contact_radius", contact_radius);
  const Real step = 1 / Real(require_in("alpha", alpha, 0.5, 1e6));
  const Real factor =
      boost::math::tgamma(1 + 3 * step) / (boost::math::tgamma(1 + step) * boost::math::tgamma(1 + 2 * step));
  const Real peak = force / (std::numbers::pi_v<Real> * a * a) * factor;
  return {contact_radius, alpha, require_representable("peak_pressure", static_cast<double>(peak))};
}

double XydasKaoPressure::pressure(double r) const {
  require_non_negative("r", r);
  if (r >= contact_radius) return 0;
  // 1 - (r/a)^alpha from the distance to the rim, which is right where it is small.
  const Real inwards = (Real(contact_radius) - r) / contact_radius;
  const Real level = -std::expm1(alpha * std::log1p(-inwards));
  return static_cast<double>(peak_pressure * std::pow(level, 1 / Real(alpha)));
}

}  // namespace patchgrip::contact
