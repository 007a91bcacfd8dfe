#include <patchgrip/verification/cases/bodies.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <patchgrip/verification/fe/half_space.h>

namespace patchgrip::verification {

Solved solve_elastic_pair(const Setting& setting) {
  const ElasticPair pair = elastic_pair();
  const double force = pair.press.force;
  Model model = half_space_of_revolution(setting, 1.15, pair.first, force);
  model.field("v", 2, 2);
  model.known("G2", shear_modulus(pair.second));
  model.known("la2", lame_modulus(pair.second));
  model.known("gam", contact::contact_modulus(pair.first, pair.second) * setting.elements);
  model.linear(
      "(la2*(Trace(Grad_v)+v(1)/X(1))*(Trace(Grad_Test_v)+Test_v(1)/X(1))"
      "+2*G2*(Sym(Grad_v):Sym(Grad_Test_v)+v(1)*Test_v(1)/sqr(X(1))))*X(1)");
  model.linear(fmt::format("{}*v(1)*Test_v(1)", 1e5 * pair.second.youngs_modulus * setting.elements), region::axis);
  model.known_field("far_v", "v", [&](const Point& p) {
    return std::hypot(p[0], p[1]) > 0.5 * setting.extent ? boussinesq_section(p, force, pair.second) : Point{0, 0, 0};
  });
  model.hold("v", region::far, "far_v");
  model.unknown("delta", 0.9 * pair.press.approach);
  const std::string p = "pos_part(lam+gam*(u(2)+v(2)+delta-" + pair.press.height + "))";
  model.nonlinear(fmt::format("({0}*(Test_u(2)+Test_v(2))+(1/gam)*({0}-lam)*Test_lam-2*pi*{0}*Test_delta)*X(1)", p),
                  region::contact);
  model.load("delta", -force);

  Solved solved;
  solved.iterations = model.solve(1e-8 * force, "elastic pair");
  solved.unknowns = model.unknowns();
  const auto line = model.along("lam", region::contact);
  const double second_moment = model.integral("2*pi*X(1)*sqr(X(1))*lam", region::contact);
  solved.values = {{model.number("delta")},
                   {std::sqrt(second_moment / model.integral("2*pi*X(1)*lam", region::contact))},
                   {line.front().second},
                   values_at(line, pair.press.radii),
                   {pressure_distance_of(line, pair.press.pressure)}};
  return solved;
}

Solved solve_ellipse(const PressedEllipse& press, const Setting& setting) {
  const auto& [material, small, large, library, quantities] = press;
  const double a = library.a, b = library.b, force = library.normal_force, extent = setting.extent * a;
  const double fine = b / setting.elements;
  // Distance from an ellipsoid around the contact, along the ray.
  Model model(Mesh::half_space_quarter(extent, [=](double x, double y, double z) {
    const double q = std::hypot(x / (1.25 * a), y / (1.25 * b), z / (0.8 * b));
    return q <= 1 ? fine : fine + 0.35 * std::hypot(x, y, z) * (1 - 1 / q);
  }));
  const double near = 1e-6 * extent;
  model.mark(region::contact,
             [=](const Point& p) { return std::fabs(p[2]) < near && std::hypot(p[0] / a, p[1] / b) < 1.4; });
  model.mark(region::far, [=](const Point& p) { return std::hypot(p[0], p[1], p[2]) > extent - 1e3 * near; });
  model.mark(region::axis, [=](const Point& p) { return std::fabs(p[0]) < near; });
  model.mark(region::side, [=](const Point& p) { return std::fabs(p[1]) < near; });

  model.field("u", 3, 2);
  model.field("lam", 1, 1, region::contact);
  model.unknown("delta", 0.9 * library.approach);
  model.known("G", shear_modulus(material));
  model.known("la", lame_modulus(material));
  model.known("gam", contact::contact_modulus(material, contact::Material::rigid()) / fine);
  model.linear("la*Trace(Grad_u)*Trace(Grad_Test_u)+2*G*Sym(Grad_u):Sym(Grad_Test_u)");
  const std::string p = fmt::format("pos_part(lam+gam*(u(3)+delta-sqr(X(1))/{}-sqr(X(2))/{}))", 2 * large, 2 * small);
  model.nonlinear(fmt::format("{0}*Test_u(3)+(1/gam)*({0}-lam)*Test_lam-{0}*Test_delta", p), region::contact);
  model.load("delta", -force / 4);
  const double spring = 1e5 * material.youngs_modulus / fine;
  model.linear(fmt::format("{}*u(1)*Test_u(1)", spring), region::axis);
  model.linear(fmt::format("{}*u(2)*Test_u(2)", spring), region::side);
  model.known_field("far_u", "u", [&](const Point& at) -> Point {
    const double r = std::hypot(at[0], at[1]);
    if (std::hypot(r, at[2]) < 0.5 * extent) return {0, 0, 0};
    const Point u = boussinesq_section({r, at[2], 0}, force, material);
    return {r > 0 ? u[0] * at[0] / r : 0, r > 0 ? u[0] * at[1] / r : 0, u[1]};
  });
  model.hold("u", region::far, "far_u");

  Solved solved;
  solved.iterations = model.solve(1e-7 * force, "ellipse");
  solved.unknowns = model.unknowns();
  const double carried = model.integral("lam", region::contact);
  const auto semi_axis = [&](const std::string& x) {  // <x^2> = a^2 / 5
    return std::sqrt(5 * model.integral(fmt::format("sqr({})*lam", x), region::contact) / carried);
  };
  solved.values = {{model.number("delta")}, {semi_axis("X(1)")}, {semi_axis("X(2)")}};
  return solved;
}

}  // namespace patchgrip::verification
