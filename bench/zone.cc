#include <patchgrip/bench/zone.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <patchgrip/bench/random.h>

namespace patchgrip::bench {
namespace {

using friction::Point;
using std::numbers::pi, std::numbers::sqrt3;

Box joined(const Box& a, const Box& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Box nowhere{infinity, infinity, -infinity, -infinity};

void add(Zone& zone, const Zone& part, double share) {
  for (Strip s : part.strips) {
    s.pressure = [share, whole = std::move(s.pressure)](double x, double y) { return share * whole(x, y); };
    zone.strips.push_back(std::move(s));
  }
  for (const LoadedCurve& c : part.curves) zone.curves.push_back({share * c.share, c.at});
  zone.box = joined(zone.box, part.box);
}

Point in_direction(const Point& from, double distance, double angle) {
  return {from.x + distance * std::cos(angle), from.y + distance * std::sin(angle)};
}

// visit(x, y) for the midpoints of n x n cells.
template <class Visit>
void for_every_midpoint(const Box& box, std::size_t n, const Visit& visit) {
  const double dx = (box.x1 - box.x0) / static_cast<double>(n), dy = (box.y1 - box.y0) / static_cast<double>(n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      visit(box.x0 + (static_cast<double>(i) + 0.5) * dx, box.y0 + (static_cast<double>(j) + 0.5) * dy);
    }
  }
}

}  // namespace

double Zone::size() const noexcept { return std::hypot(box.x1 - box.x0, box.y1 - box.y0) / 2; }

double Zone::pressure(double x, double y) const {
  double sum = 0;
  for (const Strip& s : strips) {
    if (x > s.from && x <= s.to && y > s.low(x) && y < s.high(x)) sum += s.pressure(x, y);
  }
  return sum;
}

Point Zone::on_rim(std::mt19937_64& random) const {
  const auto draw = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random); };
  const std::size_t k = draw(strips.size() + curves.size());
  if (k >= strips.size()) return curves[k - strips.size()].at(uniform(random, 0, 1));
  const Strip& s = strips[k];
  const std::size_t side = draw(4);
  const double x = side == 0 ? s.from : side == 1 ? s.to : uniform(random, s.from, s.to);
  if (side < 2) return {x, uniform(random, s.low(x), std::nextafter(s.high(x), infinity))};
  return {x, side == 2 ? s.low(x) : s.high(x)};
}

Zone ellipse_zone(double a, double b, const RoundPressure& pressure) {
  const auto height = [a, b](double x) { return b * std::sqrt(std::max(0.0, (1 - x / a) * (1 + x / a))); };
  const auto at = [a, b, pressure](double x, double y) {
    return pressure(std::min(1.0, x * x / (a * a) + y * y / (b * b))) / (pi * a * b);
  };
  return {{{-a, a, [height](double x) { return -height(x); }, height, at}}, {}, {-a, -b, a, b}};
}

Zone boxes_zone(const std::vector<Box>& boxes, const std::vector<double>& pressures) {
  double force = 0;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    force += pressures[k] * (boxes[k].x1 - boxes[k].x0) * (boxes[k].y1 - boxes[k].y0);
  }
  Zone zone{{}, {}, nowhere};
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const auto constant = [](double value) { return [value](double) { return value; }; };
    const Box& b = boxes[k];
    zone.strips.push_back(
        {b.x0, b.x1, constant(b.y0), constant(b.y1), [p = pressures[k] / force](double, double) { return p; }});
    zone.box = joined(zone.box, b);
  }
  return zone;
}

Zone hexagon_zone(double radius) {
  const double apothem = sqrt3 / 2 * radius, top = 2 / (sqrt3 * radius * radius);
  const auto height = [=](double x) { return std::clamp(sqrt3 * (radius - std::fabs(x)), 0.0, apothem); };
  const auto pressure = [=](double x, double y) {
    const double outward = std::max(std::fabs(y), sqrt3 / 2 * std::fabs(x) + std::fabs(y) / 2);
    return top * std::max(0.0, 1 - outward / apothem);
  };
  Zone zone{{}, {}, {-radius, -apothem, radius, apothem}};
  for (const auto& [from, to] : {std::pair{-1.0, -0.5}, {-0.5, 0.0}, {0.0, 0.5}, {0.5, 1.0}}) {
    zone.strips.push_back({from * radius, to * radius, [=](double x) { return -height(x); }, height, pressure});
  }
  return zone;
}

