#include <patchgrip/verification/claims/shear.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>

#include <patchgrip/friction/hertz_disc.h>

namespace patchgrip::verification {
namespace {

constexpr double mu = 0.5;
constexpr double load = 2 * std::numbers::pi / 3;  // F [N]

// beta of the stuck circle c, for G = a = p_0 = 1.
double turn_of(double c) {
  const double k = std::sqrt((1 - c) * (1 + c));
  return mu / 2 * (boost::math::ellint_1(k) - boost::math::ellint_2(k));
}

double lubkin_moment(double turn) {
  std::uintmax_t most = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      [&](double c) { return turn_of(c) - turn; }, 1e-7, 1 - 1e-12, boost::math::tools::eps_tolerance<double>(), most);
  const double c = std::midpoint(low, high);
  boost::math::quadrature::tanh_sinh<double> rule;
  return 16. / 3 * (c * c * c * turn + 3 * rule.integrate([](double t) { return t * t * turn_of(t); }, c, 1.));
}

}  // namespace

Torsion torsion() {
  std::vector<double> turns, moments;
  const double most = mu * load * friction::HertzDisc::of_radius(1).gradient({0, 0, 1}).m;
  for (const double share : {0.25, 0.5, 0.75, 1., 2.}) {
    turns.push_back(share * mu);
    moments.push_back(lubkin_moment(turns.back()));
  }
  return {mu,
          turns,
          {{"moment", "N m", moments, most, 1e-3, "of the sliding moment; the circle that sticks ends within elements"},
           {"moment of the rigid patch", "N m", std::vector<double>(turns.size(), most), most, 0,
            "a patch without elasticity slides at once", Claim::differs}}};
}

Shear shear() {
  const double whole = 3 * mu * load * 2 / 16;  // d at gross slip
  std::vector<double> forces, shifts;
  for (const double share : {0.25, 0.5, 0.75, 0.9}) {
    forces.push_back(share * mu * load);
    shifts.push_back(whole * (1 - std::cbrt((1 - share) * (1 - share))));
  }
  return {mu,
          forces,
          {{"displacement", "m", shifts, whole, 2e-3,
            "of that at gross slip; the circle that sticks ends within elements"}}};
}

StuckCircle stuck_circle() {
  constexpr double nu = 0.49;
  return {nu,
          {number("shear stiffness", "N/m", 8 / (2 - nu), 2e-3, "tractions are infinite at the edge of what sticks"),
           number("torsional stiffness", "N m", 16. / 3, 2e-3, "as the shear stiffness")}};
}

}  // namespace patchgrip::verification
