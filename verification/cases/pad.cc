#include <patchgrip/verification/cases/pad.h>

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace patchgrip::verification {
namespace {

Mesh mesh_of(const Pad& pad, double size) {
  if (pad.shape == PadShape::rectangle) return Mesh::box_pad(2 * pad.half_x, 2 * pad.half_y, pad.height, size);
  return Mesh::elliptic_pad(pad.half_x, pad.half_y, pad.height, size);
}

}  // namespace

Solved solve_pad(const Pad& pad, const Setting& setting) {
  constexpr double nu = 0.45;
  Model model(mesh_of(pad, 1 / setting.elements));
  constexpr double near = 1e-9;
  model.mark(region::contact, [](const Point& p) { return std::fabs(p[2]) < near; });
  model.mark(region::held, [&](const Point& p) { return std::fabs(p[2] - pad.height) < near; });
  model.field("u", 3, 2);
  model.field("t", 2, 1, region::contact);
  model.known("la", 2 * nu / (1 - 2 * nu));
  model.known("gam", setting.elements);
  model.known("turned", 0.);
  model.known("before", 0.);
  model.remember("u_before", "u");
  model.linear("la*Trace(Grad_u)*Trace(Grad_Test_u)+2*Sym(Grad_u):Sym(Grad_Test_u)");
  const std::string q =
      fmt::format("(t+gam*((turned-before)*[-X(2);X(1)-({})]-[u(1)-u_before(1);u(2)-u_before(2)]))", pad.pole);
  const std::string traction = fmt::format("({0}*min(1,{1}*{2}/max(1e-12,Norm({0}))))", q, pad.mu, pad.pressure);
  model.nonlinear(fmt::format("-{0}.[Test_u(1);Test_u(2)]+(1/gam)*({0}-t).Test_t", traction), region::contact);
  model.hold("u", region::held);

  Solved solved;
  std::vector<double> forces, moments;
  const double full = pad.mu * pad.load;
  for (const double share : pad.turns) {
    const double turn = share * pad.mu * pad.height;
    model.known("turned", turn);
    solved.iterations += model.solve(1e-7, fmt::format("pad turned by {:g} rad", turn));
    model.remember("u_before", "u");
    model.known("before", turn);
    forces.push_back(model.integral("t(2)", region::contact) / full);
    moments.push_back(model.integral("X(1)*t(2)-X(2)*t(1)", region::contact) / full);
  }
  solved.unknowns = model.unknowns();
  solved.values = {{forces.back()}, {moments.back()}, forces, moments};
  solved.curves.push_back({"break_away",
                           "theta G / (mu p h)",
                           "share of mu F",
                           {{"FE, force", pad.turns, forces},
                            {"FE, moment / m", pad.turns, moments},
                            {"bristles, force", pad.turns, pad.quantities[2].library, true},
                            {"bristles, moment / m", pad.turns, pad.quantities[3].library, true}}});
  return solved;
}

}  // namespace patchgrip::verification
