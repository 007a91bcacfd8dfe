// Gauges of round patches to rounding, and cheap gauges with the sides that they state: against 50 digits for Hertz
// discs, against the bracket of any patch's gauge for ellipsoids and quartics.
#include <memory>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/limit_surface/ellipsoid_gauge.h>
#include <patchgrip/friction/limit_surface/fast_hertz_gauge.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/limit_surface/quartic_gauge.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/limit_surface/seed_gauge.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/friction/bounds/framed_patches.h>
#include <patchgrip/tests/friction/bounds/kind.h>
#include <patchgrip/tests/friction/limit_surface/loads.h>
#include <patchgrip/tests/friction/limit_surface/round_gauge_reference.h>

namespace patchgrip::friction::bounds {
namespace {

// What the model says of its value: (1 - deficit) g <= value <= (1 + excess) g.
template <GaugeModel M>
Finding side(std::string_view quantity, const M& model, const Wrench& t, const Real50& exact) {
  const double excess = static_cast<double>(model.value(t) / exact - 1);
  return {quantity, excess > 0 ? model.largest_excess() : model.largest_deficit(), std::fabs(excess)};
}

Case hertz_case(Draw& draw) {
  const double a = draw.log_uniform(1e-6, 1e2);
  Wrench t = draw_load(draw.engine(), {0, 0, 0.4 * a * a});
  // Half of them next to the load that puts the pole on the rim, F = 4 M / a.
  if (draw.coin()) {
    const double F = draw.log_uniform(1e-3, 1e3), direction = draw.angle();
    t = {F * std::cos(direction), F * std::sin(direction),
         draw.sign() * a * F / 4 * (1 + draw.sign() * draw.log_uniform(1e-15, 0.5))};
  }
  static const RoundGaugeReference reference(1);
  const RoundGaugeReference::Result exact = reference.gauge(t, a);
  const HertzGauge hertz = HertzGauge::of_radius(a);
  const FastHertzGauge fast = FastHertzGauge::of_radius(a);
  const SeedGauge seed = SeedGauge::of_radius(a);
  return {region(exact.x > 2),
          {side("hertz", hertz, t, exact.value), side("fast", fast, t, exact.value), side("seed", seed, t, exact.value),
           judged("hertz_bracket", hertz.gauge(t), exact.value, exact.value),
           judged("fast_bracket", fast.gauge(t), exact.value, exact.value),
           judged("seed_bracket", seed.gauge(t), exact.value, exact.value)}};
}

// Of the power family of the exponent n, one for each P.
template <class P>
Case round_case(Draw& draw, double n) {
  static const RoundGaugeReference reference(n);
  const RoundLimitSurface surface(P::of_radius(draw.log_uniform(1e-6, 1e2)));
  const Wrench t = draw_load(draw.engine(), surface.patch().moments());
  const RoundGaugeReference::Result exact = reference.gauge(t, surface.patch().radius());
  return {region(exact.x > 2), {judged("gauge", surface.gauge(t), exact.value, exact.value)}};
}

Case round_gauge(Draw& draw) {
  switch (draw.integer(0, 3)) {
    case 0:
      return round_case<HertzDisc>(draw, 1);
    case 1:
      return round_case<FlatPunchDisc>(draw, 0);
    case 2:
      return round_case<UniformDisc>(draw, 0.5);
    default:
      return round_case<Ring>(draw, -0.5);
  }
}

FramedPatch draw_patch(Draw& draw) {
  switch (draw.integer(0, 4)) {
    case 0:
      return draw_framed_disc<HertzDisc>(draw, 1);
    case 1:
      return draw_framed_disc<Ring>(draw, -0.5);
    case 2:
      return draw_framed_ellipse(draw, 1.001, 100);
    case 3:
      return draw_polygon(draw, draw.log_uniform(1e-2, 1));
    default:
      return draw_several(draw, true);
  }
}

std::function<Case(Draw&)> fitted_gauges(Draw& draw) {
  const AnyPatch patch = draw_patch(draw).patch;
  const EllipsoidGauge axis = EllipsoidGauge::axis(patch), even = EllipsoidGauge::even(patch),
                       inner = EllipsoidGauge::inner(patch), enclosing = EllipsoidGauge::enclosing(patch);
  const QuarticGauge fitted = QuarticGauge::least_squares(patch), quartic = QuarticGauge::even(patch);
  return [=, surface = LimitSurface(patch)](Draw& d) -> Case {
    const Wrench t = draw_load(d.engine(), patch.moments());
    const Gauge truth = surface.gauge(t);
    const auto bracket = [&](std::string_view quantity, const auto& model) {
      return judged(quantity, model.gauge(t), truth.lower, truth.upper);
    };
    return {"any",
            {bracket("axis", axis), bracket("even", even), bracket("inner", inner), bracket("enclosing", enclosing),
             bracket("safe", even.safe()), bracket("quartic_fit", fitted), bracket("quartic", quartic),
             bracket("quartic_safe", quartic.safe())}};
  };
}

}  // namespace

// Their errors are mostly far below the largest, which is what they state.
Kinds cheap_gauge_kinds() {
  return {{"round_gauge", round_gauge, false},
          {"hertz_gauges", hertz_case, false},
          {"fitted_gauges", reuse(20, fitted_gauges), false}};
}

}  // namespace patchgrip::friction::bounds
