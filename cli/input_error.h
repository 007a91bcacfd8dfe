// What a friction wrench owes to inputs that are themselves rounded: a twist made from an exact pole and angular speed,
// and a radius computed from bodies.
//
//     twist     |d(vx, vy)| <= 2^-53 |(vx, vy)|. grad D sees only the pole and the spin; the error reaches mu(v_m), by
//               d(v_m^2) <= 2 |v_c| |dv| + |dv|^2, and the viscous part.
//     radius    da = delta a. D depends on a through a w alone, and is homogeneous of degree 1; so about the centre
//               |df| = delta |w| |(H_xw, H_yw)|,   |dm| <= delta (|m| + |w| H_ww)
//               where H is the Hessian of D; d(v_m^2) = 2 delta w^2 s_c, and the viscous moment likewise.
//     shape     points of a patch moved by at most delta of their distance from its centre, which is at most e. With
//               T = H_xx + H_yy >= integral p / |v_P|, and u the velocity of the centre, about which the pressure is
//               symmetric,
//               |df| <= delta |w| e T,   |dm| <= delta e (min(1, 2 e |w| / |u|) + |w| e T)
//     scatter   a round patch whose radius lies between two that are finitely apart. D = |w| S(distance of the pole), S
//               convex; so with the radius the force about the centre falls, the moment grows, and so does v_m: they
//               are nowhere as far off as at one of the ends.
//
// Units    bounds [N], [N m], the moment about the contact frame's origin.
// Error    products of two rounding errors are left out.
#pragma once

#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/law.h>
#include <patchgrip/friction/patch.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::cli {

struct WrenchError {
  double force = 0;
  double moment = 0;
};

// `gradient` is grad D at v.
WrenchError error_of_twist(const friction::Law& law, double normal_force, const friction::PressureMoments& moments,
                           const friction::Wrench& gradient, const friction::Twist& v) noexcept;

// v as seen from a point.
friction::Twist moved_to(const friction::Pole& point, const friction::Twist& v) noexcept;

// A disc about `centre` in motion: moments, gradient and Hessian of D about its own centre, where v is `about_centre`.
struct DiscMotion {
  template <class Disc>
  static DiscMotion of(const Disc& disc, const friction::Pole& centre, const friction::Twist& v) {
    const friction::Twist moved = moved_to(centre, v);
    return {centre, moved, disc.moments(), disc.gradient(moved), disc.hessian(moved)};
  }

  friction::Pole centre;
  friction::Twist about_centre;
  friction::PressureMoments moments;
  friction::Wrench gradient;
  friction::Hessian hessian;
};

// What moved points of any patch need to know of its motion.
struct ShapeMotion {
  template <class P>
  static ShapeMotion of(const P& patch, const friction::Pole& centre, double extent, const friction::Twist& v) {
    const friction::Hessian h = patch.hessian(v);
    return {centre, extent, v, patch.moments(), patch.gradient(v), h.xx + h.yy};
  }

  friction::Pole centre;
  double extent;  // e [m]
  friction::Twist twist;
  friction::PressureMoments moments;
  friction::Wrench gradient;
  double stiffness;  // T [s/m]
};

WrenchError error_of_shape(const friction::Law& law, double normal_force, const ShapeMotion& motion, double delta);

// Where the radius of the disc has the relative error `delta`; v may not be 0.
WrenchError error_of_radius(const friction::Law& law, double normal_force, const DiscMotion& disc, double delta);

// A round patch about the origin, and what it is at the ends of the radii that it may have.
struct RadiusScatter {
  friction::AnyPatch own, narrow, wide;
};

// Of these patches, moved to `centre`.
WrenchError error_of_scatter(const friction::Law& law, double normal_force, const RadiusScatter& scatter,
                             const friction::Pole& centre, const friction::Twist& v);

}  // namespace patchgrip::cli
