// One patch of every exact type, for what holds of them all.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/line_load.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/sampled/pressure_grid.h>
#include <patchgrip/friction/sampled/pressure_mesh.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/stamp_disc.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>
#include <patchgrip/tests/friction/shapes.h>

namespace patchgrip::friction {

using TestedPatch =
    std::variant<HertzDisc, FlatPunchDisc, UniformDisc, Ring, PowerDisc, XydasKaoDisc, StampDisc, HertzEllipse,
                 LineLoad, Rectangle, Polygon, PressureGrid, PressureMesh, Placed<HertzDisc>, Placed<HertzEllipse>,
                 Placed<LineLoad>, Placed<Ring>, Placed<Polygon>, Placed<Rectangle>, Several>;

struct NamedPatch {
  std::string name;
  TestedPatch patch;
  std::vector<Pole> landmarks;  // rim, edges and vertices: where pressures end
  bool round_about_origin = false;

  Twist at_centroid(const Twist& v) const {
    const PressureMoments s = moments();
    return {v.vx - v.w * s.y, v.vy + v.w * s.x, v.w};
  }
  PressureMoments moments() const {
    return std::visit([](const auto& p) { return p.moments(); }, patch);
  }
  double area_radius() const {
    return std::visit([](const auto& p) { return p.area_radius(); }, patch);
  }
  // The radius of gyration of what has no area.
  double size() const { return area_radius() > 0 ? area_radius() : std::sqrt(moments().polar); }
  bool is_line() const { return area_radius() == 0; }
  double dissipation(const Twist& v) const {
    return std::visit([&](const auto& p) { return p.dissipation(v); }, patch);
  }
  Wrench gradient(const Twist& v) const {
    return std::visit([&](const auto& p) { return p.gradient(v); }, patch);
  }
  BoundedWrench bounded_gradient(const Twist& v) const {
    return std::visit([&](const auto& p) { return p.bounded_gradient(v); }, patch);
  }
  Hessian hessian(const Twist& v) const {
    return std::visit([&](const auto& p) { return p.hessian(v); }, patch);
  }
};

inline std::vector<Pole> elliptic_rim(double a, double b, double x = 0, double y = 0) {
  std::vector<Pole> result;
  for (int i = 0; i < 8; ++i) {
    const double phi = std::numbers::pi * i / 4;
    result.push_back({x + a * std::cos(phi), y + b * std::sin(phi)});
  }
  return result;
}

inline std::vector<Pole> rim(double radius, double x = 0, double y = 0) { return elliptic_rim(radius, radius, x, y); }

inline std::vector<Pole> corners_and_sides(const PointRing& ring, double x = 0, double y = 0) {
  std::vector<Pole> result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    result.push_back({x + p.x, y + p.y});
    result.push_back({x + (p.x + q.x) / 2, y + (p.y + q.y) / 2});
  }
  return result;
}

inline const std::vector<NamedPatch>& every_patch() {
  static const std::vector<NamedPatch> patches = [] {
    std::vector<NamedPatch> all;
    const auto disc = [&](const char* name, const auto& patch) {
      all.push_back({name, patch, rim(patch.radius()), true});
    };
    disc("HertzDisc", HertzDisc::of_radius(0.0037));
    disc("FlatPunchDisc", FlatPunchDisc::of_radius(1));
    disc("UniformDisc", UniformDisc::of_radius(0.3));
    disc("Ring", Ring::of_radius(20));
    disc("PowerDiscSingular", PowerDisc::of_radius(0.07, -0.3));
    disc("PowerDiscSmooth", PowerDisc::of_radius(5, 2.5));
    disc("XydasKaoDisc", XydasKaoDisc::of_radius(0.01, 0.7));
    disc("StampDisc", StampDisc::of_punches(
                          0.01, [](double s) { return 2 * s / (0.01 * 0.01); }, 1));
    const auto ellipse = [&](const char* name, double a, double b) {
      all.push_back({name, HertzEllipse::of_semi_axes(a, b), elliptic_rim(a, b)});
    };
    ellipse("HertzEllipse", 0.02, 0.03);
    ellipse("HertzEllipseAlmostRound", 1, 1.0001);
    ellipse("HertzEllipseSlender", 0.5, 0.0004);
    all.push_back({"LineLoad", LineLoad::of_length(0.3), {{-0.15, 0}, {-0.05, 0}, {0, 0}, {0.15, 0}}});
    all.push_back({"Rectangle", Rectangle::of_sides(0.3, 0.05), corners_and_sides(box(-0.15, -0.025, 0.15, 0.025))});
    for (const Shape& shape : {triangle, l_shape, frame, comb, slender_100}) {
      all.push_back({shape.name, shape.patch(), corners_and_sides(shape.outer)});
    }
    all.push_back({"PressureGrid", PressureGrid::exact({3, 2, 0.1, 0.05, -0.12, -0.04, {1, 4, 2, 0, 3, 1}}),
                   corners_and_sides(box(-0.12, -0.04, 0.18, 0.06))});
    all.push_back({"PressureMesh",
                   PressureMesh::linear({{{0, 0}, {3, 0}, {3, 2}, {0, 2}}, {{0, 1, 2}, {0, 2, 3}}}, {1, 3, 0, 2}),
                   corners_and_sides(box(0, 0, 3, 2))});
    all.push_back({"PlacedHertzDisc", Placed(HertzDisc::of_radius(0.5), 3, -2), rim(0.5, 3, -2)});
    all.push_back(
        {"PlacedHertzEllipse", Placed(HertzEllipse::of_semi_axes(0.5, 0.1), 3, -2), elliptic_rim(0.5, 0.1, 3, -2)});
    all.push_back({"PlacedRing", Placed(Ring::of_radius(0.5), -0.25, 1), rim(0.5, -0.25, 1)});
    all.push_back({"PlacedPolygon", Placed(l_shape.patch(), 0.5, 2), corners_and_sides(l_shape.outer, 0.5, 2)});
    const Placed turned_rectangle(Rectangle::of_sides(0.3, 0.05), PlanarFrame{-1, 0.4, 0.7});
    const PointRing ends = moved(turned({{-1, 0}, {1, 0}}, 0.7), 0.5, -0.25);
    all.push_back(
        {"TurnedLineLoad", Placed(LineLoad::of_length(2), PlanarFrame{0.5, -0.25, 0.7}), corners_and_sides(ends)});
    const auto sides = moved(turned(box(-0.15, -0.025, 0.15, 0.025), 0.7), -1, 0.4);
    all.push_back({"TurnedRectangle", turned_rectangle, corners_and_sides(sides)});
    all.push_back({"Several",
                   Several::of_parts({{turned_rectangle, 2, 0.4}, {Placed(HertzDisc::of_radius(0.5), 0.5, 1), 1, 0.9}}),
                   corners_and_sides(sides)});
    return all;
  }();
  return patches;
}

}  // namespace patchgrip::friction
