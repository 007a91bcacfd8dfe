#include <patchgrip/cli/press/press_ellipse.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <patchgrip/contact/hertz_ellipse.h>
#include <patchgrip/contact/hertz_ellipse_approximation.h>

namespace patchgrip::cli {
namespace {

using contact::HertzEllipse;
using contact::HertzEllipseApproximation;
using contact::RelativeRadii;

constexpr double unit = 0x1p-53;

HertzEllipse loaded(const StaticLoad& load, const RelativeRadii& radii, double modulus) {
  if (load.kind == LoadKind::contact_radius) {
    throw std::invalid_argument("contact_radius: an ellipse has two; give normal_force or approach");
  }
  return load.kind == LoadKind::normal_force ? HertzEllipse::under_force(load.value, radii, modulus)
                                             : HertzEllipse::at_approach(load.value, radii, modulus);
}

LawAnswer answer_of(const HertzEllipse& e, const RelativeRadii& radii, double modulus, double angle) {
  const auto bounded = [](const char* name, double value, const char* of) {
    return Result{name, value, HertzEllipse::error_units * unit * std::fabs(value), of};
  };
  LawAnswer answer{"hertz_ellipse", {}, "two surfaces by their curvature, zone small against the radii"};
  answer.results = {bounded("semi_axis_a", e.a, "m"),
                    bounded("semi_axis_b", e.b, "m"),
                    bounded("eccentricity", e.eccentricity, "1"),
                    bounded("one_minus_b_over_a", e.one_minus_b_a, "1"),
                    bounded("normal_force", e.normal_force, "N"),
                    bounded("approach", e.approach, "m"),
                    bounded("peak_pressure", e.peak_pressure, "Pa"),
                    bounded("stiffness", e.stiffness, "N/m"),
                    {"angle_of_a", angle, 8 * unit * std::numbers::pi, "rad"},
                    {"radius_large", radii.large, 1.01 * unit * radii.large, "m"},
                    {"radius_small", radii.small, 1.01 * unit * radii.small, "m"},
                    {"contact_modulus", modulus, 1.01 * unit * modulus, "Pa"}};
  return answer;
}

void add_approximation(Pressed& pressed, double force, const RelativeRadii& radii, double modulus) {
  if (radii.small < HertzEllipseApproximation::smallest_ratio * radii.large) return;
  const auto e = HertzEllipseApproximation::under_force(force, radii, modulus);
  const auto bounded = [](const char* name, double value, double relative, const char* of) {
    return Result{name, value, relative * value, of};
  };
  pressed.answer.beside.push_back(
      {"elementary",
       {bounded("semi_axis_a", e.a, e.a_error, "m"), bounded("semi_axis_b", e.b, e.b_error, "m"),
        bounded("peak_pressure", e.peak_pressure, e.peak_pressure_error, "Pa"),
        bounded("approach", e.approach, e.approach_error, "m")},
       "without elliptic integrals; its errors are against hertz_ellipse"});
}

// What one circle of radius R makes of the same approach (seed figure 4.11).
void add_circles(Pressed& pressed, const RelativeRadii& radii) {
  const auto shape = contact::shape_of(radii);
  const auto add = [&](const char* law, const contact::FactorsToCircle<long double>& f, const char* remark) {
    const auto factor = [](const char* name, long double value) {
      return Result{name, static_cast<double>(value), unit * static_cast<double>(value), "1"};
    };
    pressed.answer.beside.push_back({law,
                                     {factor("pressure_factor", f.pressure), factor("force_factor", f.force),
                                      factor("a_factor", f.a), factor("b_factor", f.b)},
                                     remark});
  };
  add("circle_of_small_radius", shape.against_small_radius(),
      "the ellipse over the circle of R_small at the same approach");
  add("circle_of_large_radius", shape.against_large_radius(),
      "the ellipse over the circle of R_large at the same approach");
}

}  // namespace

std::optional<CurvedSurface> curved_surface(const Shape& shape) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::holds_alternative<Plane>(shape)) return CurvedSurface{{infinity, infinity}, 0};
  if (const auto* ball = std::get_if<Ball>(&shape)) return CurvedSurface{{ball->radius, ball->radius}, 0};
  if (const auto* curved = std::get_if<CurvedSurface>(&shape)) return *curved;
  return std::nullopt;
}

Pressed press_ellipse(const CurvedSurface& first, const CurvedSurface& second, double modulus,
                      const PressScene& scene) {
  const auto radii = RelativeRadii::of_bodies({first.radii[0], first.radii[1]}, {second.radii[0], second.radii[1]},
                                              second.direction - first.direction);
  const HertzEllipse e = loaded(std::get<StaticLoad>(scene.load), radii, modulus);
  const double angle = first.direction + radii.angle_a;
  const contact::EllipticPressure pressure = e.elliptic_pressure();
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Pressed result{
      {answer_of(e, radii, modulus, angle), {}, {}},
      e.a,
      [=, approach = e.approach, large = radii.large, small = radii.small](double x, double y) -> SurfacePoint {
        const double along_a = c * x + s * y;
        const double along_b = c * y - s * x;
        const double p = pressure.pressure(along_a, along_b);
        const double u = pressure.displacement(along_a, along_b, modulus);
        const double height = along_a * along_a / (2 * large) + along_b * along_b / (2 * small);
        const double gap = p > 0 ? 0 : std::max(height - approach + u, 0.);
        // The semi-axes carry a unit, the coordinates two: the pressure feels them through its slope.
        const double rho2 = std::pow(along_a / pressure.a, 2) + std::pow(along_b / pressure.b, 2);
        const double p0 = pressure.peak_pressure;
        const double moved = 16 * unit * rho2;
        const double p_error = rho2 < 1 + moved ? 4 * unit * p + p0 * std::min(std::sqrt(moved), moved * p0 / p) : 0;
        const double u_error = 8 * unit * (approach + u);
        return {{p, p_error}, {u, u_error}, {gap, p > 0 ? 0 : u_error + 8 * unit * height}};
      }};
  add_approximation(result, e.normal_force, radii, modulus);
  add_circles(result, radii);
  const double steepest = e.b / radii.small;
  if (steepest > 0.1) {
    result.answer.warnings.push_back(
        fmt::format("b/R_small = {:.3g} is not small: the half-space theory leaves out terms of its square", steepest));
  }
  return result;
}

}  // namespace patchgrip::cli
