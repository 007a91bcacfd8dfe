// A scene as `patchgrip simulate` reads it: a contact, its friction, the body on it, what acts on the body over time,
// and how its motion is followed.
//
// The format, key by key, is in data/scenes/README.md. A contact that is a single point makes a point mass, which moves
// along x; every other a body in the plane, with its centre of mass at the origin of the contact frame, and with
// [upper] a second one on it.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <patchgrip/cli/scene/contact_reader.h>
#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/place.h>
#include <patchgrip/cli/scene/sequence.h>
#include <patchgrip/cli/scene/toml_document.h>
#include <patchgrip/cli/simulate/applied.h>
#include <patchgrip/cli/simulate/moving_body.h>
#include <patchgrip/contact/require.h>
#include <patchgrip/friction/law.h>

namespace patchgrip::cli {

constexpr double most_times = 1e6;
constexpr double most_steps = 1e9;  // of return mapping, or under a load that changes

// Of bodies up to half_freedom, of points all but return_mapping and elastoplastic_printed; in the order of their names
// in simulate_scene.cc.
enum class FrictionMethod {
  rigid,
  return_mapping,
  elastoplastic,
  elastoplastic_printed,
  half_freedom,
  lugre,
  dahl,
  half_freedom_linearised,
  boundary_layer,
  tanh,
  karnopp
};

std::string_view name_of(FrictionMethod method);

struct BristleSettings {
  double stiffness = 0, turn_stiffness = 0;  // [N/m], [N m]
  double damping = 0, turn_damping = 0;      // [N s/m], [N m s]
  double elastic_share = 0.99;
  double nu0 = 1;
  std::optional<double> length{};  // L of the metric [m]; by default M_0 / F_N
};

struct Following {
  FrictionMethod method = FrictionMethod::rigid;
  bool implicit_euler = false;       // in place of SDIRK2
  double step = 0;                   // [s], of return mapping
  double tolerance = 1e-12;          // of a step, of the others
  BristleSettings bristle;           // of return mapping and elastoplastic bristles
  double steepness = 0;              // a [s/m], of tanh and boundary layers
  double zone_mass = 0;              // [kg], of boundary layers
  double dead_band = 0;              // [m/s], of Karnopp
  std::optional<double> rest_speed;  // [m/s]
  Sequence times = Sequence::of_values({0});
};

// A body that lies on the one of the scene, its patch under its own centre of mass.
struct UpperBody {
  Contact contact;
  friction::Law law;
  MovingBody body;
  AppliedLoads loads;
  BristleSettings bristle;
};

struct SimulateScene {
  bool is_point() const noexcept { return point; }
  double end() const noexcept { return following.times[following.times.size() - 1]; }

  // F_N [N]. Throws std::invalid_argument where it is negative.
  double normal_force(double t) const {
    return contact::require_non_negative("normal_force", contact.normal_force * value_at(pressing, t));
  }
  double capacity(double t) const { return law.mu_static * normal_force(t); }  // mu_s F_N
  // Of the patch, against that of the contact: it grows with its force. 1 where nothing presses, and nothing rubs.
  double size(double t) const {
    const double factor = growth == 0 ? 1 : value_at(pressing, t);
    return factor > 0 ? std::pow(factor, growth) : 1;
  }

  std::string title;
  Contact contact;
  bool point;
  friction::Law law;
  MovingBody body;
  AppliedLoads loads;
  Course pressing;  // of the normal force
  double growth;    // of the patch, as Contact has it; 0 where the force does not change
  Following following;
  std::optional<UpperBody> upper;
  Place place;  // [motion]
};

// Throws SceneError.
SimulateScene read_simulate_scene(const TomlDocument& document, const MaterialLibrary& materials);

}  // namespace patchgrip::cli
