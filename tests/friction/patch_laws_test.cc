// What holds of every patch, whatever its pressure: D is a support function, friction only takes.
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/friction/law.h>
#include <patchgrip/tests/friction/any_patch.h>
#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/motions.h>

namespace patchgrip::friction {
namespace {

// A hundred units of rounding: patches and bounds are tested far closer elsewhere, these are laws.
constexpr double rounding = 1e-14;

// |v| + lever |w| with the lever of all points that matter, so that rounding of a twist changes D by 2^-53 of it.
double lever(const NamedPatch& p) {
  const PressureMoments s = p.moments();
  return std::hypot(s.x, s.y) + std::sqrt(s.polar) + p.area_radius();
}

double size(const NamedPatch& p, const Twist& v) { return speed_of(v, lever(p)); }

RC_GTEST_PROP(EveryPatch, DissipatesInEveryMotion, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Twist v = *motion_of(p);
    RC_ASSERT(p.dissipation(v) > 0);
  }
}

RC_GTEST_PROP(EveryPatch, DissipationIsThePowerOfTheGradient, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Twist v = *motion_of(p);
    RC_ASSERT(std::fabs(p.dissipation(v) - power(p.gradient(v), v)) <= rounding * size(p, v));
  }
}

RC_GTEST_PROP(EveryPatch, FrictionNeverDrives, ()) {
  const double mu_static = *uniform(0, 2), mu_kinetic = *uniform(0, 2), velocity = *log_uniform(1e-3, 1e3);
  const Law law = Law::stribeck(mu_static, mu_kinetic, velocity).with_viscous(*uniform(0, 1));
  for (const NamedPatch& p : every_patch()) {
    const Twist v = *motion_of(p);
    const Wrench t = std::visit([&](const auto& patch) { return friction_wrench(law, 3, patch, v).value; }, p.patch);
    RC_ASSERT(power(t, v) <= 0);
  }
}

RC_GTEST_PROP(EveryPatch, DissipationIsConvex, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Twist u = *motion_of(p), v = *motion_of(p);
    const Twist sum{u.vx + v.vx, u.vy + v.vy, u.w + v.w};
    RC_ASSERT(p.dissipation(sum) <= p.dissipation(u) + p.dissipation(v) + rounding * (size(p, u) + size(p, v)));
  }
}

// Maximum dissipation: no wrench that the patch can bear takes more from a motion than the one of that motion.
RC_GTEST_PROP(EveryPatch, EveryWrenchLiesWithinTheLimitSurface, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Twist u = *motion_of(p), v = *motion_of(p);
    RC_ASSERT(power(p.gradient(v), u) <= p.dissipation(u) + rounding * size(p, u));
  }
}

RC_GTEST_PROP(EveryPatch, ReversedMotionReversesTheWrench, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Twist v = *motion_of(p), back{-v.vx, -v.vy, -v.w};
    const Wrench g = p.gradient(v), h = p.gradient(back);
    RC_ASSERT(h.fx == -g.fx && h.fy == -g.fy && h.m == -g.m);
    RC_ASSERT(p.dissipation(back) == p.dissipation(v));
  }
}

RC_GTEST_PROP(EveryPatch, SpeedScalesTheDissipationAlone, ()) {
  const double k = *log_uniform(1e-9, 1e9);
  for (const NamedPatch& p : every_patch()) {
    const Twist v = *motion_of(p), scaled{k * v.vx, k * v.vy, k * v.w};
    RC_ASSERT(std::fabs(p.dissipation(scaled) - k * p.dissipation(v)) <= k * rounding * size(p, v));
  }
}

// Jensen and Cauchy-Schwarz: the mean of |v_P| lies between the size of its mean and its root mean square.
RC_GTEST_PROP(EveryPatch, DissipationLiesBetweenCentroidSpeedAndRootMeanSquare, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Twist v = *motion_of(p), c = p.at_centroid(v);
    const double D = p.dissipation(v);
    RC_ASSERT(D >= std::hypot(c.vx, c.vy) - rounding * size(p, v));
    RC_ASSERT(D <= std::sqrt(mean_square_speed(p.moments(), v)) + rounding * size(p, v));
  }
}

