#include <patchgrip/cli/press/press_ellipse.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <patchgrip/cli/press/rounding.h>
#include <patchgrip/contact/hertz_ellipse.h>
#include <patchgrip/contact/hertz_ellipse_approximation.h>

namespace patchgrip::cli {
namespace {

using contact::HertzEllipse;
using contact::HertzEllipseApproximation;
using contact::RelativeRadii;

HertzEllipse loaded(const StaticLoad& load, const RelativeRadii& radii, double modulus) {
  if (load.kind == LoadKind::contact_radius) {
    load.place.refuse("an ellipse has two; give normal_force or approach");
  }
  return load.kind == LoadKind::normal_force ? HertzEllipse::under_force(load.value, radii, modulus)
                                             : HertzEllipse::at_approach(load.value, radii, modulus);
}

LawAnswer answer_of(const HertzEllipse& e, const StaticLoad& load, const RelativeRadii& radii, double modulus,
                    const EllipseDirection& direction) {
  const auto bounded = [](const char* name, double value, const char* of) {
    return within(name, value, HertzEllipse::error_units, of);
  };
  const bool by_force = load.kind == LoadKind::normal_force;
  LawAnswer answer{"hertz_ellipse", {}, "two surfaces by their curvature, zone small against the radii"};
  answer.results = {
      bounded("semi_axis_a", e.a, "m"),
      bounded("semi_axis_b", e.b, "m"),
      bounded("eccentricity", e.eccentricity, "1"),
      bounded("one_minus_b_over_a", e.one_minus_b_a, "1"),
      by_force ? Result{"normal_force", load.value, 0, "N"} : bounded("normal_force", e.normal_force, "N"),
      by_force ? bounded("approach", e.approach, "m") : Result{"approach", load.value, 0, "m"},
      bounded("peak_pressure", e.peak_pressure, "Pa"),
      bounded("stiffness", e.stiffness, "N/m"),
      {"angle_of_a", direction.angle, direction.error, "rad"},
      {"radius_large", radii.large, direction.large_error, "m"},
      {"radius_small", radii.small, direction.small_error, "m"},
      {"one_minus_radius_ratio", radii.one_minus_ratio, direction.ratio_error, "1"},
      within("contact_modulus", modulus, 1.01, "Pa")};
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
      return within(name, static_cast<double>(value), 1, "1");
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

EllipseDirection EllipseDirection::of(const CurvedSurface& first, const CurvedSurface& second,
                                      const RelativeRadii& radii) {
  const double turn = second.direction - first.direction;
  // |dp| + |dm| of relative_radii.h, where the curvatures differ by D = (1 - R_small/R_large) / R_small.
  const double differences =
      std::fabs(1 / first.radii[0] - 1 / first.radii[1]) + std::fabs(1 / second.radii[0] - 1 / second.radii[1]);
  const double noise = (0x1p-62 + unit * std::fabs(turn)) * differences * radii.small;
  // d(det) = dp dm sin(2 alpha) d(alpha), and det = 1 / (R_small R_large).
  const double turned_det = unit * std::fabs(turn) * std::fabs(1 / first.radii[0] - 1 / first.radii[1]) *
                            std::fabs(1 / second.radii[0] - 1 / second.radii[1]) * radii.small * radii.large;
  const double angle = first.direction + radii.angle_a;
  const double turned = radii.one_minus_ratio > 0 ? noise / radii.one_minus_ratio : std::numbers::pi;
  return {angle, std::min(std::numbers::pi / 2, 2 * turned + unit * (std::numbers::pi + std::fabs(angle))),
          1.01 * unit * radii.one_minus_ratio + noise, radii.small * (1.01 * unit + noise),
          radii.large * (unit * radii.radius_units + noise + turned_det)};
}

std::optional<CurvedSurface> curved_surface(const Shape& shape) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::holds_alternative<Plane>(shape)) return CurvedSurface{{infinity, infinity}, 0};
  if (const auto* ball = std::get_if<Ball>(&shape)) return CurvedSurface{{ball->radius, ball->radius}, 0};
  if (const auto* curved = std::get_if<CurvedSurface>(&shape)) return *curved;
  return std::nullopt;
}

RelativeRadii relative_radii_of(const CurvedSurface& first, const CurvedSurface& second) {
  return RelativeRadii::of_bodies({first.radii[0], first.radii[1]}, {second.radii[0], second.radii[1]},
                                  second.direction - first.direction);
}

Pressed press_ellipse(const CurvedSurface& first, const CurvedSurface& second, double modulus,
                      const PressScene& scene) {
  const RelativeRadii radii = at(scene.subject_place, [&] { return relative_radii_of(first, second); });
  const auto& load = std::get<StaticLoad>(scene.load);
  const HertzEllipse e = loaded(load, radii, modulus);
  const auto direction = EllipseDirection::of(first, second, radii);
  const contact::EllipticPressure pressure = e.elliptic_pressure();
  const double c = std::cos(direction.angle);
  const double s = std::sin(direction.angle);
  Pressed result{{answer_of(e, load, radii, modulus, direction), {}, {}},
                 e.a,
                 [=, approach = e.approach, one_minus_b_a = e.one_minus_b_a, large = radii.large, small = radii.small,
                  one_minus_ratio = radii.one_minus_ratio](double x, double y) -> SurfacePoint {
                   const double along_a = c * x + s * y;
                   const double along_b = c * y - s * x;
                   const double p = pressure.pressure(along_a, along_b);
                   const double u = pressure.displacement(along_a, along_b, modulus);
                   const double height = along_a * along_a / (2 * large) + along_b * along_b / (2 * small);
                   const double gap = p > 0 ? 0 : std::max(height - approach + u, 0.);
                   // The semi-axes carry a unit, the coordinates those of r and the direction: p feels it by its slope.
                   const double rho2 = std::pow(along_a / pressure.a, 2) + std::pow(along_b / pressure.b, 2);
                   const double r = std::hypot(x, y);
                   const double turned =
                       std::min(direction.error * (2 * std::fabs(along_a * along_b) + direction.error * r * r), r * r);
                   const double b_a = pressure.b / pressure.a;
                   const double coordinates = 4 * unit * r / pressure.b *
                                              (std::fabs(along_a) / pressure.a * b_a + std::fabs(along_b) / pressure.b);
                   const double moved =
                       16 * unit * rho2 + coordinates + turned / (pressure.b * pressure.b) * one_minus_b_a * (1 + b_a);
                   const double p0 = pressure.peak_pressure;
                   const double p_error =
                       rho2 < 1 + moved ? 4 * unit * p + p0 * std::min(std::sqrt(moved), moved * p0 / p) : 0;
                   const double height_error =
                       8 * unit * height + 4 * unit * r * (std::fabs(along_a) / large + std::fabs(along_b) / small) +
                       turned * one_minus_ratio / (2 * small);
                   const double u_error = 8 * unit * (approach + u) + 2 * height_error / std::max(1., rho2);
                   return {{p, p_error}, {u, u_error}, {gap, p > 0 ? 0 : u_error + height_error}};
                 }};
  add_approximation(result, e.normal_force, radii, modulus);
  add_circles(result, radii);
  warn_if_steep(result.answer, Steepness::of_ellipse(first, second, radii, direction.angle, e.a, e.b));
  return result;
}

}  // namespace patchgrip::cli
