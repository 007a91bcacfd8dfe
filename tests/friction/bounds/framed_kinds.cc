// Patches moved and turned, several that share a load, and lines.
#include <cmath>

#include <patchgrip/friction/line_load.h>
#include <patchgrip/tests/friction/bounds/framed_patches.h>
#include <patchgrip/tests/friction/bounds/kind.h>
#include <patchgrip/tests/friction/line_reference.h>

namespace patchgrip::friction::bounds {
namespace {

Case framed_case(Draw& draw, const FramedPatch& p) {
  const auto [twist, far] = draw_twist(draw, p.x, p.y, p.radius);
  const DrawnLaw drawn = draw_law(draw);
  return judged(far, friction_wrench(drawn.law, drawn.normal_force, p.patch, twist),
                exact_friction(drawn, p.moments, p.gradient(twist.vx, twist.vy, twist.w), twist));
}

// Poles are drawn close to the line and to its ends, too.
Case line_case(Draw& draw, bool turned) {
  const double L = draw.log_uniform(1e-6, 1e2);
  const PlanarFrame frame = draw_frame(draw, turned ? 20 * L : 0);
  const LineLoad line = LineLoad::of_length(L);
  const Placed patch(line, frame);
  const LineReference reference(L);
  const Gradient50 own = [reference](const auto& vx, const auto& vy, const auto& w) {
    return reference.gradient(vx, vy, w);
  };
  const auto [twist, far] = draw_twist(draw, frame.x, frame.y, L / 2, [&](Draw& d) -> Pole {
    const double x = d.coin() ? d.uniform(-0.6, 0.6) * L : L / 2 + L * d.sign() * d.log_uniform(1e-16, 0.1);
    const double y = L * d.sign() * d.log_uniform(turned ? 1e-12 : 1e-18, 0.1);
    const double c = turned ? std::cos(frame.angle) : 1, s = turned ? std::sin(frame.angle) : 0;
    return {frame.x + c * x - s * y, frame.y + s * x + c * y};
  });
  const DrawnLaw drawn = draw_law(draw);
  const Real50 polar = Real50(L) * L / 12;
  if (!turned) {
    return judged(far, friction_wrench(drawn.law, drawn.normal_force, line, twist),
                  exact_friction(drawn, {0, 0, polar}, reference.gradient(twist), twist));
  }
  return judged(
      far, friction_wrench(drawn.law, drawn.normal_force, patch, twist),
      exact_friction(drawn, {frame.x, frame.y, polar}, in_frame(own, frame)(twist.vx, twist.vy, twist.w), twist));
}

Kind framed_kind(const char* name, int uses, FramedPatch (*make)(Draw&)) {
  return {name, reuse(uses, [make](Draw& draw) -> std::function<Case(Draw&)> {
            return [patch = make(draw)](Draw& d) { return framed_case(d, patch); };
          })};
}

}  // namespace

Kinds framed_kinds() {
  return {{"line_load", [](Draw& draw) { return line_case(draw, false); }},
          {"turned_line_load", [](Draw& draw) { return line_case(draw, true); }},
          framed_kind("turned_rectangle", 10, draw_turned_rectangle),
          framed_kind("several", 50, [](Draw& draw) { return draw_several(draw, true); })};
}

}  // namespace patchgrip::friction::bounds
