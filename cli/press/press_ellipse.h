// Two bodies that touch in an ellipse, by their principal radii.
#pragma once

#include <patchgrip/cli/press/pressed.h>
#include <patchgrip/contact/relative_radii.h>

namespace patchgrip::cli {

// Principal radii of a curved body, a ball or a plane; nothing of others.
std::optional<CurvedSurface> curved_surface(const Shape& shape);

// Throws std::invalid_argument for surfaces that touch in more than a point.
contact::RelativeRadii relative_radii_of(const CurvedSurface& first, const CurvedSurface& second);

// Direction of the semi-axis a, and what rounding, also that of the angle between the bodies, does to it, to the
// relative radii and to 1 - R_small/R_large: to these the more, the closer to a circle; to R_large the more, the closer
// to a saddle.
struct EllipseDirection {
  static EllipseDirection of(const CurvedSurface& first, const CurvedSurface& second,
                             const contact::RelativeRadii& radii);

  double angle;        // of a [rad]
  double error;        // [rad]
  double ratio_error;  // of 1 - R_small/R_large
  double small_error;  // of R_small [m]
  double large_error;  // of R_large [m]
};

Pressed press_ellipse(const CurvedSurface& first, const CurvedSurface& second, double contact_modulus,
                      const PressScene& scene);

}  // namespace patchgrip::cli
