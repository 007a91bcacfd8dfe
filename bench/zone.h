// A patch as methods see it that know nothing of it: where it carries which pressure, for the normal force 1.
//
// Units    [m]; pressure [1/m^2]; the share of a curve [1], spread evenly over its parameter from 0 to 1.
#pragma once

#include <cstddef>
#include <functional>
#include <random>
#include <vector>

#include <patchgrip/bench/point_sum.h>
#include <patchgrip/bench/poles.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/sampled/pressure_grid.h>

namespace patchgrip::bench {

// low(x) < y < high(x) for from < x < to.
struct Strip {
  double from, to;
  std::function<double(double x)> low, high;
  std::function<double(double x, double y)> pressure;
};

struct LoadedCurve {
  double share;
  std::function<friction::Point(double t)> at;
};

struct Box {
  double x0, y0, x1, y1;
};

struct Zone {
  std::vector<Strip> strips;
  std::vector<LoadedCurve> curves;
  Box box;

  double size() const noexcept;                    // half the diagonal of the box
  double pressure(double x, double y) const;       // of the strips
  friction::Point on_rim(std::mt19937_64&) const;  // of any strip, or on any curve
};

using RoundPressure = std::function<double(double square)>;  // of (r / a)^2, its mean over the disc 1

Zone ellipse_zone(double a, double b, const RoundPressure& pressure);
// Uniform on the boxes, pressures in any unit.
Zone boxes_zone(const std::vector<Box>& boxes, const std::vector<double>& pressures);
// A pyramid over a regular hexagon, its corners `radius` from the middle, two of them on the x axis.
Zone hexagon_zone(double radius);
Zone ring_zone(double radius);
Zone line_zone(double length);
// Moved by (x, y).
Zone moved(const Zone& zone, double x, double y);
Zone sum_of(double share, const Zone& first, const Zone& second);

// Midpoints of n x n cells over the box, or n x n points on the curves, their shares scaled to the sum 1.
PointSum point_sum(const Zone& zone, std::size_t n);
// The pressures at those midpoints, for the cells about them.
friction::PressureCells cells_of(const Zone& zone, std::size_t n);

// With R = zone.size():
//     near   even over the box, a quarter of its longer side added all around
//     rim    beside a point of the rim or the curve, log-uniform from 1e-15 R to R / 2, in any direction
//     far    log-uniform from 10 R to 1e6 R about the origin
std::vector<PoleSet> poles_about(const Zone& zone, std::size_t count);

}  // namespace patchgrip::bench
