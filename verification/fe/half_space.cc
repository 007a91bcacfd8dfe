#include <patchgrip/verification/fe/half_space.h>

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>

namespace patchgrip::verification {
namespace {

constexpr double growth = 0.15;  // of the size of the elements, per length

}  // namespace

double shear_modulus(const contact::Material& material) {
  return material.youngs_modulus / (2 * (1 + material.poisson_ratio));
}

double lame_modulus(const contact::Material& material) {
  return 2 * shear_modulus(material) * material.poisson_ratio / (1 - 2 * material.poisson_ratio);
}

Point boussinesq_section(const Point& at, double force, const contact::Material& material) {
  const double r = at[0], Z = -at[1], q = std::hypot(r, Z), nu = material.poisson_ratio;
  const double scale = force / (4 * std::numbers::pi * shear_modulus(material));
  return {scale * r * (Z / (q * q * q) - (1 - 2 * nu) / (q * (q + Z))),
          -scale * (Z * Z / (q * q * q) + 2 * (1 - nu) / q), 0};
}

Model half_space_section(const Setting& setting, double contact_reach, double edge_refinement) {
  const double fine = 1 / setting.elements, extent = setting.extent;
  const SizeAt within = graded(fine, 1.3, growth), edge = graded(fine / edge_refinement, 0, growth);
  Model model(Mesh::half_space_section(extent, contact_reach, [&](double x, double y, double z) {
    return std::min(within(x, y, z), edge(x - contact_reach, y, z));
  }));
  const double near = 1e-9 * extent;
  model.mark(region::contact, [=](const Point& p) { return std::fabs(p[1]) < near && p[0] < contact_reach + near; });
  model.mark(region::far, [=](const Point& p) { return std::hypot(p[0], p[1]) > extent - near; });
  model.mark(region::axis, [=](const Point& p) { return std::fabs(p[0]) < near; });
  return model;
}

Model half_space_of_revolution(const Setting& setting, double contact_reach, const contact::Material& material,
                               double force, double edge_refinement) {
  Model model = bare_half_space(setting, contact_reach, material, edge_refinement);
  model.linear(
      "(la*(Trace(Grad_u)+u(1)/X(1))*(Trace(Grad_Test_u)+Test_u(1)/X(1))"
      "+2*G*(Sym(Grad_u):Sym(Grad_Test_u)+u(1)*Test_u(1)/sqr(X(1))))*X(1)");
  set_far_force(model, setting, material, force);
  model.hold("u", region::far, "far_u");
  return model;
}

void set_far_force(Model& model, const Setting& setting, const contact::Material& material, double force) {
  model.known_field("far_u", "u", [&](const Point& p) {
    return std::hypot(p[0], p[1]) > 0.5 * setting.extent ? boussinesq_section(p, force, material) : Point{0, 0, 0};
  });
}

Model bare_half_space(const Setting& setting, double contact_reach, const contact::Material& material,
                      double edge_refinement) {
  Model model = half_space_section(setting, contact_reach, edge_refinement);
  model.field("u", 2, 2);
  model.field("lam", 1, 1, region::contact);
  model.known("G", shear_modulus(material));
  model.known("la", lame_modulus(material));
  model.known("gam", contact::contact_modulus(material, contact::Material::rigid()) * setting.elements);
  model.linear(fmt::format("{}*u(1)*Test_u(1)", 1e5 * material.youngs_modulus * setting.elements), region::axis);
  return model;
}

void press_without_friction(Model& model, const std::string& height, double force, double approach_to_start,
                            const std::string& slope) {
  model.unknown("delta", approach_to_start);
  const std::string pressure = "pos_part(lam+gam*(u(2)+delta-" + height + "))";
  const std::string outwards = slope.empty() ? "" : "-" + slope + "*Test_u(1)";
  model.nonlinear(
      fmt::format("({0}*(Test_u(2){1})+(1/gam)*({0}-lam)*Test_lam-2*pi*{0}*Test_delta)*X(1)", pressure, outwards),
      region::contact);
  model.load("delta", -force);
}

std::string strain_of_revolution(const std::string& field) {
  return fmt::format(
      "[[Grad_{0}(1,1),(Grad_{0}(1,2)+Grad_{0}(2,1))/2,0],[(Grad_{0}(1,2)+Grad_{0}(2,1))/2,Grad_{0}(2,2),0],"
      "[0,0,{1}]]",
      field, stretch_around_axis(field));
}

std::string stretch_around_axis(const std::string& field) {
  return fmt::format("(Heaviside(X(1)-1e-6)*{0}(1)/max(X(1),1e-6)+Heaviside(1e-6-X(1))*Grad_{0}(1,1))", field);
}

std::string von_mises_of_revolution() { return "2*G*sqrt(1.5)*Norm(Deviator(" + strain_of_revolution("u") + "))"; }

std::vector<double> values_at(const std::vector<std::pair<Point, double>>& line, const std::vector<double>& radii,
                              std::size_t points) {
  std::vector<double> values;
  const auto radius = [&](std::size_t k) { return line[k].first[0]; };
  for (const double r : radii) {
    const std::size_t n = line.size();
    if (n < points || r < 2 * radius(0) - radius(1) || r > 2 * radius(n - 1) - radius(n - 2)) {
      throw std::out_of_range(fmt::format("no {} nodes around r = {}", points, r));
    }
    const auto is_beyond = [&](const auto& node) { return node.first[0] >= r; };
    const auto last = std::find_if(line.begin() + static_cast<std::ptrdiff_t>(points) - 1, line.end() - 1, is_beyond);
    const auto first = last - static_cast<std::ptrdiff_t>(points) + 1;
    double value = 0;
    for (auto one = first; one <= last; ++one) {
      double share = 1;
      for (auto other = first; other <= last; ++other) {
        if (other != one) share *= (r - other->first[0]) / (one->first[0] - other->first[0]);
      }
      value += share * one->second;
    }
    values.push_back(value);
  }
  return values;
}

Curve pressure_curve(const std::vector<std::pair<Point, double>>& line, const std::function<double(double)>& library,
                     double reach) {
  constexpr int points = 200;
  Curve curve{"pressure", "r / a", "p [Pa]", {{"FE", {}, {}}, {"library", {}, {}, true}}};
  for (const auto& [at, pressure] : line) {
    if (at[0] > reach) continue;
    curve.lines[0].x.push_back(at[0]);
    curve.lines[0].y.push_back(pressure);
  }
  for (int k = 0; k <= points; ++k) {
    curve.lines[1].x.push_back(reach * k / points);
    curve.lines[1].y.push_back(library(reach * k / points));
  }
  return curve;
}

double pressure_distance_of(const std::vector<std::pair<Point, double>>& line,
                            const std::function<double(double)>& pressure) {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  double apart = 0, whole = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double from = line[k].first[0], to = line[k + 1].first[0];
    apart += Rule::integrate(
        [&](double r) {
          const double d = std::lerp(line[k].second, line[k + 1].second, (r - from) / (to - from)) - pressure(r);
          return d * d * r;
        },
        from, to);
    whole += Rule::integrate([&](double r) { return pressure(r) * pressure(r) * r; }, from, to);
  }
  return std::sqrt(apart / whole);
}

}  // namespace patchgrip::verification
