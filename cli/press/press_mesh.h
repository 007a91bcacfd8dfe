// A body given as a mesh, pressed on a ball, a plane or another mesh.
#pragma once

#include <patchgrip/cli/press/pressed.h>

namespace patchgrip::cli {

bool has_mesh(const BodyPair& pair);

Pressed press_mesh(const BodyPair& pair, double contact_modulus, const PressScene& scene);

}  // namespace patchgrip::cli
