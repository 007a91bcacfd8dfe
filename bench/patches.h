// The patches that wrenches and gauges are compared on: each with its zone and its grad D in 50 digits. The centre of
// pressure is the origin.
//
// Units    [m]; normal force 1 N, mu = 1.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <boost/math/special_functions/beta.hpp>

#include <patchgrip/bench/zone.h>
#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/kernels/round_functions.h>
#include <patchgrip/friction/line_load.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/sampled/pressure_mesh.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/stamp_disc.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>
#include <patchgrip/tests/friction/ellipse_reference.h>
#include <patchgrip/tests/friction/frame_reference.h>
#include <patchgrip/tests/friction/line_reference.h>
#include <patchgrip/tests/friction/sampled_reference.h>
#include <patchgrip/tests/friction/stack_reference.h>

namespace patchgrip::bench {

constexpr double step = 0x1p-10;  // 0.98 mm: multiples of it, their sums and products are exact

template <class Reference>
friction::Gradient50 gradient_of(Reference reference) {
  return [reference = std::move(reference)](const auto& vx, const auto& vy, const auto& w) {
    return reference.gradient(vx, vy, w);
  };
}

template <class Source>
friction::Gradient50 round_gradient(Source source, double radius) {
  return [source = std::move(source), radius](const auto& vx, const auto& vy, const auto& w) {
    return friction::round_wrench(source, radius, vx, vy, w);
  };
}

inline friction::Gradient50 power_gradient(double exponent, double radius) {
  return round_gradient(friction::kernels::PowerFamily<friction::Real50>{friction::Real50(exponent)}, radius);
}

// (n + 1/2) (1 - r^2 / a^2)^(n - 1/2)
inline RoundPressure power_pressure(double n) {
  return [n](double square) { return (n + 0.5) * std::pow(1 - square, n - 0.5); };
}

// Constant on boxes that meet at most along their sides.
inline friction::Gradient50 boxes_gradient(const std::vector<Box>& boxes, const std::vector<double>& pressures) {
  friction::SampledReference reference;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const Box& b = boxes[k];
    reference.add({{{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}}, pressures[k], 0, 0});
  }
  return gradient_of(reference);
}

// visit(name, patch, zone, gradient in 50 digits, poles or loads that are judged)
template <class Visit>
void for_every_round_patch(const Visit& visit) {
  constexpr double a = 5 * step;
  constexpr std::size_t many = 200, few = 30;
  const auto power_law = [&](const char* name, const auto& patch, double n) {
    visit(name, patch, ellipse_zone(a, a, power_pressure(n)), power_gradient(n, a), many);
  };
  power_law("hertz_disc", friction::HertzDisc::of_radius(a), 1);
  power_law("flat_punch_disc", friction::FlatPunchDisc::of_radius(a), 0);
  power_law("uniform_disc", friction::UniformDisc::of_radius(a), 0.5);
  visit("ring", friction::Ring::of_radius(a), ring_zone(a), power_gradient(-0.5, a), many);
  power_law("power_disc", friction::PowerDisc::of_radius(a, 0.3), 0.3);

  constexpr double alpha = 1.8;
  const double top = alpha / (2 * boost::math::beta(2 / alpha, 1 + 1 / alpha));
  const auto xydas_kao = [=](double square) { return top * std::pow(1 - std::pow(square, alpha / 2), 1 / alpha); };
  visit("xydas_kao_disc", friction::XydasKaoDisc::of_radius(a, alpha), ellipse_zone(a, a, xydas_kao),
        round_gradient(friction::StackReference<friction::Real50>(alpha), a), few);

  // A stamp ~ r^4: its pressure is 5/3 of the power law n = 1 less 2/3 of n = 2.
  const auto share = [=](double s) { return 5 / a * std::pow(s / a, 4); };
  const auto quartic = [](double square) { return 5. / 6 * std::sqrt(1 - square) * (1 + 2 * square); };
  visit("stamp_disc", friction::StampDisc::of_punches(a, share, 4), ellipse_zone(a, a, quartic),
        friction::weighted_mean({{power_gradient(1, a), 5}, {power_gradient(2, a), -2}}), many);
}

