#include <patchgrip/cli/simulate/simulate_scene.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <patchgrip/cli/scene/friction_reader.h>
#include <patchgrip/cli/scene/scene.h>
#include <patchgrip/cli/scene/sequence_reader.h>
#include <patchgrip/cli/simulate/applied_reader.h>
#include <patchgrip/dynamics/half_freedom_patch.h>

namespace patchgrip::cli {
namespace {

constexpr Quantity time_range = non_negative("a time in s");

constexpr std::array<std::string_view, 11> method_names{
    "rigid",          "return_mapping", "elastoplastic", "elastoplastic_printed",
    "half_freedom",   "lugre",          "dahl",          "half_freedom_linearised",
    "boundary_layer", "tanh",           "karnopp"};

bool has_bristles(FrictionMethod m) {
  return m >= FrictionMethod::return_mapping && m <= FrictionMethod::boundary_layer;
}
bool is_half_freedom(FrictionMethod m) {
  return m == FrictionMethod::half_freedom || m == FrictionMethod::half_freedom_linearised;
}
bool is_smooth_patch(FrictionMethod m) {
  return m >= FrictionMethod::elastoplastic && m <= FrictionMethod::half_freedom;
}

// --- what presses on it

// What acts may change as fast as the steps that see it can follow; return mapping has its own step.
Quantity followed_frequency(const Following& f) {
  if (f.method == FrictionMethod::return_mapping) return positive("an angular frequency in rad/s");
  const double end = f.times[f.times.size() - 1];
  return {"an angular frequency in rad/s that steps of 1/40 of a period can follow to the last of 'times'",
          smallest_size, std::min(largest_size, 2 * std::numbers::pi / steps_a_period * most_steps / end)};
}

// The normal force over time.
Course read_pressing(const TomlReader& scene, bool point, const Following& f) {
  const FrictionMethod method = f.method;
  if (!scene.has("normal_force")) return ConstantCourse{};
  const TomlReader table = scene.table("normal_force", courses);
  if (!point && is_smooth_patch(method))
    scene.refuse("normal_force", fmt::format("not used by method = \"{}\" of a patch", name_of(method)));
  if (is_half_freedom(method))  // its damping bounds one force
    scene.refuse("normal_force", fmt::format("not used by method = \"{}\"", name_of(method)));
  return read_course(table, {non_negative("a factor of the normal force, which only presses"),
                             {"a mean of the factor of the normal force, which only presses", 1, largest_size},
                             followed_frequency(f)});
}

// How the patch grows with it.
double read_growth(const TomlReader& scene, const Contact& contact) {
  if (!scene.has("normal_force")) return 0;
  if (!contact.growth) {
    scene.refuse("normal_force",
                 "used with a contact whose pressure keeps its shape: a patch, balls and other curved bodies, cones, "
                 "powers, flat punches, fingertips by a power law, parts that are not Hertz's");
  }
  if (*contact.growth != 0 && (contact.frame.x != 0 || contact.frame.y != 0)) {
    contact_table(scene).refuse(
        "centre", "[0, 0], the centre of mass, under a [normal_force] with which the patch grows about its own centre");
  }
  return *contact.growth;
}

// --- how it is followed

BristleSettings read_bristles(const TomlReader& table, bool point, FrictionMethod method) {
  BristleSettings b;
  const bool half = is_half_freedom(method);
  b.stiffness = table.number("stiffness", positive("the stiffness of the bristles in N/m"));
  if (half || table.has("damping")) {
    b.damping = table.number("damping", half ? positive("a damping in N s/m") : non_negative("a damping in N s/m"));
  }
  if (point) {
    b.elastic_share = 0.9;
  } else {
    b.turn_stiffness = table.number("turn_stiffness", positive("the stiffness of the bristles to turns in N m"));
    if (half || table.has("turn_damping")) {
      b.turn_damping =
          table.number("turn_damping", half ? positive("a damping in N m s") : non_negative("a damping in N m s"));
    }
  }
  if (table.has("elastic_share"))
    b.elastic_share = table.number("elastic_share", {"a share of the limit", 1e-3, 0.9999});
  if (table.has("nu0")) b.nu0 = table.number("nu0", positive("nu_0"));
  if (table.has("length")) b.length = table.number("length", positive("the length L of the metric in m"));
  return b;
}

void refuse_unused(const TomlReader& motion, const Following& f, bool point) {
  const FrictionMethod m = f.method;
  const bool mapping = m == FrictionMethod::return_mapping;
  const bool plastic = m == FrictionMethod::elastoplastic || m == FrictionMethod::elastoplastic_printed;
  const auto refuse_unless = [&](bool used, std::initializer_list<std::string_view> keys) {
    for (const std::string_view key : keys) {
      if (!used && motion.has(key)) motion.refuse(key, fmt::format("not used by method = \"{}\"", name_of(m)));
    }
  };
  refuse_unless(has_bristles(m), {"stiffness", "damping"});
  refuse_unless(has_bristles(m) && !point, {"turn_stiffness", "turn_damping"});
  refuse_unless(plastic, {"elastic_share", "nu0"});
  refuse_unless(m == FrictionMethod::elastoplastic && !point, {"length"});
  refuse_unless(mapping, {"integrator", "step"});
  refuse_unless(!mapping, {"tolerance"});
  refuse_unless(m == FrictionMethod::tanh || m == FrictionMethod::boundary_layer, {"steepness"});
  refuse_unless(m == FrictionMethod::boundary_layer, {"zone_mass"});
  refuse_unless(m == FrictionMethod::karnopp, {"dead_band"});
  refuse_unless(!point && m != FrictionMethod::rigid, {"rest_speed"});
}

void check_method(const TomlReader& motion, FrictionMethod m, bool point) {
  const bool of_points = m != FrictionMethod::return_mapping && m != FrictionMethod::elastoplastic_printed;
  const bool of_patches = m <= FrictionMethod::half_freedom;
  if (point && !of_points) {
    motion.refuse("method",
                  "of a point: rigid, elastoplastic, half_freedom, half_freedom_linearised, lugre, dahl, "
                  "boundary_layer, tanh or karnopp");
  }
  if (!point && !of_patches)
    motion.refuse("method", "of a patch: rigid, return_mapping, elastoplastic, elastoplastic_printed or half_freedom");
}

constexpr std::array<std::string_view, 16> motion_keys{
    "method",        "integrator", "step",   "tolerance", "stiffness", "turn_stiffness", "damping",    "turn_damping",
    "elastic_share", "nu0",        "length", "steepness", "zone_mass", "dead_band",      "rest_speed", "times"};

Following read_following(const TomlReader& scene, bool point) {
  if (!scene.has("motion")) scene.refuse("motion", "a table [motion] with 'times', and 'method' unless it is rigid");
  const TomlReader motion = scene.table("motion", motion_keys);
  Following f;
  if (motion.has("method")) f.method = static_cast<FrictionMethod>(motion.choice("method", method_names));
  check_method(motion, f.method, point);
  refuse_unused(motion, f, point);
  if (has_bristles(f.method)) f.bristle = read_bristles(motion, point, f.method);
  if (f.method == FrictionMethod::return_mapping) {
    constexpr std::array<std::string_view, 2> integrators{"sdirk2", "implicit_euler"};
    f.implicit_euler = motion.has("integrator") && motion.choice("integrator", integrators) == 1;
    f.step = motion.number("step", positive("a step in s"));
  }
  if (f.method == FrictionMethod::boundary_layer)
    f.zone_mass = motion.number("zone_mass", positive("the mass of the contact zone in kg"));
  if (f.method == FrictionMethod::tanh || f.method == FrictionMethod::boundary_layer)
    f.steepness = motion.number("steepness", positive("the steepness a in s/m"));
  if (f.method == FrictionMethod::karnopp) f.dead_band = motion.number("dead_band", positive("a velocity in m/s"));
  if (motion.has("tolerance")) f.tolerance = motion.number("tolerance", {"a tolerance of a step", 1e-13, 1e-4});
  if (motion.has("rest_speed")) f.rest_speed = motion.number("rest_speed", positive("a velocity in m/s"));
  f.times = read_sequence(motion, "times", time_range);
  for (std::size_t i = 0; i < f.times.size(); ++i) {
    if (i > 0 && !(f.times[i] > f.times[i - 1])) motion.refuse("times", "times in s, each later than the one before");
  }
  if (static_cast<double>(f.times.size()) > most_times)
    motion.refuse("times", fmt::format("at most {:.0f} times", most_times));
  const double end = f.times[f.times.size() - 1];
  if (!(end > 0)) motion.refuse("times", "times in s, the last one above 0");
  if (f.step > 0 && end / f.step > most_steps)
    motion.refuse("step", fmt::format("at least the last of 'times' / {:.0e}", most_steps));
  return f;
}

friction::Law read_law(const TomlReader& scene, const Contact& contact, bool point, const Following& f) {
  if (contact.resistance) return friction::Law::coulomb(*contact.resistance / contact.normal_force);
  const friction::Law law = read_friction(scene);
  if (is_local_stribeck(scene))
    friction_table(scene).refuse("stribeck", "\"mean\": 'simulate' takes Stribeck's law in the mean");
  const bool of_patches = f.method == FrictionMethod::return_mapping || is_smooth_patch(f.method);
  if (law.mu_viscous > 0 && of_patches && !(point && f.method == FrictionMethod::half_freedom))
    friction_table(scene).refuse("mu_viscous", fmt::format("not used by method = \"{}\"", name_of(f.method)));
  return law;
}

// Dampers of half a degree of freedom must be stronger than friction falls with speed.
void check_damping(const TomlReader& scene, const Contact& contact, bool point, const friction::Law& law,
                   const BristleSettings& b) {
  const Place place = scene.place("motion");
  if (point) {
    const double least = dynamics::least_damping(law, contact.normal_force) - law.mu_viscous * contact.normal_force;
    if (!(b.damping > least)) place.refuse(fmt::format("damping must be above {:g} N s/m, or the zone jumps", least));
    return;
  }
  const dynamics::HalfFreedomParameters p{{b.stiffness, b.stiffness, b.turn_stiffness},
                                          {b.damping, b.damping, b.turn_damping}};
  try {
    p.check(any_patch(contact).moments(), law, contact.normal_force);
  } catch (const std::invalid_argument& error) {
    place.refuse(error.what());
  }
}

void require_size(const TomlReader& scene, const Contact& contact) {
  if (!(any_patch(contact).moments().polar > 0))
    scene.refuse("contact", "a single point has patch = \"point\"; a body in the plane needs a contact with a size");
}

// --- what lies on it

constexpr std::array<std::string_view, 5> upper_keys{"contact", "friction", "body", "applied", "bristles"};

UpperBody read_upper(const TomlReader& scene, bool point, const Following& f, const MaterialLibrary& materials) {
  const TomlReader upper = scene.table("upper", upper_keys);
  if (point) scene.refuse("upper", "used on a body in the plane, not on a point");
  if (f.method != FrictionMethod::return_mapping)
    scene.refuse("upper", "a body on another one is followed by method = \"return_mapping\"");
  if (scene.has("normal_force")) scene.refuse("normal_force", "not used with [upper]: the normal forces are constant");
  if (f.rest_speed) scene.table("motion", motion_keys).refuse("rest_speed", "not used with [upper]");
  if (!upper.has("contact")) upper.refuse("contact", "a table [upper.contact] with a patch, parts or two bodies");
  const MovingBody body = read_body(upper, false);
  if (body_table(upper).has("settled"))
    body_table(upper).refuse("settled", "given in [body], for the bristles of both contacts");
  if (!upper.has("bristles"))
    upper.refuse("bristles", "a table [upper.bristles] with 'stiffness' and 'turn_stiffness'");
  const TomlReader bristles = upper.table("bristles", {"stiffness", "turn_stiffness", "damping", "turn_damping"});
  const BristleSettings bristle = read_bristles(bristles, false, f.method);
  AppliedLoads loads(read_applied(upper, false, followed_frequency(f)));
  Contact contact = read_contact(upper, materials);
  if (!(any_patch(contact).moments().polar > 0)) {
    const TomlReader table = contact_table(upper);
    table.refuse(table.has("patch") ? "patch" : "parts", "a patch with a size");
  }
  const friction::Law law = read_law(upper, contact, false, f);
  return {std::move(contact), law, body, std::move(loads), bristle};
}

void require_both_weights(const TomlReader& table, const Contact& lower, const Contact& upper) {
  if (lower.normal_force >= upper.normal_force) return;
  const std::string allowed =
      fmt::format("both weights, at least the {} N of the normal force of [upper.contact]", upper.normal_force);
  if (table.has("normal_force")) table.refuse("normal_force", allowed);
  table.refuse_table(fmt::format("its normal force of {} N carries {}", lower.normal_force, allowed));
}

}  // namespace

std::string_view name_of(FrictionMethod method) { return method_names[static_cast<std::size_t>(method)]; }

SimulateScene read_simulate_scene(const TomlDocument& document, const MaterialLibrary& materials) {
  const TomlReader scene = scene_table(document);
  for (const std::string_view key : {"adhesion", "load", "loads"}) {
    if (scene.has(key)) scene.refuse(key, "not used by 'simulate'; what acts over time is under [[applied]]");
  }
  if (!scene.has("contact")) scene.refuse("contact", "a table [contact] with a patch, parts or two bodies");
  const TomlReader table = contact_table(scene);
  const bool point = table.has("patch") && table.node("patch").as_string() != nullptr && table.text("patch") == "point";
  std::string title = scene.has("title") ? scene.text("title") : "";
  const MovingBody body = read_body(scene, point);
  Following following = read_following(scene, point);
  if (body.settled && !has_bristles(following.method)) {
    body_table(scene).refuse("settled", fmt::format("not used by method = \"{}\"", name_of(following.method)));
  }
  const Course pressing = read_pressing(scene, point, following);
  std::optional<UpperBody> upper;
  if (scene.has("upper")) upper = read_upper(scene, point, following, materials);
  std::vector<Course> others{pressing};
  if (upper) std::ranges::copy(upper->loads.courses(), std::back_inserter(others));
  AppliedLoads loads(read_applied(scene, point, followed_frequency(following)), others);
  Contact contact = read_contact(scene, materials);
  const double most = largest_value(pressing, following.times[following.times.size() - 1]);
  if (most != 1 && most > 0) contact.warnings = read_contact(scene, materials, most).warnings;
  const double growth = read_growth(scene, contact);
  if (!point) require_size(scene, contact);
  if (upper) require_both_weights(table, contact, upper->contact);
  const friction::Law law = read_law(scene, contact, point, following);
  if (is_half_freedom(following.method)) check_damping(scene, contact, point, law, following.bristle);
  return {std::move(title),
          std::move(contact),
          point,
          law,
          body,
          std::move(loads),
          pressing,
          growth,
          std::move(following),
          std::move(upper),
          scene.place("motion")};
}

}  // namespace patchgrip::cli
