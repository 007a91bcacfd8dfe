// Patches that gauges are compared on: disc, ellipse, polygon, parts and samples, each with its grad D in many digits.
//
// Units    [m]; normal force 1 N, mu = 1.
// Error    truth to 50 digits; of parts and cells their sum in 64 bits, to 1e-18.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <patchgrip/bench/truth.h>
#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/sampled/pressure_grid.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>

namespace patchgrip::bench {

using Twists = std::span<const friction::Twist>;
using Outline = std::vector<friction::Point>;

constexpr double disc_radius = 5e-3;

inline Outline box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

// Uniform pressures on several outlines, each with its share of the normal force.
inline Truth shared_truth(const std::vector<Outline>& outlines, const std::vector<double>& shares, Twists twists) {
  std::vector<std::array<long double, 3>> sums(twists.size());
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const Truth part = polygon_truth(outlines[k], twists);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const auto& [head, tail] = part[i];
      const auto share = static_cast<long double>(shares[k]);
      sums[i][0] += share * (static_cast<long double>(head.fx) + tail.fx);
      sums[i][1] += share * (static_cast<long double>(head.fy) + tail.fy);
      sums[i][2] += share * (static_cast<long double>(head.m) + tail.m);
    }
  }
  Truth truth;
  for (const auto& s : sums) {
    const auto head = [&](std::size_t i) { return static_cast<double>(s[i]); };
    const auto tail = [&](std::size_t i) { return static_cast<double>(s[i] - head(i)); };
    truth.push_back({{head(0), head(1), head(2)}, {tail(0), tail(1), tail(2)}});
  }
  return truth;
}

// A pressure that falls off in steps from a corner, in 4 x 3 cells.
inline friction::PressureCells stepped_cells() {
  friction::PressureCells cells{4, 3, 3e-3, 4e-3, -6e-3, -6e-3, {}};
  for (std::size_t j = 0; j < cells.ny; ++j) {
    for (std::size_t i = 0; i < cells.nx; ++i) cells.pressures.push_back(i + 2 * j < 3 ? 4 : 1);
  }
  return cells;
}

inline Truth stepped_truth(Twists twists) {
  const friction::PressureCells cells = stepped_cells();
  double sum = 0;
  for (const double p : cells.pressures) sum += p;
  std::vector<Outline> outlines;
  std::vector<double> shares;
  for (std::size_t k = 0; k < cells.pressures.size(); ++k) {
    const double x = cells.x0 + static_cast<double>(k % cells.nx) * cells.dx;
    const double y = cells.y0 + static_cast<double>(k / cells.nx) * cells.dy;
    outlines.push_back(box(x, y, x + cells.dx, y + cells.dy));
    shares.push_back(cells.pressures[k]);
  }
  Truth truth = shared_truth(outlines, shares, twists);
  for (auto& [head, tail] : truth) {
    for (const auto part : {&friction::Wrench::fx, &friction::Wrench::fy, &friction::Wrench::m}) {
      const long double whole = (static_cast<long double>(head.*part) + tail.*part) / sum;
      head.*part = static_cast<double>(whole);
      tail.*part = static_cast<double>(whole - head.*part);
    }
  }
  return truth;
}

// visit(name, patch, truth of twists, loads that are judged).
template <class Visit>
void for_every_patch(const Visit& visit) {
  constexpr std::size_t many = 500, few = 60;
  const auto power_law = [](double n) { return [n](Twists v) { return power_disc_truth(disc_radius, n, v); }; };
  visit("hertz_disc", friction::HertzDisc::of_radius(disc_radius), power_law(1), many);
  visit("uniform_disc", friction::UniformDisc::of_radius(disc_radius), power_law(0.5), many);
  visit("flat_punch_disc", friction::FlatPunchDisc::of_radius(disc_radius), power_law(0), many);
  visit("ring", friction::Ring::of_radius(disc_radius), power_law(-0.5), many);
  visit("power_disc", friction::PowerDisc::of_radius(disc_radius, 0.3), power_law(0.3), many);
  visit(
      "xydas_kao_disc", friction::XydasKaoDisc::of_radius(disc_radius, 1.8),
      [](Twists v) { return xydas_kao_truth(disc_radius, 1.8, v); }, few);
  visit(
      "hertz_ellipse", friction::HertzEllipse::of_semi_axes(10e-3, 2.5e-3),
      [](Twists v) { return hertz_ellipse_truth(10e-3, 2.5e-3, v); }, many);
  visit(
      "rectangle", friction::Rectangle::of_sides(20e-3, 5e-3),
      [](Twists v) { return polygon_truth(box(-10e-3, -2.5e-3, 10e-3, 2.5e-3), v); }, many);
  const Outline l_shape{{0, 0}, {0.03, 0}, {0.03, 0.01}, {0.01, 0.01}, {0.01, 0.02}, {0, 0.02}};
  visit(
      "l_shape", friction::Polygon::uniform(l_shape), [&](Twists v) { return polygon_truth(l_shape, v); }, many);
  const Outline left = box(-20e-3, -5e-3, -10e-3, 5e-3), right = box(10e-3, -10e-3, 15e-3, 10e-3);
  visit(
      "two_patches",
      friction::Several::of_parts(
          {{friction::Polygon::uniform(left), 0.75}, {friction::Polygon::uniform(right), 0.25}}),
      [&](Twists v) {
        return shared_truth({left, right}, {0.75, 0.25}, v);
      },
      many);
  visit("pressure_grid", friction::PressureGrid::exact(stepped_cells()), stepped_truth, many);
}

}  // namespace patchgrip::bench
