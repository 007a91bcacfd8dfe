// One row of a friction table: the wrench of a scene's contact in one motion, and the bound of its error.
//
// The bound is about the exact result for the numbers of the scene as doubles: rounding of the twist, of a
// radius that follows from bodies, its scatter where it is fitted, and of the sum of forces of parts is part of it.
#pragma once

#include <algorithm>
#include <cmath>

#include <patchgrip/cli/input_error.h>
#include <patchgrip/cli/scene/contact_reader.h>
#include <patchgrip/cli/scene/motions.h>
#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/law.h>
#include <patchgrip/friction/local_stribeck.h>
#include <patchgrip/friction/patch.h>

namespace patchgrip::cli {

// What the wrench `t` in the motion v owes to the contact: to a shape that follows from bodies, and to the grid that
// its pressure is computed on. `patch` is the contact's patch in the contact frame.
template <friction::Patch P>
WrenchError error_of_contact(const Contact& contact, const friction::Law& law, double normal_force, const P& patch,
                             const friction::Twist& v, const friction::Wrench& t) {
  WrenchError error;
  const friction::Pole centre{contact.frame.x, contact.frame.y};
  if (v.w != 0 && contact.radius_error > 0) {
    const auto disc = std::visit([&](const auto& d) { return DiscMotion::of(d, centre, v); }, contact.patch);
    error = error_of_radius(law, normal_force, disc, contact.radius_error);
  } else if (v.w != 0 && contact.shape_error > 0) {
    error = error_of_shape(law, normal_force, ShapeMotion::of(patch, centre, contact.extent, v), contact.shape_error);
  }
  if (v.w != 0 && contact.scatter) {
    error = error_of_scatter(law, normal_force, *contact.scatter, centre, v);
  }
  if (contact.coarse) {
    const friction::Wrench g =
        friction::friction_wrench(law, normal_force, placed(*contact.coarse, contact.frame), v).value;
    error.force += std::hypot(t.fx - g.fx, t.fy - g.fy);
    error.moment += std::fabs(t.m - g.m);
  }
  return error;
}

template <friction::Patch P>
friction::BoundedWrench friction_row(const Contact& contact, const friction::Law& law, const P& patch,
                                     const Motion& motion) {
  const bool turns = motion.spin != 0;
  const friction::Twist exact = turns ? friction::twist_about(motion.pole, motion.spin) : motion.twist;
  const friction::PressureMoments moments = patch.moments();
  const friction::BoundedWrench gradient = patch.bounded_gradient(exact);
  friction::BoundedWrench row = friction::friction_wrench(law, contact.normal_force, moments, gradient, motion.twist);
  const auto add = [&row](const WrenchError& error) {
    row.force_error += error.force;
    row.moment_error += error.moment;
  };
  if (turns && motion.angular_speed != 1) {
    add(error_of_twist(law, contact.normal_force, moments, gradient.value, motion.twist));
  }
  add(error_of_contact(contact, law, contact.normal_force, patch, motion.twist, row.value));
  // The product of a resistance with the mean coefficient is rounded too.
  const double relative = contact.sum_error + (contact.resistance ? 0x1p-53 : 0);
  add({relative * std::hypot(row.value.fx, row.value.fy), relative * std::fabs(row.value.m)});
  return row;
}

// The same with Stribeck's law at each point. What it owes to inputs: its slope at a point is at most that of Coulomb
// friction with mu_k + |mu_s - mu_k|, as |d (exp(-u^2) u / |u|)| <= |du| / |u|; a rounded twist is a pole moved by a
// rounding, 16 units of the force at most (placed.h).
template <friction::Patch P>
friction::BoundedWrench local_friction_row(const Contact& contact, const friction::Law& law, const P& patch,
                                           const Motion& motion) {
  if constexpr (!friction::LocalPatch<P>) {
    return local_friction_row(contact, law, friction::AnyPatch(patch), motion);
  } else {
    constexpr double unit = 0x1p-53;
    const double force = contact.normal_force;
    const friction::Twist& v = motion.twist;
    friction::BoundedWrench row = friction::local_friction_wrench(law, force, patch, v);
    const auto add = [&row](const WrenchError& error) {
      row.force_error += error.force;
      row.moment_error += error.moment;
    };
    friction::Law steepest = friction::Law::coulomb(law.mu_kinetic + std::fabs(law.mu_static - law.mu_kinetic));
    steepest.mu_viscous = law.mu_viscous;
    const bool turns = motion.spin != 0;
    const friction::PressureMoments s = patch.moments();
    if (turns && motion.angular_speed != 1) {
      const double shift = 16 * unit * steepest.mu_kinetic * force;
      add({shift, shift * (std::hypot(s.x, s.y) + std::sqrt(s.polar))});
      add(error_of_twist(steepest, force, s, {}, v));
    }
    const double shape_error = std::max(contact.radius_error, contact.shape_error);
    if (turns && shape_error > 0) {
      const double extent = contact.radius_error > 0 ? patch.area_radius() : contact.extent;
      const friction::Pole centre{contact.frame.x, contact.frame.y};
      add(error_of_shape(steepest, force, ShapeMotion::of(patch, centre, extent, v), shape_error));
    }
    if (contact.coarse) {
      const auto coarse = local_friction_wrench(law, force, placed(*contact.coarse, contact.frame), v).value;
      add({std::hypot(row.value.fx - coarse.fx, row.value.fy - coarse.fy), std::fabs(row.value.m - coarse.m)});
    }
    add({contact.sum_error * std::hypot(row.value.fx, row.value.fy), contact.sum_error * std::fabs(row.value.m)});
    return row;
  }
}

}  // namespace patchgrip::cli
