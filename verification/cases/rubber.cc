#include <patchgrip/verification/cases/rubber.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <patchgrip/verification/claims/rubber.h>
#include <patchgrip/verification/fe/half_space.h>

namespace patchgrip::verification {
namespace {

// In the order r, z, theta.
std::string deformation(const std::string& around) {
  return "[[1+Grad_u(1,1),Grad_u(1,2),0],[Grad_u(2,1),1+Grad_u(2,2),0],[0,0,1+" + around + "]]";
}
const std::string F = deformation("u(1)/X(1)");

// n elements per radius; of a contact up to `angle` from the pole if there is one, finer at its edge.
Model hemisphere(double n, double angle = 0) {
  constexpr double growth = 0.2, edge_refinement = 10;
  const bool known = angle > 0;
  const SizeAt coarse = graded(1 / n, 0.7, growth),
               fine = known ? graded(angle / n, angle, growth) : graded(1 / (4 * n), 0.1, growth),
               finest = graded(angle / (n * edge_refinement), 0, growth);
  Model model(Mesh::hemisphere_section(1, [=](double x, double y, double z) {
    const double size = std::min(coarse(x, y + 1, z), fine(x, y + 1, z));
    return known ? std::min(size, finest(x - std::sin(angle), y + std::cos(angle), z)) : size;
  }));
  constexpr double near = 1e-9;
  model.mark(region::contact, [](const Point& p) { return std::hypot(p[0], p[1]) > 1 - 1e-3 && p[0] > -near; });
  model.mark(region::held, [](const Point& p) { return std::fabs(p[1]) < near; });
  model.mark(region::axis, [](const Point& p) { return std::fabs(p[0]) < near; });
  model.field("u", 2, 2);
  model.field("p", 1, 1);
  model.field("lam", 1, 1, region::contact);
  model.start("p", 1);
  model.known("plate", -1.);
  model.known("gam", 40 * n);
  const std::string dF =
      "[[Grad_Test_u(1,1),Grad_Test_u(1,2),0],[Grad_Test_u(2,1),Grad_Test_u(2,2),0],[0,0,Test_u(1)/X(1)]]";
  model.nonlinear(fmt::format("(({0}-p*Inv({0})'):{1}-(Det({0})-1)*Test_p)*X(1)", F, dF));
  const std::string pressure = "pos_part(lam+gam*(plate-X(2)-u(2)))";
  model.nonlinear(fmt::format("(-{0}*Test_u(2)+(1/gam)*({0}-lam)*Test_lam)*X(1)", pressure), region::contact);
  model.linear(fmt::format("{}*u(1)*Test_u(1)", 1e5 * n), region::axis);
  model.hold("u", region::held);
  return model;
}

int press(Model& model, double from, double to) {
  constexpr double longest = 0.05;
  const int steps = static_cast<int>(std::ceil((to - from) / longest - 1e-9));
  int iterations = 0;
  for (int k = 1; k <= steps; ++k) {
    const double d = std::lerp(from, to, static_cast<double>(k) / steps);
    model.known("plate", -1 + d);
    iterations += model.solve(1e-8, fmt::format("hemisphere pressed by {:g}", d));
  }
  return iterations;
}

// Of the area that touches, as it lies on the plate.
double contact_radius(const Model& model) {
  return std::sqrt(
      2 * model.integral("Heaviside(lam+gam*(plate-X(2)-u(2)))*Norm(Inv(" + F + ")'*[Normal(1);Normal(2);0])*X(1)",
                         region::contact));
}

// Of the surface that touches, from the pole.
double contact_angle(const Model& model) {
  return model.integral("Heaviside(lam+gam*(plate-X(2)-u(2)))", region::contact);
}

double load(const Model& model) { return model.integral("2*pi*X(1)*lam", region::contact); }

// Beside the pressed state small motions of the plate, which the tip sticks to: along x, and about the axis.
//
//     shear     v = (w_1 cos theta, v sin theta, w_2 cos theta), and q cos theta of the pressure
//               d2 Pi = int dF : dF - p (tr(A)^2 - A^T : A) - 2 q tr(A),  A = F^-1 dF
//     torsion   phi turns rings of radius r = R + u_1:  d2 Pi = int r^2 |grad phi|^2
//
// What touches is held by stiff springs: their forces are those of the plate.
constexpr double spring = 1e7;
const std::string touches = "Heaviside(lam0+gam*(plate-X(2)-u0(2)))";

void add_motions(Model& model, double n) {
  for (const char* name : {"u", "p", "lam"}) model.remember(std::string(name) + "0", name);
  // In the order r, theta, z.
  const std::string inverse =
      "Inv([[1+Grad_u0(1,1),0,Grad_u0(1,2)],[0,1+u0(1)/X(1),0],[Grad_u0(2,1),0,1+Grad_u0(2,2)]])";
  // Without the cosines and sines.
  const auto of_w = [](const std::string& w) {
    return fmt::format(
        "[[Grad_{0}(1,1),-{0}(1)/X(1),Grad_{0}(1,2)],[0,{0}(1)/X(1),0],[Grad_{0}(2,1),-{0}(2)/X(1),Grad_{0}(2,2)]]", w);
  };
  const auto of_v = [](const std::string& v) {
    return fmt::format("[[0,-{0}/X(1),0],[Grad_{0}(1),{0}/X(1),Grad_{0}(2)],[0,0,0]]", v);
  };
  model.field("w", 2, 2);
  model.field("v", 1, 2);
  model.field("q", 1, 1);
  const std::string H = fmt::format("({}+{})", of_w("w"), of_v("v")), A = fmt::format("({}*{})", inverse, H);
  for (const auto& dH : {of_w("Test_w"), of_v("Test_v")}) {
    const std::string dA = fmt::format("({}*{})", inverse, dH);
    model.linear(fmt::format("({0}:{1}-p0*(Trace({2})*Trace({3})-({2}'):{3})-q*Trace({3}))*X(1)", H, dH, A, dA));
  }
  model.linear(fmt::format("-Test_q*Trace({})*X(1)", A));
  model.linear(fmt::format("{}*((w(1)+v)*(Test_w(1)+Test_v)+w(2)*Test_w(2))", 1e5 * n), region::axis);
  model.hold("w", region::held);
  model.hold("v", region::held);
  model.linear(fmt::format("{}*{}*((w(1)-1)*Test_w(1)+w(2)*Test_w(2)+(v+1)*Test_v)*X(1)", spring, touches),
               region::contact);
  model.field("phi", 1, 2);
  model.linear("sqr(X(1)+u0(1))*Grad_phi.Grad_Test_phi*X(1)");
  model.hold("phi", region::held);
  model.linear(fmt::format("{}*{}*sqr(X(1)+u0(1))*(phi-1)*Test_phi*X(1)", spring, touches), region::contact);
}

}  // namespace

Solved solve_rubber_hemisphere(const Setting& setting) {
  const PressedHemisphere rubber = rubber_hemisphere();
  auto model = std::make_shared<Model>(hemisphere(setting.elements));
  Solved solved;
  std::vector<double> forces, radii;
  double at = 0;
  for (const double approach : rubber.approaches) {
    solved.iterations += press(*model, at, approach);
    at = approach;
    forces.push_back(load(*model));
    radii.push_back(contact_radius(*model));
  }
  solved.unknowns = model->unknowns();
  solved.values = values_of(forces, radii);
  solved.curves.push_back({"force",
                           "approach / R",
                           "force / (G R^2)",
                           {{"FE, neo-Hooke", rubber.approaches, forces},
                            {"Hertz", rubber.approaches, rubber.quantities[0].library, true},
                            {"exact sphere", rubber.approaches, rubber.quantities[1].library, true}}});
  // Cauchy stress G b - p 1: its deviator is that of G b.
  const std::string von_mises =
      fmt::format("sqrt(1.5)*Norm(Deviator({0}*{0}'))", deformation(stretch_around_axis("u")));
  solved.stress = model->plane_field(von_mises, "u");
  solved.vtk = [model, von_mises](const std::string& file) {
    model->write_vtk(file, {"u"}, {{"von_mises", von_mises}});
  };
  return solved;
}

Solved solve_fingertip(const Setting& setting) {
  constexpr double modulus = 3;  // E = 3 G
  Solved solved;
  std::vector<double> shear, torsion;
  for (const double approach : fingertip().approaches) {
    Model coarse = hemisphere(setting.elements);
    solved.iterations += press(coarse, 0, approach);
    Model model = hemisphere(setting.elements, contact_angle(coarse));
    solved.iterations += press(model, 0, approach);
    add_motions(model, setting.elements);
    solved.iterations += model.solve(1e-8, fmt::format("hemisphere pressed by {:g} and moved", approach));
    const double a = contact_radius(model);
    const double force = model.integral(fmt::format("pi*{}*{}*(2-w(1)+v)*X(1)", spring, touches), region::contact);
    const double moment =
        model.integral(fmt::format("2*pi*{}*{}*sqr(X(1)+u0(1))*(1-phi)*X(1)", spring, touches), region::contact);
    shear.push_back(force / (16 * modulus * a / 9));
    torsion.push_back(moment / (16 * modulus * a * a * a / 9));
    solved.unknowns = model.unknowns();
  }
  solved.values = {{torsion.front()}, torsion, shear};
  solved.curves.push_back({"stiffness",
                           "approach / R",
                           "stiffness over Mindlin's",
                           {{"torsion", fingertip().approaches, torsion}, {"shear", fingertip().approaches, shear}}});
  return solved;
}

}  // namespace patchgrip::verification
