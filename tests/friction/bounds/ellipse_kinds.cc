// Hertz ellipses from the circle to needles, about their own centre and away from it.
#include <algorithm>
#include <cmath>

#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/tests/friction/bounds/exact_friction.h>
#include <patchgrip/tests/friction/bounds/kind.h>
#include <patchgrip/tests/friction/ellipse_reference.h>
#include <patchgrip/tests/friction/frame_reference.h>

namespace patchgrip::friction::bounds {
namespace {

// `away` in major semi-axes from the origin.
std::function<Case(Draw&)> ellipse_cases(Draw& draw, double least_aspect, double largest_aspect, double away) {
  const double a = draw.log_uniform(1e-6, 1e2);
  const double aspect = draw.log_uniform(least_aspect, largest_aspect);
  const double b = draw.coin() ? a * aspect : a / aspect;
  const double major = std::max(a, b), minor = std::min(a, b);
  const PlanarFrame frame = draw_frame(draw, away * major);
  const Placed patch(HertzEllipse::of_semi_axes(a, b), frame);
  const EllipseReference reference(a, b);
  const Gradient50 own = [reference](const auto& vx, const auto& vy, const auto& w) {
    return reference.gradient(vx, vy, w);
  };
  const Gradient50 placed = in_frame(own, frame);
  const Real50 polar = (Real50(a) * a + Real50(b) * b) / 5;
  return [=](Draw& d) -> Case {
    const auto on_patch = [&](Draw& s) -> Pole {
      const Pole rim = on_rim(s, 1);
      if (s.coin()) return {a * rim.x, b * rim.y};
      // Next to a long side: a slender ellipse has little else nearby.
      const double along = major * s.uniform(-1.1, 1.1), off = minor * s.log_uniform(0.01, 100) * s.sign();
      return a > b ? Pole{along, off} : Pole{off, along};
    };
    const DrawnLaw drawn = draw_law(d);
    if (away == 0) {
      const auto [twist, far] = draw_twist(d, 0, 0, major, on_patch);
      return judged(far, friction_wrench(drawn.law, drawn.normal_force, patch.patch(), twist),
                    exact_friction(drawn, {0, 0, polar}, own(twist.vx, twist.vy, twist.w), twist));
    }
    const auto [twist, far] = draw_twist(d, frame.x, frame.y, major, [&](Draw& s) -> Pole {
      const Pole p = on_patch(s);
      const double cosine = std::cos(frame.angle), sine = std::sin(frame.angle);
      return {frame.x + cosine * p.x - sine * p.y, frame.y + sine * p.x + cosine * p.y};
    });
    return judged(far, friction_wrench(drawn.law, drawn.normal_force, patch, twist),
                  exact_friction(drawn, {frame.x, frame.y, polar}, placed(twist.vx, twist.vy, twist.w), twist));
  };
}

Kind ellipse_kind(const char* name, double least_aspect, double largest_aspect, double away) {
  return {name, reuse(20, [=](Draw& draw) { return ellipse_cases(draw, least_aspect, largest_aspect, away); })};
}

}  // namespace

Kinds ellipse_kinds() {
  return {ellipse_kind("hertz_ellipse", 1 + 1e-6, 10, 0), ellipse_kind("slender_hertz_ellipse", 10, 1e6, 0),
          ellipse_kind("placed_hertz_ellipse", 1 + 1e-6, 1e6, 20)};
}

}  // namespace patchgrip::friction::bounds
