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

Model hemisphere(double n) {
  const SizeAt coarse = graded(1 / n, 0.7, 0.2), fine = graded(1 / (4 * n), 0.1, 0.2);
  Model model(Mesh::hemisphere_section(
      1, [=](double x, double y, double z) { return std::min(coarse(x, y + 1, z), fine(x, y + 1, z)); }));
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

double load(const Model& model) { return model.integral("2*pi*X(1)*lam", region::contact); }

}  // namespace

Solved solve_rubber_hemisphere(const Setting& setting) {
  const RubberHemisphere rubber = rubber_hemisphere();
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

}  // namespace patchgrip::verification
