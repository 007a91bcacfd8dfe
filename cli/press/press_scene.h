// A scene as `patchgrip press` reads it: what touches, how it is loaded, what else acts, and what is asked for.
//
// The format, key by key, is in data/scenes/README.md. [friction] and [poles] may be there for other questions; of
// [friction] the coefficient at rest is used.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <patchgrip/cli/patch_variant.h>
#include <patchgrip/cli/scene/body_reader.h>
#include <patchgrip/cli/scene/fingertip_reader.h>
#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/place.h>
#include <patchgrip/cli/scene/sequence.h>
#include <patchgrip/cli/scene/toml_document.h>
#include <patchgrip/contact/creep/history.h>

namespace patchgrip::cli {

// A pressure, from which the shape of the stamp follows.
struct GivenPressure {
  PatchVariant patch;
  double contact_modulus;  // [Pa]
};

using Subject = std::variant<BodyPair, GivenPressure, PowerLawFingertip, MeasuredFingertip, WinklerFingertip>;

enum class LoadKind { normal_force, approach, contact_radius };

struct StaticLoad {
  LoadKind kind;
  double value;  // [N] or [m]
  Place place;
};

struct TimedLoad {
  LoadKind kind;  // normal_force or approach
  contact::History history;
  Sequence times;  // asked for [s]
  Place place, times_place;
};

struct Adhesion {
  double work;                   // w [J/m^2]
  std::optional<double> stress;  // sigma_0 of the attraction [Pa]
  Place place;
};

// The line along which pressure and displacement are tabulated; of a timed load also when.
struct ProfileRequest {
  // By default from the middle to twice the contact radius, in 200 steps.
  Sequence distances(double extent) const { return distance.value_or(Sequence::equal_steps(0, 2 * extent, 201)); }

  std::optional<Sequence> distance;  // [m]
  double angle = 0;                  // [rad] against the x-axis
  std::optional<Sequence> times;     // [s]
  std::optional<Place> place;        // 'times' where they are given, or else the table
};

enum class SweepKind { normal_force, approach, contact_radius, radii_ratio, mu };

struct Sweep {
  SweepKind kind;
  Sequence values;
  Place place;
};

struct PressScene {
  std::string title;
  std::vector<std::string> notes;  // the contact in words
  Subject subject;
  Place subject_place;
  std::variant<StaticLoad, TimedLoad> load;
  bool load_is_swept;  // `load` is the first value of the sweep
  std::optional<Adhesion> adhesion;
  std::optional<double> mu;  // coefficient of friction at rest
  ProfileRequest profile;
  std::optional<Sweep> sweep;
};

// Throws SceneError.
PressScene read_press_scene(const TomlDocument& document, const MaterialLibrary& materials);

// What is found wrong with the load, or with the answer as a whole, is told here.
const Place& load_place(const PressScene& scene);

// The scene at one value of its sweep, which is then the place of its load.
PressScene at_sweep_value(PressScene scene, std::size_t index);

}  // namespace patchgrip::cli
