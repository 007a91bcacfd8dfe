// Two bodies that touch in an ellipse, by their principal radii.
#pragma once

#include <patchgrip/cli/press/pressed.h>
#include <patchgrip/contact/relative_radii.h>

namespace patchgrip::cli {

// Principal radii of a curved body, a ball or a plane; nothing of others.
std::optional<CurvedSurface> curved_surface(const Shape& shape);

// Throws std::invalid_argument for surfaces that touch in more than a point.
contact::RelativeRadii relative_radii_of(const CurvedSurface& first, const CurvedSurface& second);

Pressed press_ellipse(const CurvedSurface& first, const CurvedSurface& second, double contact_modulus,
                      const PressScene& scene);

}  // namespace patchgrip::cli
