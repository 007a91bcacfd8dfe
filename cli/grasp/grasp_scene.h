// A scene as `patchgrip grasp` reads it: contacts on an object, what loads it, and what is asked.
//
// The format, key by key, is in data/scenes/README.md.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/grasp/grasp_contacts.h>
#include <patchgrip/cli/scene/sequence.h>
#include <patchgrip/cli/scene/toml_document.h>
#include <patchgrip/grasp/held_ball.h>
#include <patchgrip/grasp/spatial.h>
#include <patchgrip/grasp/worst_load.h>

namespace patchgrip::cli {

enum class GraspQuestion {
  least_grip,
  least_total_grip,
  least_quadratic_grip,
  holds_within,
  load_factor,
  distance,
  worst_grip,
  worst_load_factor,
  growing_grip,
  force_closure,
  form_closure,
  held_ball,
  internal_forces
};

inline constexpr std::array<std::string_view, 13> grasp_questions{
    "least_grip",   "least_total_grip", "least_quadratic_grip", "holds_within", "load_factor",
    "distance",     "worst_grip",       "worst_load_factor",    "growing_grip", "force_closure",
    "form_closure", "held_ball",        "internal_forces"};

constexpr std::size_t most_internal_contacts = 200;  // the basis grows with their square

// Of the grasp alone, whatever the load.
constexpr bool asks_of_no_load(GraspQuestion question) { return question >= GraspQuestion::force_closure; }

constexpr bool asks_of_closure(GraspQuestion question) {
  return question == GraspQuestion::force_closure || question == GraspQuestion::form_closure;
}

// Of all loads of a set at once.
constexpr bool asks_of_a_set(GraspQuestion question) {
  return question == GraspQuestion::worst_grip || question == GraspQuestion::worst_load_factor;
}

// Grasps or loads that differ in one number: least grip and verdict of each.
struct GraspFamily {
  enum class Parameter { turn, offset, mu, spread };

  Parameter parameter;
  Sequence values;
  grasp::Vector3 axis = {0, 0, 1};  // that the load is turned about, through the origin, or along which it is moved
};

struct GraspScene {
  std::shared_ptr<const TomlDocument> document;  // that `grown` of its contacts still reads
  std::string title;
  std::vector<GraspContact> contacts;
  grasp::Vector6 weight = grasp::Vector6::Zero();  // gravity and inertia of the object
  std::vector<grasp::Vector6> loads;               // besides its weight; one of zeros where none is given
  std::vector<Place> load_places;
  GraspQuestion question = GraspQuestion::least_grip;
  double length;       // of metrics that compare forces with moments [m]
  double epsilon = 1;  // of least_quadratic_grip
  grasp::GripMeasure measure = grasp::GripMeasure::largest_force;
  grasp::BallSettings ball;
  std::vector<grasp::Vector6> disturbance;  // semi-axes of the ellipsoid of loads about each of `loads`
  grasp::WorstLoadSettings worst;
  std::optional<GraspFamily> family;
  double azimuth = -1, elevation = 0.4;  // of the viewer of the picture [rad]
  Place place;                           // the contacts
};

// `question` overrules that of the scene unless it is empty. Throws SceneError.
GraspScene read_grasp_scene(TomlDocument document, const MaterialLibrary& materials, std::string_view question);

}  // namespace patchgrip::cli
