#include <patchgrip/cli/grasp/grasp_scene.h>

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <patchgrip/cli/scene/nearest_name.h>
#include <patchgrip/cli/scene/scene.h>
#include <patchgrip/cli/scene/sequence_reader.h>
#include <patchgrip/cli/scene/vector_reader.h>
#include <patchgrip/grasp/inertial_load.h>

namespace patchgrip::cli {
namespace {

using grasp::Vector3;
using grasp::Vector6;

constexpr double standard_gravity = 9.80665;  // [m/s^2]

Vector3 vector_of(const TomlReader& table, std::string_view key, std::string_view allowed) {
  const SpaceVector v = read_vector(table, key, allowed, any_sign("a component"));
  return {v[0], v[1], v[2]};
}

Vector3 vector_or(const TomlReader& table, std::string_view key, std::string_view allowed, const Vector3& by_default) {
  return table.has(key) ? vector_of(table, key, allowed) : by_default;
}

grasp::FrameMotion read_motion(const TomlReader& scene) {
  grasp::FrameMotion motion;
  if (!scene.has("carried")) return motion;
  const TomlReader table = scene.table("carried", {"velocity", "acceleration", "turn_rate", "turn_acceleration"});
  const Vector3 none = Vector3::Zero();
  motion.v = vector_or(table, "velocity", "a velocity [x, y, z] in m/s", none);
  motion.v_rate = vector_or(table, "acceleration", "an acceleration [x, y, z] in m/s^2", none);
  motion.omega = vector_or(table, "turn_rate", "an angular velocity [x, y, z] in rad/s", none);
  motion.omega_rate = vector_or(table, "turn_acceleration", "an angular acceleration [x, y, z] in rad/s^2", none);
  return motion;
}

// About the origin, as [xx, yy, zz, xy, xz, yz].
grasp::Matrix3 read_inertia(const TomlReader& object) {
  constexpr std::string_view allowed = "six numbers [xx, yy, zz, xy, xz, yz] in kg m^2, about the origin";
  grasp::Matrix3 J = grasp::Matrix3::Zero();
  if (!object.has("inertia")) return J;
  const toml::array& values = object.array(object.node("inertia"), "inertia", allowed);
  if (values.size() != 6) object.refuse("inertia", allowed);
  std::array<double, 6> j{};
  for (std::size_t i = 0; i < 6; ++i) {
    j[i] = object.number(values[i], fmt::format("inertia[{}]", i), any_sign("a moment of inertia in kg m^2"));
  }
  J << j[0], j[3], j[4], j[3], j[1], j[5], j[4], j[5], j[2];
  return J;
}

Vector6 read_weight(const TomlReader& scene) {
  if (!scene.has("object")) {
    if (scene.has("carried")) scene.refuse("carried", "needs [object], whose mass is carried");
    return Vector6::Zero();
  }
  const TomlReader object = scene.table("object", {"mass", "centre_of_mass", "inertia", "gravity", "mesh", "unit"});
  const grasp::FrameMotion motion = read_motion(scene);
  if (!object.has("mass")) {
    for (const std::string_view key : {"centre_of_mass", "inertia", "gravity"}) {
      if (object.has(key)) object.refuse(key, "used with 'mass'");
    }
    if (scene.has("carried")) scene.refuse("carried", "needs the 'mass' of [object]");
    return Vector6::Zero();
  }
  const bool turns = !motion.omega.isZero(0) || !motion.omega_rate.isZero(0);
  if (turns && !object.has("inertia")) object.refuse("inertia", "needed of an object that is turned");
  grasp::CarriedBody body{object.number("mass", positive("a mass in kg")),
                          vector_or(object, "centre_of_mass", "a place [x, y, z] in m", Vector3::Zero()),
                          read_inertia(object)};
  const Vector3 gravity =
      vector_or(object, "gravity", "an acceleration [x, y, z] in m/s^2", Vector3(0, 0, -standard_gravity));
  return grasp::inertial_load(body, gravity, motion);
}

void read_loads(const TomlReader& scene, GraspScene& result) {
  if (!scene.has("loads")) {
    result.loads.push_back(Vector6::Zero());
    result.load_places.push_back(result.place);
    return;
  }
  constexpr std::size_t most_loads = 100'000;
  for (const TomlReader& load : scene.tables("loads", {"force", "at", "moment"})) {
    if (!load.has("force") && !load.has("moment")) load.refuse_table("needs 'force' or 'moment'");
    if (load.has("at") && !load.has("force")) load.refuse("at", "where the force acts: it needs 'force'");
    const Vector3 none = Vector3::Zero();
    const Vector3 force = vector_or(load, "force", "a force [x, y, z] in N", none);
    const Vector3 at = vector_or(load, "at", "where the force acts, [x, y, z] in m", none);
    const Vector3 moment = vector_or(load, "moment", "a moment [x, y, z] in N m", none);
    result.loads.push_back(grasp::spatial(force, moment + at.cross(force)));
    result.load_places.push_back(load.place());
    if (result.loads.size() > most_loads) load.refuse_table(fmt::format("at most {} loads", most_loads));
  }
}

// A ball of forces acting at a point, with a ball of moments; or any semi-axes.
void read_disturbance(const TomlReader& scene, GraspScene& result) {
  if (!scene.has("disturbance")) return;
  const TomlReader table = scene.table("disturbance", {"force", "at", "moment", "axes"});
  if (!asks_of_a_set(result.question)) {
    scene.refuse("disturbance", "used with 'worst_grip' and 'worst_load_factor', not with another question");
  }
  if (table.has("axes")) {
    table.refuse_others({"axes"}, "'axes' say all of an ellipsoid");
    constexpr std::string_view allowed = "1 to 6 semi-axes [fx, fy, fz, mx, my, mz] in N and N m";
    const toml::array& axes = table.array(table.node("axes"), "axes", allowed);
    if (axes.empty() || axes.size() > 6) table.refuse("axes", allowed);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const std::string name = fmt::format("axes[{}]", k);
      const toml::array& axis = table.array(axes[k], name, allowed);
      if (axis.size() != 6) table.refuse(axes[k], name, allowed);
      Vector6 w;
      for (std::size_t i = 0; i < 6; ++i) {
        w[static_cast<Eigen::Index>(i)] =
            table.number(axis[i], fmt::format("{}[{}]", name, i), any_sign("a component in N or N m"));
      }
      result.disturbance.push_back(w);
    }
    return;
  }
  if (!table.has("force") && !table.has("moment")) table.refuse_table("needs 'force', 'moment' or 'axes'");
  if (table.has("at") && !table.has("force")) table.refuse("at", "where the force acts: it needs 'force'");
  const Vector3 at = vector_or(table, "at", "where the force acts, [x, y, z] in m", Vector3::Zero());
  const Vector3 none = Vector3::Zero();
  if (table.has("force")) {
    const double force = table.number("force", positive("the size of a force in N"));
    for (int k = 0; k < 3; ++k) {
      const Vector3 f = force * Vector3::Unit(k);
      result.disturbance.push_back(grasp::spatial(f, at.cross(f)));
    }
  }
  if (table.has("moment")) {
    const double moment = table.number("moment", positive("the size of a moment in N m"));
    for (int k = 0; k < 3; ++k) result.disturbance.push_back(grasp::spatial(none, moment * Vector3::Unit(k)));
  }
}

// Root of the mean square of the contacts' distance from their centroid; of a single one its moment length.
double size_of(const std::vector<GraspContact>& contacts) {
  Vector3 centroid = Vector3::Zero();
  const auto count = static_cast<double>(contacts.size());
  for (const GraspContact& c : contacts) centroid += c.frame.position / count;
  double square = 0, moment_length = 0;
  for (const GraspContact& c : contacts) {
    square += (c.frame.position - centroid).squaredNorm() / count;
    moment_length = std::max(moment_length, c.cone.moment_length());
  }
  if (square > 0) return std::sqrt(square);
  return moment_length > 0 ? moment_length : 1;
}

void read_question(const TomlReader& scene, std::string_view overruling, GraspScene& result) {
  result.length = size_of(result.contacts);
  if (scene.has("question")) {
    const TomlReader table =
        scene.table("question", {"ask", "length", "epsilon", "measure", "relative_width", "max_simplices", "planar"});
    if (table.has("ask")) result.question = static_cast<GraspQuestion>(table.choice("ask", grasp_questions));
    if (table.has("length")) result.length = table.number("length", positive("a length in m"));
    if (table.has("epsilon")) result.epsilon = table.number("epsilon", positive("the weight of friction"));
    constexpr std::array<std::string_view, 2> measures{"largest_force", "total_force"};
    if (table.has("measure")) result.measure = static_cast<grasp::GripMeasure>(table.choice("measure", measures));
    if (table.has("relative_width")) {
      constexpr Quantity width{"the width of the bracket", 1e-6, 0.999999};
      result.ball.relative_width = result.worst.relative_width = table.number("relative_width", width);
    }
    if (table.has("max_simplices")) {
      constexpr Quantity count{"a number of simplices", 0, 1e7};
      result.ball.max_simplices = result.worst.max_simplices = static_cast<int>(table.number("max_simplices", count));
    }
    result.ball.planar = table.flag("planar");
  }
  if (overruling.empty()) return;
  const auto found = std::ranges::find(grasp_questions, overruling);
  if (found == grasp_questions.end()) {
    throw SceneError(
        "--question", 0,
        fmt::format("unknown name '{}'{}", printable(overruling), suggestion(overruling, grasp_questions)));
  }
  result.question = static_cast<GraspQuestion>(found - grasp_questions.begin());
}

void read_family(const TomlReader& scene, GraspScene& result) {
  if (!scene.has("family")) return;
  const TomlReader table = scene.table("family", {"turn", "offset", "axis", "mu", "spread"});
  using Parameter = GraspFamily::Parameter;
  struct Kind {
    std::string_view key;
    Parameter parameter;
    Quantity values;
  };
  static const std::array<Kind, 4> kinds{{{"turn", Parameter::turn, any_angle("an angle in rad")},
                                          {"offset", Parameter::offset, any_sign("a length in m")},
                                          {"mu", Parameter::mu, non_negative("a coefficient of friction")},
                                          {"spread", Parameter::spread, positive("a factor")}}};
  for (const Kind& kind : kinds) {
    if (!table.has(kind.key)) continue;
    if (result.family) table.refuse(kind.key, "a family has one parameter");
    result.family = GraspFamily{kind.parameter, read_sequence(table, kind.key, kind.values)};
  }
  if (!result.family) {
    table.refuse_table(
        "needs 'turn' or 'offset' (angles or offsets of the load), 'mu', or 'spread' (factors of the contacts' "
        "distance)");
  }
  const bool moves = result.family->parameter == Parameter::turn || result.family->parameter == Parameter::offset;
  if (table.has("axis")) {
    if (!moves) table.refuse("axis", "used with 'turn' and 'offset'");
    const SpaceVector axis = read_direction(table, "axis", "a direction [x, y, z], not 0");
    result.family->axis = Vector3(axis[0], axis[1], axis[2]).normalized();
  }
  if (result.question != GraspQuestion::least_grip) {
    scene.refuse("family", "asks for the least grip of each: not used with another question");
  }
  if (result.loads.size() > 1) scene.refuse("family", "used with one load");
}

void read_view(const TomlReader& scene, GraspScene& result) {
  if (!scene.has("view")) return;
  const TomlReader view = scene.table("view", {"azimuth", "elevation"});
  constexpr Quantity elevation{"an elevation in rad", smallest_size, std::numbers::pi / 2, true, true};
  if (view.has("azimuth")) result.azimuth = view.number("azimuth", any_angle("an angle in rad"));
  if (view.has("elevation")) result.elevation = view.number("elevation", elevation);
}

// What the question needs.
void check_question(const TomlReader& scene, const GraspScene& result) {
  const std::string_view name = grasp_questions[static_cast<std::size_t>(result.question)];
  const bool limited = result.question == GraspQuestion::holds_within ||
                       result.question == GraspQuestion::load_factor ||
                       result.question == GraspQuestion::worst_load_factor;
  for (const GraspContact& c : result.contacts) {
    if (limited && !c.limit) c.place.refuse(fmt::format("needs a 'limit' of its force, in N, for '{}'", name));
  }
  if (result.question == GraspQuestion::growing_grip &&
      std::ranges::none_of(result.contacts, [](const GraspContact& c) { return bool(c.grown); })) {
    scene.refuse("contacts", "'growing_grip' is asked of contacts between 'bodies'");
  }
  if (result.question == GraspQuestion::internal_forces && result.contacts.size() > most_internal_contacts) {
    scene.refuse("contacts", fmt::format("'internal_forces' is asked of at most {} contacts", most_internal_contacts));
  }
  const bool loaded = !result.weight.isZero(0) || scene.has("loads");
  if (asks_of_a_set(result.question)) {
    if (!loaded && result.disturbance.empty()) {
      scene.refuse("loads",
                   fmt::format("'{}' needs loads: [[loads]], a [disturbance], or an [object] with a 'mass'", name));
    }
  } else if (!asks_of_no_load(result.question) && !loaded) {
    scene.refuse("loads", fmt::format("'{}' needs a load: [[loads]], or an [object] with a 'mass'", name));
  }
  if (result.question == GraspQuestion::load_factor && !scene.has("loads")) {
    scene.refuse("loads", "'load_factor' needs the loads to multiply, under [[loads]]");
  }
  if (result.question == GraspQuestion::worst_load_factor && !scene.has("loads") && result.disturbance.empty()) {
    scene.refuse("loads", "'worst_load_factor' needs the loads to multiply: [[loads]] or a [disturbance]");
  }
}

}  // namespace

GraspScene read_grasp_scene(TomlDocument document, const MaterialLibrary& materials, std::string_view question) {
  GraspScene result;
  result.document = std::make_shared<const TomlDocument>(std::move(document));
  const TomlReader scene = scene_table(*result.document);
  for (const std::string_view key :
       {"contact", "friction", "poles", "adhesion", "load", "profile", "sweep", "surface"}) {
    if (scene.has(key)) scene.refuse(key, "not used by 'grasp', which takes [[contacts]]");
  }
  if (scene.has("title")) result.title = scene.text("title");
  result.contacts = read_grasp_contacts(scene, materials);
  result.place = scene.place("contacts");
  result.weight = read_weight(scene);
  read_loads(scene, result);
  read_question(scene, question, result);
  read_disturbance(scene, result);
  read_family(scene, result);
  read_view(scene, result);
  check_question(scene, result);
  return result;
}

}  // namespace patchgrip::cli
