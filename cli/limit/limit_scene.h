// A scene as `patchgrip limit` reads it: a contact, its friction at rest, the loads to hold, and how the limit surface
// is drawn.
//
// The format, key by key, is in data/scenes/README.md. [poles] may be there for `tabulate`.
#pragma once

#include <optional>
#include <string>

#include <patchgrip/cli/limit/loads.h>
#include <patchgrip/cli/scene/contact_reader.h>
#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/place.h>
#include <patchgrip/cli/scene/toml_document.h>

namespace patchgrip::cli {

constexpr double most_loads = 1e6;

// How the limit surface is meshed and seen.
struct SurfaceRequest {
  int meridians = 96;            // directions of translation around the axis of moments
  int parallels = 48;            // steps from pure rotation to pure rotation the other way
  std::optional<double> length;  // of the moment's scale m / length [m]; by default the largest moment per mu F_N
  double azimuth = -1;           // of the viewer, around the axis of moments [rad]
  double elevation = 0.4;        // of the viewer above the plane of forces [rad]
};

struct LimitScene {
  std::string title;
  Contact contact;
  std::optional<double> mu;  // at rest; without it only what must be held is told
  Loads loads;               // may be none
  SurfaceRequest surface;
  Place contact_place;
  Place friction_place;  // what limits friction: [friction], or [contact] with its parts
};

// Is it known how much friction there is?
inline bool has_friction(const LimitScene& scene) { return scene.mu || scene.contact.resistance; }

// Throws SceneError.
LimitScene read_limit_scene(const TomlDocument& document, const MaterialLibrary& materials);

}  // namespace patchgrip::cli
