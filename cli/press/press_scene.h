// A scene as `patchgrip press` reads it: two bodies or a given pressure, the load, and what else acts.
//
// The format, key by key, is in data/scenes/README.md. [friction] and [poles] may be there for other questions.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <patchgrip/cli/scene/body_reader.h>
#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/sequence.h>
#include <patchgrip/cli/scene/toml_document.h>
#include <patchgrip/contact/creep/load_history.h>
#include <patchgrip/friction/law.h>

namespace patchgrip::cli {

enum class LoadKind { normal_force, approach, contact_radius };

struct StaticLoad {
  LoadKind kind;
  double value;  // [N] or [m]
};

// Force or approach over time, asked for at `times`.
struct LoadHistory {
  bool is_force;
  contact::LoadHistory points;
  Sequence times;
};

struct Adhesion {
  double work;                    // w [J/m^2]
  std::optional<double> stress;   // sigma_0 of the Dugdale zone [Pa]
};

// The line along which pressure and displacement are tabulated, and when (histories).
struct ProfileRequest {
  Sequence distance;  // [m]
  double angle;       // [rad] against the x-axis
  std::vector<double> times;
};

enum class SweepKind { normal_force, approach, contact_radius, radii_ratio, mu };

struct Sweep {
  SweepKind kind;
  Sequence values;
};

struct PressScene {
  std::string title;
  std::vector<Body> bodies;  // two, or none where the pressure is given
};

}  // namespace patchgrip::cli
