// The tables [[contacts]] of a scene: where fingers touch the object, and what each can transmit.
//
// Its friction is one of: a model by name ("frictionless", "point", "soft_elliptic", "soft_linear"), any patch of
// [contact] by its kind and size, or two bodies under a grip force, from which the patch follows.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/place.h>
#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/grasp/contact.h>

namespace patchgrip::cli {

struct GraspContact {
  grasp::ContactFrame frame;
  grasp::FrictionCone cone;                                // under `grip_force` where it follows from bodies
  std::function<grasp::FrictionCone(double force)> grown;  // of bodies alone: under another normal force [N]
  std::optional<double> limit;                             // of the normal force [N]
  double shape_error = 0;                                  // relative, of D, where the patch follows from bodies
  std::string words;
  std::vector<std::string> warnings;
  Place place;
};

// At least one. Throws SceneError.
std::vector<GraspContact> read_grasp_contacts(const TomlReader& scene, const MaterialLibrary& materials);

std::vector<grasp::Contact> contacts_of(const std::vector<GraspContact>& contacts);

}  // namespace patchgrip::cli
