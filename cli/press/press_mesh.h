// A body given as a mesh, pressed on a ball, a plane or another mesh.
#pragma once

#include <patchgrip/cli/press/pressed.h>
#include <patchgrip/contact/mesh_contact.h>

namespace patchgrip::cli {

bool has_mesh(const BodyPair& pair);

// Of bodies told at `bodies` in a scene. Throws SceneError where the other body is no mesh, ball or plane.
contact::MeshContact mesh_contact(const BodyPair& pair, const Place& bodies);

Pressed press_mesh(const BodyPair& pair, double contact_modulus, const PressScene& scene);

}  // namespace patchgrip::cli
