#include <patchgrip/bench/zone_quadrature.h>

#include <gsl/gsl_errno.h>

#include <cmath>

namespace patchgrip::bench {
namespace {

template <class F>
double adaptive_split(const F& f, double from, double at, double to, double tolerance, const GslWorkspace& workspace) {
  if (at <= from || at >= to) return adaptive(f, from, to, tolerance, workspace);
  return adaptive(f, from, at, tolerance, workspace) + adaptive(f, at, to, tolerance, workspace);
}

}  // namespace

ZoneQuadrature::ZoneQuadrature(Zone zone, double tolerance)
    : zone_(std::move(zone)), tolerance_(tolerance), outer_(gsl_workspace()), inner_(gsl_workspace()) {
  gsl_set_error_handler_off();
}

template <class Integrand>
double ZoneQuadrature::integral(const friction::Point& pole, const Integrand& integrand) const {
  double sum = 0;
  for (const Strip& s : zone_.strips) {
    const double width = s.to - s.from;
    const auto column = [&](double x) {
      const auto cell = [&](double y) { return width * s.pressure(x, y) * integrand(x, y); };
      return adaptive_split(cell, s.low(x), pole.y, s.high(x), tolerance_ / 10, inner_) / width;
    };
    sum += adaptive_split(column, s.from, pole.x, s.to, tolerance_, outer_);
  }
  for (const LoadedCurve& c : zone_.curves) {
    const auto along = [&](double t) {
      const friction::Point p = c.at(t);
      return integrand(p.x, p.y);
    };
    sum += c.share * adaptive_split(along, 0, 0.5, 1, tolerance_, outer_);
  }
  return sum;
}

friction::Wrench ZoneQuadrature::gradient(const friction::Twist& v) const {
  const friction::Point pole{-v.vy / v.w, v.vx / v.w};
  const double size = zone_.size();
  const auto direction = [&](double x, double y, auto&& component) {
    const double vx = v.vx - v.w * y, vy = v.vy + v.w * x, speed = std::hypot(vx, vy);
    return speed > 0 ? component(vx / speed, vy / speed) : 0.0;
  };
  const auto force_x = [&](double x, double y) { return direction(x, y, [](double c, double) { return c; }); };
  const auto force_y = [&](double x, double y) { return direction(x, y, [](double, double s) { return s; }); };
  const auto moment = [&](double x, double y) {
    return direction(x, y, [&](double c, double s) { return (x * s - y * c) / size; });
  };
  return {integral(pole, force_x), integral(pole, force_y), size * integral(pole, moment)};
}

}  // namespace patchgrip::bench
