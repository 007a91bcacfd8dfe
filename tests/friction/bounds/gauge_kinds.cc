// Gauges of loads on any patch, and the slips that they start, with the errors of slip_error.h.
//
// Regions by the pole of the slip: near and far; facet, where many loads start one slip about a point load, and ridge,
// where no one slip is known.
#include <cmath>
#include <memory>
#include <string_view>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/limit_surface/slip_error.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/friction/bounds/framed_patches.h>
#include <patchgrip/tests/friction/bounds/kind.h>
#include <patchgrip/tests/friction/limit_surface/gauge_reference.h>
#include <patchgrip/tests/friction/limit_surface/loads.h>
#include <patchgrip/tests/friction/limit_surface/point_loads.h>

namespace patchgrip::friction::bounds {
namespace {

std::string_view region_of(GaugeStatus status, bool far) {
  if (status == GaugeStatus::facet) return "facet";
  return status == GaugeStatus::converged ? region(far) : "ridge";
}

template <Patch P>
Case gauge_case(const LimitSurface<P>& surface, const GaugeReference& reference, const Wrench& t) {
  const Gauge g = surface.gauge(t);
  const auto truth = reference.slip(t, g.twist);
  if (!truth) return {};
  const PressureFrame& frame = surface.frame();
  const SlipError error = slip_error(g, t, view(surface.patch()), frame);
  const auto length = [](const Real50& x, const Real50& y) { return static_cast<double>(sqrt(x * x + y * y)); };
  const bool far = length(truth->x - frame.x, truth->y - frame.y) > 2 * frame.length;
  return {region_of(g.status, far),
          {judged("gauge", g, truth->gauge, truth->gauge),
           {"speed", error.speed, length(truth->twist[0] - g.twist.vx, truth->twist[1] - g.twist.vy)},
           {"spin", error.spin, static_cast<double>(abs(truth->twist[2] - g.twist.w))},
           {"pole", error.pole_error, length(truth->x - error.pole.x, truth->y - error.pole.y)}}};
}

FramedPatch draw_disc(Draw& draw) {
  switch (draw.integer(0, 3)) {
    case 0:
      return draw_framed_disc<HertzDisc>(draw, 1);
    case 1:
      return draw_framed_disc<FlatPunchDisc>(draw, 0);
    case 2:
      return draw_framed_disc<UniformDisc>(draw, 0.5);
    default:
      return draw_framed_disc<Ring>(draw, -0.5);
  }
}

FramedPatch draw_needle(Draw& draw) {
  if (draw.coin()) return draw_framed_ellipse(draw, 1e3, 1e6);
  return draw_polygon(draw, draw.log_uniform(1e-6, 1e-3));
}

// Two to four feet, the first bearing up to 1e5 of another, and sometimes a disc, 1 from the others or less.
PointScene draw_feet(Draw& draw) {
  PointScene scene{"", {{draw.uniform(-1, 1), draw.uniform(-1, 1), 1}}};
  const auto part = [&](double radius) {
    scene.parts.push_back({draw.uniform(-1, 1), draw.uniform(-1, 1), draw.log_uniform(1e-5, 1), radius});
  };
  for (int k = draw.integer(1, 3); k > 0; --k) part(0);
  if (draw.integer(0, 3) == 0) part(draw.log_uniform(1e-3, 1));
  scene.angle = std::atan2(scene.parts[1].y - scene.parts[0].y, scene.parts[1].x - scene.parts[0].x);
  return scene;
}

std::function<Case(Draw&)> feet(Draw& draw) {
  const PointScene scene = draw_feet(draw);
  return [scene, surface = LimitSurface(scene.patch()), reference = scene.reference()](Draw& d) {
    constexpr LoadKind kinds[] = {LoadKind::exact, LoadKind::nearly_exact, LoadKind::any, LoadKind::rim_of_facet};
    return gauge_case(surface, reference, draw_load(d.engine(), kinds[d.index(4)], scene, surface.patch()));
  };
}

Kind gauge_kind(const char* name, FramedPatch (*make)(Draw&)) {
  constexpr int uses = 5;
  const auto cases = [make](Draw& draw) -> std::function<Case(Draw&)> {
    const FramedPatch p = make(draw);
    const PressureMoments s = p.patch.moments();
    return [s, surface = LimitSurface(p.patch), reference = GaugeReference(p.gradient, {}, s)](Draw& d) {
      return gauge_case(surface, reference, draw_load(d.engine(), s));
    };
  };
  return {name, reuse(uses, cases), false};
}

}  // namespace

Kinds gauge_kinds() {
  return {gauge_kind("gauge_disc", draw_disc),
          gauge_kind("gauge_ellipse", [](Draw& draw) { return draw_framed_ellipse(draw, 1 + 1e-6, 1e3); }),
          gauge_kind("gauge_polygon", [](Draw& draw) { return draw_polygon(draw, draw.log_uniform(1e-2, 1)); }),
          gauge_kind("gauge_needle", draw_needle),
          gauge_kind("gauge_several", [](Draw& draw) { return draw_several(draw, false); }),
          {"gauge_feet", reuse(5, feet), false}};
}

}  // namespace patchgrip::friction::bounds
