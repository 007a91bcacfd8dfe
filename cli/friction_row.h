// One row of a friction table: the wrench of a scene's contact in one motion, and the bound of its error.
//
// The bound is about the exact result for the numbers of the scene as doubles: rounding of the twist, and of a
// radius that follows from bodies, is part of it.
#pragma once

#include <cmath>

#include <patchgrip/cli/input_error.h>
#include <patchgrip/cli/scene/contact_reader.h>
#include <patchgrip/cli/scene/motions.h>
#include <patchgrip/friction/law.h>
#include <patchgrip/friction/patch.h>

namespace patchgrip::cli {

// `patch` is the contact's patch in the contact frame.
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
  const friction::Pole centre{contact.frame.x, contact.frame.y};
  if (turns && contact.radius_error > 0) {
    const auto disc = std::visit([&](const auto& d) { return DiscMotion::of(d, centre, motion.twist); }, contact.patch);
    add(error_of_radius(law, contact.normal_force, disc, contact.radius_error));
  } else if (turns && contact.shape_error > 0) {
    add(error_of_shape(law, contact.normal_force, ShapeMotion::of(patch, centre, contact.extent, motion.twist),
                       contact.shape_error));
  }
  if (contact.coarse) {
    const friction::Wrench g =
        friction::friction_wrench(law, contact.normal_force, placed(*contact.coarse, contact.frame), motion.twist)
            .value;
    add({std::hypot(row.value.fx - g.fx, row.value.fy - g.fy), std::fabs(row.value.m - g.m)});
  }
  if (contact.resistance) {  // its product with the mean coefficient is rounded
    constexpr double unit = 0x1p-53;
    add({unit * std::hypot(row.value.fx, row.value.fy), unit * std::fabs(row.value.m)});
  }
  return row;
}

}  // namespace patchgrip::cli