Zone ring_zone(double radius) {
  const auto at = [=](double t) { return in_direction({}, radius, 2 * pi * t); };
  return {{}, {{1, at}}, {-radius, -radius, radius, radius}};
}

Zone line_zone(double length) {
  const auto at = [=](double t) { return Point{(t - 0.5) * length, 0}; };
  return {{}, {{1, at}}, {-length / 2, 0, length / 2, 0}};
}

Zone moved(const Zone& zone, double dx, double dy) {
  Zone result{{}, {}, {zone.box.x0 + dx, zone.box.y0 + dy, zone.box.x1 + dx, zone.box.y1 + dy}};
  for (const Strip& s : zone.strips) {
    result.strips.push_back({s.from + dx, s.to + dx, [=, f = s.low](double x) { return f(x - dx) + dy; },
                             [=, f = s.high](double x) { return f(x - dx) + dy; },
                             [=, f = s.pressure](double x, double y) { return f(x - dx, y - dy); }});
  }
  for (const LoadedCurve& c : zone.curves) {
    result.curves.push_back({c.share, [=, at = c.at](double t) {
                               const Point p = at(t);
                               return Point{p.x + dx, p.y + dy};
                             }});
  }
  return result;
}

Zone sum_of(double share, const Zone& first, const Zone& second) {
  Zone zone{{}, {}, nowhere};
  add(zone, first, share);
  add(zone, second, 1 - share);
  return zone;
}

PointSum point_sum(const Zone& zone, std::size_t n) {
  std::vector<PointLoad> points;
  if (!zone.strips.empty()) {
    for_every_midpoint(zone.box, n, [&](double x, double y) {
      const double p = zone.pressure(x, y);
      if (p > 0) points.push_back({x, y, p});
    });
  }
  for (const LoadedCurve& c : zone.curves) {
    for (std::size_t i = 0; i < n * n; ++i) {
      const Point p = c.at((static_cast<double>(i) + 0.5) / static_cast<double>(n * n));
      points.push_back({p.x, p.y, c.share});
    }
  }
  double sum = 0;
  for (const PointLoad& p : points) sum += p.share;
  for (PointLoad& p : points) p.share /= sum;
  return PointSum(std::move(points));
}

friction::PressureCells cells_of(const Zone& zone, std::size_t n) {
  const Box& b = zone.box;
  const auto sides = static_cast<double>(n);
  friction::PressureCells cells{n, n, (b.x1 - b.x0) / sides, (b.y1 - b.y0) / sides, b.x0, b.y0, {}};
  for_every_midpoint(b, n, [&](double x, double y) { cells.pressures.push_back(zone.pressure(x, y)); });
  return cells;
}

std::vector<PoleSet> poles_about(const Zone& zone, std::size_t count) {
  std::mt19937_64 random(1);
  PoleSet near{"near", {}, {}}, rim{"rim", {}, {}}, far{"far", {}, {}};
  const auto add = [](PoleSet& set, const Point& p) {
    set.x.push_back(p.x);
    set.y.push_back(p.y);
  };
  const double size = zone.size();
  const Box& b = zone.box;
  const double margin = std::max(b.x1 - b.x0, b.y1 - b.y0) / 4;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = uniform(random, b.x0 - margin, b.x1 + margin);
    add(near, {x, uniform(random, b.y0 - margin, b.y1 + margin)});
    const Point on = zone.on_rim(random);
    add(rim, in_direction(on, size * log_uniform(random, 1e-15, 0.5), uniform(random, -pi, pi)));
    add(far, in_direction({}, size * log_uniform(random, 10, 1e6), uniform(random, -pi, pi)));
  }
  return {near, rim, far};
}

}  // namespace patchgrip::bench