RC_GTEST_PROP(EveryPatch, ForceNeverExceedsThatOfATranslation, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Wrench g = p.gradient(*motion_of(p));
    RC_ASSERT(std::hypot(g.fx, g.fy) <= 1 + rounding);
  }
}

RC_GTEST_PROP(EveryPatch, MomentAboutTheCentroidNeverExceedsTheRadiusOfGyration, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Wrench g = p.gradient(*motion_of(p));
    const PressureMoments s = p.moments();
    RC_ASSERT(std::fabs(g.m - (s.x * g.fy - s.y * g.fx)) <= std::sqrt(s.polar) + rounding * lever(p));
  }
}

RC_GTEST_PROP(EveryPatch, ATranslationMeetsFrictionAtTheCentroid, (double angle)) {
  RC_PRE(std::isfinite(angle));
  for (const NamedPatch& p : every_patch()) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Wrench g = p.gradient({3 * c, 3 * s, 0});
    const PressureMoments m = p.moments();
    RC_ASSERT(std::hypot(g.fx - c, g.fy - s) <= rounding);
    RC_ASSERT(std::fabs(g.m - (m.x * s - m.y * c)) <= rounding * lever(p));
  }
}

RC_GTEST_PROP(EveryPatch, HessianIsPositiveSemidefiniteAndFlatAlongTheMotion, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Twist v = *motion_of(p), u = *motion_of(p);
    Hessian h;
    try {
      h = p.hessian(v);
    } catch (const std::domain_error&) {
      RC_ASSERT(p.name == "Ring" || p.name == "PlacedRing" || p.is_line());  // with the pole on it
      continue;
    }
    const double l = lever(p);
    const double tolerance = rounding * scaled_size(h, v, l);
    RC_ASSERT(along_itself(h, v, l) <= tolerance);
    RC_ASSERT(power(h * u, u) >= -tolerance * size(p, u) * size(p, u) / size(p, v));
  }
}

RC_GTEST_PROP(RoundPatch, TurnsWithTheMotion, ()) {
  for (const NamedPatch& p : every_patch()) {
    if (!p.round_about_origin) continue;
    const Twist v = *motion_of(p);
    // 3-4-5: the rotation itself is rounded, no more than that.
    const Twist turned{0.6 * v.vx - 0.8 * v.vy, 0.8 * v.vx + 0.6 * v.vy, v.w};
    const Wrench g = p.gradient(v), h = p.gradient(turned);
    RC_ASSERT(std::hypot(h.fx - (0.6 * g.fx - 0.8 * g.fy), h.fy - (0.8 * g.fx + 0.6 * g.fy)) <= rounding);
    RC_ASSERT(std::fabs(h.m - g.m) <= rounding * p.area_radius());
  }
}

RC_GTEST_PROP(RoundPatch, OppositeSpinReversesTheMomentAlone, ()) {
  for (const NamedPatch& p : every_patch()) {
    if (!p.round_about_origin) continue;
    const Twist v = *motion_of(p);
    const Wrench g = p.gradient(v), h = p.gradient({v.vx, v.vy, -v.w});
    RC_ASSERT(h.fx == g.fx && h.fy == g.fy && h.m == -g.m);
  }
}

RC_GTEST_PROP(RoundPatch, SizeScalesTheMomentAlone, ()) {
  const double k = *log_uniform(1e-6, 1e6);
  const double x = *log_uniform(1e-3, 1e3);
  const auto compare = [&](const auto& unit, const auto& scaled) {
    const Wrench g = unit.gradient({x, 0, 1}), h = scaled.gradient({k * x, 0, 1});
    RC_ASSERT(std::fabs(h.fx - g.fx) <= rounding * g.fx);
    RC_ASSERT(std::fabs(h.m - k * g.m) <= rounding * k * g.m);
  };
  compare(HertzDisc::of_radius(1), HertzDisc::of_radius(k));
  compare(FlatPunchDisc::of_radius(1), FlatPunchDisc::of_radius(k));
  compare(UniformDisc::of_radius(1), UniformDisc::of_radius(k));
  compare(Ring::of_radius(1), Ring::of_radius(k));
}

}  // namespace
}  // namespace patchgrip::friction
