// Discs and rings, about their own centre and away from it.
#include <memory>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/seed_hertz_disc.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>
#include <patchgrip/tests/friction/bounds/exact_friction.h>
#include <patchgrip/tests/friction/bounds/kind.h>
#include <patchgrip/tests/friction/stack_reference.h>

namespace patchgrip::friction::bounds {
namespace {

using kernels::PowerFamily;
// 30 digits are enough to judge errors of 1e-16, and the stack of discs is slow.
using Real30 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<30>, boost::multiprecision::et_off>;

template <class P, class Source>
Case round_case(Draw& draw, const P& patch, const Source& source, const Real50& polar) {
  const double a = patch.radius();
  const auto [twist, far] = draw_twist(draw, 0, 0, a, [a](Draw& d) { return on_rim(d, a); });
  const DrawnLaw drawn = draw_law(draw);
  const Wrench50 g = round_wrench(source, a, twist);
  return judged(far, friction_wrench(drawn.law, drawn.normal_force, patch, twist),
                exact_friction(drawn, {0, 0, polar * a * a}, g, twist));
}

template <class P, class Source>
Case placed_case(Draw& draw, const P& disc, const Source& source, const Real50& polar) {
  const double a = disc.radius();
  const double x = a * draw.uniform(-20, 20);
  const double y = a * draw.uniform(-20, 20);
  const Placed<P> patch(disc, x, y);
  const auto [twist, far] = draw_twist(draw, x, y, a);
  const DrawnLaw drawn = draw_law(draw);
  const Real50 vx = twist.vx - Real50(twist.w) * y;
  const Real50 vy = twist.vy + Real50(twist.w) * x;
  Wrench50 g = round_wrench(source, a, vx, vy, twist.w);
  g.m += x * g.fy - y * g.fx;
  return judged(far, friction_wrench(drawn.law, drawn.normal_force, patch, twist),
                exact_friction(drawn, {x, y, polar * a * a}, g, twist));
}

template <class P>
Kind disc_kind(const std::string& name, double n) {
  const auto source = std::make_shared<PowerFamily<Real50>>(n);
  return {name, [source, polar = 1 / (Real50(n) + 1.5)](Draw& draw) {
            return round_case(draw, P::of_radius(draw.log_uniform(1e-6, 1e2)), *source, polar);
          }};
}

template <class P>
Kind placed_kind(const std::string& name, double n) {
  const auto source = std::make_shared<PowerFamily<Real50>>(n);
  return {name, [source, polar = 1 / (Real50(n) + 1.5)](Draw& draw) {
            return placed_case(draw, P::of_radius(draw.log_uniform(1e-4, 1)), *source, polar);
          }};
}

std::function<Case(Draw&)> power_disc(Draw& draw) {
  const double n = draw.coin() ? draw.uniform(-0.5, 3) : draw.uniform(-0.5, 20);
  const auto source = std::make_shared<PowerFamily<Real50>>(n);
  const PowerDisc patch = PowerDisc::of_radius(draw.log_uniform(1e-6, 1e2), n);
  return [=](Draw& d) { return round_case(d, patch, *source, 1 / (Real50(n) + 1.5)); };
}

std::function<Case(Draw&)> xydas_kao_disc(Draw& draw) {
  const double alpha = draw.coin() ? draw.uniform(0.5, 3) : draw.log_uniform(0.5, 50);
  const auto source = std::make_shared<StackReference<Real30>>(alpha);
  const XydasKaoDisc patch = XydasKaoDisc::of_radius(draw.log_uniform(1e-6, 1e2), alpha);
  return [=](Draw& d) { return round_case(d, patch, *source, Real50(source->polar())); };
}

}  // namespace

Kinds round_kinds() {
  // The seed's fit is mostly far better than its largest error.
  Kind seed = disc_kind<SeedHertzDisc>("seed_hertz_disc", 1);
  seed.tight = false;
  return {disc_kind<HertzDisc>("hertz_disc", 1),
          disc_kind<FlatPunchDisc>("flat_punch_disc", 0),
          disc_kind<UniformDisc>("uniform_disc", 0.5),
          disc_kind<Ring>("ring", -0.5),
          {"power_disc", reuse(500, power_disc)},
          {"xydas_kao_disc", reuse(500, xydas_kao_disc)},
          placed_kind<HertzDisc>("placed_hertz_disc", 1),
          placed_kind<Ring>("placed_ring", -0.5),
          seed};
}

}  // namespace patchgrip::friction::bounds
