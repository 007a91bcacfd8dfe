#include <patchgrip/verification/cases/shear.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include <patchgrip/verification/claims/shear.h>
#include <patchgrip/verification/fe/half_space.h>

namespace patchgrip::verification {
namespace {

const std::string hertz_pressure = "sqrt(pos_part(1-sqr(X(1))))";

// Field v = u_theta; G = 1.
void twisting(Model& model, const Setting& setting) {
  model.field("v", 1, 2);
  model.linear("((Grad_v(1)-v/X(1))*(Grad_Test_v(1)-Test_v/X(1))+Grad_v(2)*Grad_Test_v(2))*X(1)");
  model.linear(fmt::format("{}*v*Test_v", 1e5 * setting.elements), region::axis);
  model.hold("v", region::far);
}

// Fields U = (U, W) and V; G = 1. Cerruti's displacements of a force Q along x are held far away.
void shearing(Model& model, const Setting& setting, double nu) {
  model.field("u", 2, 2);
  model.field("v", 1, 2);
  model.known("la", 2 * nu / (1 - 2 * nu));
  const std::string ring = "(u(1)+v)/X(1)", test_ring = "(Test_u(1)+Test_v)/X(1)";
  model.linear(
      fmt::format("(la*(Trace(Grad_u)+{0})*(Trace(Grad_Test_u)+{1})+2*(Sym(Grad_u):Sym(Grad_Test_u)+{0}*{1})"
                  "+(Grad_v(1)-{0})*(Grad_Test_v(1)-{1})+(Grad_v(2)-u(2)/X(1))*(Grad_Test_v(2)-Test_u(2)/X(1)))*X(1)",
                  ring, test_ring));
  model.linear(fmt::format("{}*((u(1)+v)*(Test_u(1)+Test_v)+u(2)*Test_u(2))", 1e5 * setting.elements), region::axis);
}

void hold_cerruti(Model& model, const Setting& setting, double nu, double force, bool is_first) {
  const double c = force / (4 * std::numbers::pi), far = 0.5 * setting.extent;
  const auto rho_of = [](const Point& p) { return std::hypot(p[0], p[1]); };
  model.known_field("far_u", "u", [&](const Point& p) -> Point {
    const double r = p[0], z = -p[1], rho = rho_of(p), rz = rho + z;
    if (rho < far) return {0, 0, 0};
    return {c * (1 / rho + r * r / (rho * rho * rho) + (1 - 2 * nu) * (1 / rz - r * r / (rho * rz * rz))),
            -c * r * (z / (rho * rho * rho) + (1 - 2 * nu) / (rho * rz)), 0};
  });
  model.known_field("far_v", "v", [&](const Point& p) -> Point {
    const double rho = rho_of(p);
    return {rho < far ? 0 : -c * (1 / rho + (1 - 2 * nu) / (rho - p[1])), 0, 0};
  });
  if (!is_first) return;
  model.hold("u", region::far, "far_u");
  model.hold("v", region::far, "far_v");
}

constexpr double residual = 1e-9;

}  // namespace

Solved solve_torsion(const Setting& setting) {
  const Torsion claim = torsion();
  Model model = half_space_section(setting, 1);
  twisting(model, setting);
  model.field("tau", 1, 1, region::contact);
  model.known("gam", 0.3 * setting.elements);
  model.known("beta", 0.);
  const std::string most = fmt::format("{}*{}", claim.mu, hertz_pressure);
  const std::string tau = fmt::format("min({0},max(-{0},tau+gam*(beta*X(1)-v)))", most);
  model.nonlinear(fmt::format("(-{0}*Test_v+(1/gam)*({0}-tau)*Test_tau)*X(1)", tau), region::contact);
  Solved solved;
  std::vector<double> moments;
  for (const double turn : claim.turns) {
    model.known("beta", turn);
    solved.iterations += model.solve(residual, fmt::format("torsion by {:g} rad", turn));
    moments.push_back(model.integral("2*pi*X(1)*X(1)*tau", region::contact));
  }
  solved.unknowns = model.unknowns();
  solved.values = {moments, moments};
  solved.curves.push_back({"moment",
                           "turn G a / (mu p_0)",
                           "moment [N m]",
                           {{"FE", claim.turns, moments},
                            {"Lubkin", claim.turns, claim.quantities[0].library, true},
                            {"rigid patch", claim.turns, claim.quantities[1].library, true}}});
  for (auto& line : solved.curves.back().lines) {
    for (double& x : line.x) x /= claim.mu;
  }
  return solved;
}

Solved solve_shear(const Setting& setting) {
  const Shear claim = shear();
  Model model = half_space_section(setting, 1);
  shearing(model, setting, 0);
  model.field("q", 1, 1, region::contact);
  model.unknown("d");
  model.known("gam", 0.3 * setting.elements);
  const std::string most = fmt::format("{}*{}", claim.mu, hertz_pressure);
  const std::string q = fmt::format("min({0},max(-{0},q+gam*(d-(u(1)-v)/2)))", most);
  // The work of q on the mean of u_x over a ring; the load is that of half a turn, as the strain energy is.
  model.nonlinear(fmt::format("(-{0}*(Test_u(1)-Test_v)+(2/gam)*({0}-q)*Test_q+2*{0}*Test_d)*X(1)", q),
                  region::contact);
  Solved solved;
  std::vector<double> shifts;
  for (const double force : claim.forces) {
    hold_cerruti(model, setting, 0, force, shifts.empty());
    model.load("d", force / std::numbers::pi);
    solved.iterations += model.solve(residual, fmt::format("shear by {:g} N", force));
    shifts.push_back(model.number("d"));
  }
  solved.unknowns = model.unknowns();
  solved.values = {shifts};
  solved.curves.push_back(
      {"force",
       "displacement [m]",
       "force [N]",
       {{"FE", shifts, claim.forces}, {"Cattaneo, Mindlin", claim.quantities[0].library, claim.forces, true}}});
  return solved;
}

Solved solve_stuck_circle(const Setting& setting) {
  constexpr double edge_refinement = 20;
  const double nu = stuck_circle().poisson_ratio;
  Solved solved;

  Model shear = half_space_section(setting, 1, edge_refinement);
  shearing(shear, setting, nu);
  shear.field("q", 1, 1, region::contact);
  shear.unknown("d");
  shear.linear("(-q*(Test_u(1)-Test_v)+(2*d-(u(1)-v))*Test_q+2*q*Test_d)*X(1)", region::contact);
  hold_cerruti(shear, setting, nu, 1, true);
  shear.load("d", 1 / std::numbers::pi);
  solved.iterations += shear.solve(residual, "stuck circle, shear");

  Model torsion = half_space_section(setting, 1, edge_refinement);
  twisting(torsion, setting);
  torsion.field("tau", 1, 1, region::contact);
  torsion.linear("(-tau*Test_v+(X(1)-v)*Test_tau)*X(1)", region::contact);
  solved.iterations += torsion.solve(residual, "stuck circle, torsion");

  solved.unknowns = shear.unknowns() + torsion.unknowns();
  solved.values = {{1 / shear.number("d")}, {torsion.integral("2*pi*X(1)*X(1)*tau", region::contact)}};
  return solved;
}

}  // namespace patchgrip::verification
