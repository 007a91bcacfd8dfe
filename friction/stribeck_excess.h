// Stribeck's excess of every patch, on which the law at each point rests (local_stribeck.h).
//
//     E(u) = int exp(-|u_P|^2) (u_P / |u_P|) [1; P x] p / F_N dA,    u = v / v_S
//
// One function for all: a patch can be rubbed by the law at each point if stribeck_excess takes it.
//
// Domain   every motion of every patch but XydasKaoDisc and StampDisc, which behind AnyPatch answer not-a-number with
//          an infinite error. A scene that asks for them is refused. PowerEllipse takes n < 0 only where it is round.
// Units    u [1], [1], [1/m]; force [1], moment [m].
// Error    carried: an estimate, mostly some 1e-15 of the force and of force times size (local_stribeck.h).
// Throws   PowerEllipse::of_semi_axes std::invalid_argument outside its domain; nothing else.
#pragma once

#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

class FlatPunchDisc;
class HertzDisc;
class HertzEllipse;
class LineLoad;
class PointLoad;
class Polygon;
class PowerDisc;
class Ring;
class SampledPatch;
class SeedHertzDisc;
class Several;
class UniformDisc;
template <Patch P>
class Placed;

// A pressure ~ (1 - x^2/a^2 - y^2/b^2)^(n - 1/2) on an ellipse, n >= 0, or a disc, n >= -1/2 (seed 4.13).
class PowerEllipse {
 public:
  // Semi-axes along x and y [m]; n in [0, 20], the largest of power_disc.h; where a = b from -1/2, that of a ring.
  static PowerEllipse of_semi_axes(double a, double b, double n);

  double a() const noexcept { return a_; }
  double b() const noexcept { return b_; }
  double n() const noexcept { return n_; }

 private:
  PowerEllipse(double a, double b, double n) noexcept : a_(a), b_(b), n_(n) {}

  double a_, b_, n_;
};

BoundedWrench stribeck_excess(const PowerEllipse& zone, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const FlatPunchDisc& disc, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const HertzDisc& disc, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const HertzEllipse& ellipse, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const LineLoad& line, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const PointLoad& point, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const Polygon& polygon, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const PowerDisc& disc, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const Ring& ring, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const SampledPatch& patch, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const SeedHertzDisc& disc, const Twist& u) noexcept;  // that of the exact Hertz disc
// Parts by their weights mu_i F_i, as in D: that of the friction stress (several.h).
BoundedWrench stribeck_excess(const Several& several, const Twist& u) noexcept;
BoundedWrench stribeck_excess(const UniformDisc& disc, const Twist& u) noexcept;

// E where its motion is rounded, which changes its force by so much and its moment about the centroid: twice that, as it
// changes on the way (placed.h), and never more than from E to -E.
BoundedWrench with_change(BoundedWrench E, const PressureMoments& s, double force, double moment) noexcept;

template <class P>
concept LocalPatch = Patch<P> && requires(const P& patch, const Twist& u) {
  stribeck_excess(patch, u);
};

template <class P>
requires requires(const P& patch, const Twist& u) { stribeck_excess(patch, u); }
BoundedWrench stribeck_excess(const Placed<P>& placed, const Twist& u) noexcept;

}  // namespace patchgrip::friction
