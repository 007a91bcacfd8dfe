#include <patchgrip/verification/cases/punch.h>

#include <fmt/format.h>

#include <cmath>

#include <patchgrip/verification/claims/punch.h>
#include <patchgrip/verification/fe/half_space.h>

namespace patchgrip::verification {
namespace {

constexpr double edge_refinement = 20;

void press_flat(Model& model, double force) {
  model.unknown("delta");
  model.linear("(lam*Test_u(2)+(u(2)+delta)*Test_lam-2*pi*lam*Test_delta)*X(1)", region::contact);
  model.load("delta", -force);
}

}  // namespace

Solved solve_flat_punch(const Setting& setting) {
  const Punch punch = flat_punch();
  Model model = half_space_of_revolution(setting, 1, punch.material, punch.library.force, edge_refinement);
  press_flat(model, punch.library.force);
  Solved solved;
  solved.iterations = model.solve(1e-8 * punch.library.force, "flat punch");
  solved.unknowns = model.unknowns();
  const auto line = model.along("lam", region::contact);
  solved.values = {{model.number("delta")}, values_at(line, punch.radii)};
  solved.curves.push_back(pressure_curve(
      line, [&](double r) { return punch.library.pressure(r); }, 0.98));
  solved.stress = model.plane_field(von_mises_of_revolution());
  return solved;
}

Solved solve_rough_punch(const Setting& setting) {
  const RoughPunch punch = rough_punch();
  Model model = half_space_of_revolution(setting, 1, punch.material, punch.force, edge_refinement);
  press_flat(model, punch.force);
  model.field("tau", 1, 1, region::contact);
  model.known("gam_t", 0.3 * shear_modulus(punch.material) * setting.elements);
  const std::string most = fmt::format("{}*pos_part(lam)", punch.mu);
  const std::string tau = fmt::format("min({0},max(-{0},tau-gam_t*u(1)))", most);
  model.nonlinear(fmt::format("(-{0}*Test_u(1)+(1/gam_t)*({0}-tau)*Test_tau)*X(1)", tau), region::contact);
  Solved solved;
  solved.iterations = model.solve(1e-8 * punch.force, "rough punch");
  solved.unknowns = model.unknowns();
  // What sticks has the area in which the shear stays below the limit.
  const std::string sticks = fmt::format("Heaviside((1-1e-6)*{}-Norm(tau-gam_t*u(1)))", most);
  solved.values = {{std::sqrt(2 * model.integral("X(1)*" + sticks, region::contact))}};
  return solved;
}

}  // namespace patchgrip::verification