template <class Visit>
void for_every_other_patch(const Visit& visit) {
  constexpr std::size_t many = 200;
  constexpr double a = 5 * step;
  for (const auto& [name, b] : {std::pair{"hertz_ellipse_3", a / 3}, {"hertz_ellipse_100", a / 100}}) {
    visit(name, friction::HertzEllipse::of_semi_axes(a, b), ellipse_zone(a, b, power_pressure(1)),
          gradient_of(friction::EllipseReference(a, b)), many);
  }
  const std::vector<Box> side{{-10 * step, -2.5 * step, 10 * step, 2.5 * step}};
  visit("rectangle", friction::Rectangle::of_sides(20 * step, 5 * step), boxes_zone(side, {1}),
        boxes_gradient(side, {1}), many);

  const double left = -12.5 * step, low = -7.5 * step;
  const auto corner = [&](int x, int y) { return friction::Point{left + x * step, low + y * step}; };
  const std::vector<Box> legs{{left, low, left + 30 * step, low + 10 * step},
                              {left, low + 10 * step, left + 10 * step, low + 20 * step}};
  visit("l_shape",
        friction::Polygon::uniform(
            {corner(0, 0), corner(30, 0), corner(30, 10), corner(10, 10), corner(10, 20), corner(0, 20)}),
        boxes_zone(legs, {1, 1}), boxes_gradient(legs, {1, 1}), many);

  // Falls off in steps from a corner.
  friction::PressureCells cells{4, 3, 3 * step, 4 * step, -1.625 * 3 * step, -1.125 * 4 * step, {}};
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < cells.nx * cells.ny; ++k) {
    const std::size_t i = k % cells.nx, j = k / cells.nx;
    const double x = cells.x0 + static_cast<double>(i) * cells.dx, y = cells.y0 + static_cast<double>(j) * cells.dy;
    boxes.push_back({x, y, x + cells.dx, y + cells.dy});
    cells.pressures.push_back(i + 2 * j < 3 ? 4 : 1);
  }
  visit("pressure_grid", friction::PressureGrid::exact(cells), boxes_zone(boxes, cells.pressures),
        boxes_gradient(boxes, cells.pressures), many);

  friction::Triangulation mesh{{{0, 0}}, {}};
  std::vector<double> nodal{1};
  for (std::size_t k = 0; k < 6; ++k) {
    const double angle = static_cast<double>(k) * std::numbers::pi / 3;
    mesh.points.push_back({a * std::cos(angle), a * std::sin(angle)});
    mesh.triangles.push_back({0, k + 1, (k + 1) % 6 + 1});
    nodal.push_back(0);
  }
  visit("pressure_mesh", friction::PressureMesh::linear(mesh, nodal), hexagon_zone(a),
        gradient_of(friction::SampledReference::linear(mesh, nodal)), many);

  visit("line_load", friction::LineLoad::of_length(10 * step), line_zone(10 * step),
        gradient_of(friction::LineReference(10 * step)), many);

  const std::vector<Box> block{{2 * step, -5 * step, 6 * step, 5 * step}};
  const friction::PlanarFrame at_disc{-12 * step, 0, 0}, at_block{4 * step, 0, 0};
  visit("two_patches",
        friction::Several::of_parts(
            {{friction::Placed(friction::HertzDisc::of_radius(a), at_disc), 0.25},
             {friction::Placed(friction::Rectangle::of_sides(4 * step, 10 * step), at_block), 0.75}}),
        sum_of(0.25, moved(ellipse_zone(a, a, power_pressure(1)), at_disc.x, 0), boxes_zone(block, {1})),
        friction::weighted_mean(
            {{friction::in_frame(power_gradient(1, a), at_disc), 1}, {boxes_gradient(block, {1}), 3}}),
        many);
}

}  // namespace patchgrip::bench
