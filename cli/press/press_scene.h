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
#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/sequence.h>
#include <patchgrip/cli/scene/toml_document.h>
#include <patchgrip/contact/creep/history.h>

namespace patchgrip::cli {

// A pressure, from which the shape of the stamp follows.
struct GivenPressure {
  PatchVariant patch;
  double contact_modulus;  // [Pa]
};

// A soft fingertip by the laws of Keppler 4.3.2.
struct PowerLawFingertip {
  double coefficient;  // c [m N^-gamma]
  double exponent;     // gamma
  double alpha;        // of the pressure of Xydas and Kao
};
struct MeasuredFingertip {
  std::vector<std::array<double, 2>> points;  // F_N [N], a [m]
  double confidence;
  double alpha;
};
struct WinklerFingertip {
  double radius;  // R [m]
  double bed;     // c [Pa]
};

using Subject = std::variant<BodyPair, GivenPressure, PowerLawFingertip, MeasuredFingertip, WinklerFingertip>;

enum class LoadKind { normal_force, approach, contact_radius };

struct StaticLoad {
  LoadKind kind;
  double value;  // [N] or [m]
};

struct TimedLoad {
  LoadKind kind;  // normal_force or approach
  contact::History history;
  Sequence times;  // asked for [s]
};

struct Adhesion {
  double work;                   // w [J/m^2]
  std::optional<double> stress;  // sigma_0 of the attraction [Pa]
};

// The line along which pressure and displacement are tabulated; of a timed load also when.
struct ProfileRequest {
  std::optional<Sequence> distance;  // [m]; by default twice the contact radius, in 200 steps
  double angle = 0;                  // [rad] against the x-axis
  std::optional<Sequence> times;     // [s]
};

enum class SweepKind { normal_force, approach, contact_radius, radii_ratio, mu };

struct Sweep {
  SweepKind kind;
  Sequence values;
};

struct PressScene {
  std::string title;
  std::vector<std::string> notes;  // the contact in words
  Subject subject;
  std::variant<StaticLoad, TimedLoad> load;
  std::optional<Adhesion> adhesion;
  std::optional<double> mu;  // coefficient of friction at rest
  ProfileRequest profile;
  std::optional<Sweep> sweep;
};

// Throws SceneError.
PressScene read_press_scene(const TomlDocument& document, const MaterialLibrary& materials);

// The scene at one value of its sweep.
PressScene at_sweep_value(PressScene scene, double value);

}  // namespace patchgrip::cli
