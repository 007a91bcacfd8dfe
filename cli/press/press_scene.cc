#include <patchgrip/cli/press/press_scene.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <patchgrip/cli/scene/contact_reader.h>
#include <patchgrip/cli/scene/fingertip_reader.h>
#include <patchgrip/cli/scene/friction_reader.h>
#include <patchgrip/cli/scene/patch_reader.h>
#include <patchgrip/cli/scene/profile_of.h>
#include <patchgrip/cli/scene/scene.h>
#include <patchgrip/cli/scene/sequence_reader.h>
#include <patchgrip/contact/adhesion/tabor.h>

namespace patchgrip::cli {
namespace {

constexpr Quantity force_range = positive("a force in N");
constexpr Quantity adhesive_force_range = any_sign("a force in N, negative where adhesion holds a pull");
constexpr Quantity approach_range = positive("an approach in m");
constexpr Quantity adhesive_approach_range = any_sign("an approach in m");
constexpr Quantity radius_range = positive("a radius of the contact in m");
constexpr Quantity time_range = non_negative("a time in s");

constexpr std::array<std::string_view, 3> load_names{"normal_force", "approach", "contact_radius"};
constexpr std::array<std::string_view, 5> sweep_names{"normal_force", "approach", "contact_radius", "radii_ratio",
                                                      "mu"};

std::string_view name_of(SweepKind kind) { return sweep_names[static_cast<std::size_t>(kind)]; }

const Quantity& range_of(LoadKind kind, bool adhesive) {
  if (kind == LoadKind::normal_force) return adhesive ? adhesive_force_range : force_range;
  if (kind == LoadKind::approach) return adhesive ? adhesive_approach_range : approach_range;
  return radius_range;
}

// --- what touches

struct Described {
  Subject subject;
  std::vector<std::string> notes;
  Place place;
};

Described read_bodies(const TomlReader& contact, const MaterialLibrary& materials) {
  contact.refuse_others({"bodies", "normal_force", "approach", "contact_radius", "centre", "angle", "model"},
                        "not used beside 'bodies'; give bodies, a patch or a fingertip");
  BodyPair pair = read_two_bodies(contact, "bodies", materials);
  std::vector<std::string> notes{"body A: " + pair.first.words, "body B: " + pair.second.words};
  return {std::move(pair), std::move(notes), contact.place("bodies")};
}

Described read_given_pressure(const TomlReader& contact) {
  DescribedPatch patch = read_patch(contact);
  const double modulus = contact.number("contact_modulus", positive("the contact modulus E* in Pa"));
  return {GivenPressure{std::move(patch.patch), modulus},
          {std::move(patch.words), fmt::format("contact modulus {} Pa", modulus)},
          contact.place("patch")};
}

Described read_pressed_fingertip(const TomlReader& contact) {
  contact.refuse_others({"fingertip", "normal_force", "approach", "contact_radius", "centre", "angle"},
                        "not used beside 'fingertip'; give bodies, a patch or a fingertip");
  DescribedFingertip described = read_fingertip(contact);
  return {std::visit([](auto& tip) -> Subject { return std::move(tip); }, described.tip),
          {std::move(described.words)},
          std::move(described.place)};
}

Described read_subject(const TomlReader& contact, const MaterialLibrary& materials) {
  if (contact.has("parts")) contact.refuse("parts", "rubbed, but not pressed: give bodies, a patch or a fingertip");
  if (contact.has("bodies")) return read_bodies(contact, materials);
  if (contact.has("patch")) return read_given_pressure(contact);
  if (contact.has("fingertip")) return read_pressed_fingertip(contact);
  contact.refuse_table("needs two tables [[contact.bodies]], 'patch' (a pressure) or 'fingertip'");
}

// --- how it is loaded

std::optional<StaticLoad> read_static_load(const TomlReader& contact, bool adhesive) {
  std::optional<StaticLoad> load;
  for (std::size_t i = 0; i < load_names.size(); ++i) {
    if (!contact.has(load_names[i])) continue;
    if (load) contact.refuse(load_names[i], "one of 'normal_force', 'approach' and 'contact_radius'");
    const auto kind = static_cast<LoadKind>(i);
    load = StaticLoad{kind, contact.number(load_names[i], range_of(kind, adhesive)), contact.place(load_names[i])};
  }
  return load;
}

contact::History read_points(const TomlReader& load, std::string_view key, const Quantity& quantity) {
  std::vector<contact::HistoryPoint<double>> points;
  for (const auto& [t, value] :
       read_pairs(load, key, "points [[t, value], ...] over time in s", time_range, quantity)) {
    points.push_back({t, value});
  }
  return made(load, key, [&] { return contact::History::points(points); });
}

contact::History read_sine(const TomlReader& load) {
  const TomlReader sine = load.table("sine", {"mean", "swing", "angular_frequency"});
  const double mean = sine.number("mean", force_range);
  const double swing = sine.number("swing", {"a swing relative to the mean", 0, 1});
  const double frequency = sine.number("angular_frequency", positive("an angular frequency in rad/s"));
  return made(load, "sine", [&] { return contact::History::sine(mean, swing, frequency); });
}

contact::History read_half_sine(const TomlReader& load) {
  const TomlReader sine = load.table("half_sine", {"peak", "angular_frequency"});
  const double peak = sine.number("peak", force_range);
  const double frequency = sine.number("angular_frequency", positive("an angular frequency in rad/s"));
  return made(load, "half_sine", [&] { return contact::History::half_sine(peak, frequency); });
}

TimedLoad read_timed_load(const TomlReader& scene) {
  const TomlReader load = scene.table("load", {"normal_force", "approach", "sine", "half_sine", "times"});
  constexpr std::array<std::string_view, 4> forms{"normal_force", "approach", "sine", "half_sine"};
  const auto has = [&](std::string_view form) { return load.has(form); };
  if (std::ranges::count_if(forms, has) != 1)
    load.refuse_table("needs one of 'normal_force', 'approach', 'sine' and 'half_sine'");
  Sequence times = read_sequence(load, "times", time_range);
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!(times[i] > times[i - 1])) load.refuse("times", "times in s, each later than the one before");
  }
  constexpr Quantity forces = non_negative("a force in N");
  constexpr Quantity approaches = non_negative("an approach in m");
  if (load.has("approach")) {
    return {LoadKind::approach, read_points(load, "approach", approaches), std::move(times), load.place("approach"),
            load.place("times")};
  }
  contact::History history = load.has("sine")        ? read_sine(load)
                             : load.has("half_sine") ? read_half_sine(load)
                                                     : read_points(load, "normal_force", forces);
  return {LoadKind::normal_force, std::move(history), std::move(times), load.place(*std::ranges::find_if(forms, has)),
          load.place("times")};
}

// --- what else acts, and what is asked for

Adhesion read_adhesion(const TomlReader& scene) {
  const TomlReader table = scene.table("adhesion", {"work", "stress", "equilibrium_distance"});
  Adhesion adhesion{table.number("work", positive("the work of adhesion w in J/m^2")), std::nullopt,
                    scene.place("adhesion")};
  if (table.has("stress") && table.has("equilibrium_distance")) {
    table.refuse("stress", "give either 'stress' or 'equilibrium_distance'");
  }
  if (table.has("stress"))
    adhesion.stress = table.number("stress", positive("the stress sigma_0 of the attraction in Pa"));
  if (table.has("equilibrium_distance")) {
    const double distance = table.number("equilibrium_distance", positive("the distance z_0 in m"));
    adhesion.stress =
        made(table, "equilibrium_distance", [&] { return contact::lennard_jones_attraction(adhesion.work, distance); });
  }
  return adhesion;
}

ProfileRequest read_profile(const TomlReader& scene) {
  const TomlReader table = scene.table("profile", {"distance", "angle", "times"});
  ProfileRequest profile;
  profile.place = table.has("times") ? table.place("times") : scene.place("profile");
  if (table.has("distance")) profile.distance = read_sequence(table, "distance", non_negative("a distance in m"));
  if (table.has("angle")) profile.angle = table.number("angle", any_angle("an angle in rad"));
  if (table.has("times")) profile.times = read_sequence(table, "times", time_range);
  return profile;
}

Sweep read_sweep(const TomlReader& scene, bool adhesive) {
  const TomlReader table = scene.table("sweep", {"normal_force", "approach", "contact_radius", "radii_ratio", "mu"});
  std::optional<Sweep> sweep;
  for (std::size_t i = 0; i < sweep_names.size(); ++i) {
    if (!table.has(sweep_names[i])) continue;
    if (sweep) table.refuse(sweep_names[i], "one quantity is swept at a time");
    const auto kind = static_cast<SweepKind>(i);
    const Quantity range = kind == SweepKind::radii_ratio ? Quantity{"a ratio of the radii R_small / R_large", 1e-12, 1}
                           : kind == SweepKind::mu        ? positive("a coefficient of friction")
                                                          : range_of(static_cast<LoadKind>(i), adhesive);
    sweep = Sweep{kind, read_sequence(table, sweep_names[i], range), table.place(sweep_names[i])};
  }
  if (!sweep) table.refuse_table("needs one of 'normal_force', 'approach', 'contact_radius', 'radii_ratio' and 'mu'");
  return *std::move(sweep);
}

void check_profile(const TomlReader& scene, const PressScene& press) {
  const bool timed = std::holds_alternative<TimedLoad>(press.load);
  if (press.profile.times && !timed) scene.refuse("profile", "'times' is used beside [load]");
  if (press.profile.distance && timed && !press.profile.times) {
    scene.refuse("profile", "beside [load] 'distance' needs 'times'");
  }
}

void check_sweep(const TomlReader& scene, const PressScene& press) {
  if (!press.sweep) return;
  const auto* pair = std::get_if<BodyPair>(&press.subject);
  if (press.sweep->kind == SweepKind::mu && (pair == nullptr || !relative_radius_of(*pair) || press.adhesion)) {
    scene.refuse("sweep", "'mu' moves the zone of stick between balls, hollows and planes without adhesion");
  }
  if (press.sweep->kind != SweepKind::radii_ratio) return;
  if (pair == nullptr || !std::holds_alternative<CurvedSurface>(pair->first.shape) ||
      !std::holds_alternative<Plane>(pair->second.shape)) {
    scene.refuse("sweep", "'radii_ratio' varies the smaller of the two 'radii' of body A, on a plane body B");
  }
}

}  // namespace

PressScene read_press_scene(const TomlDocument& document, const MaterialLibrary& materials) {
  const TomlReader scene = scene_table(document);
  if (!scene.has("contact")) scene.refuse("contact", "a table [contact] with two bodies, a patch or a fingertip");
  const TomlReader contact = contact_table(scene);
  Described described = read_subject(contact, materials);
  std::optional<Adhesion> adhesion;
  if (scene.has("adhesion")) adhesion = read_adhesion(scene);
  std::optional<Sweep> sweep;
  if (scene.has("sweep")) sweep = read_sweep(scene, adhesion.has_value());

  auto static_load = read_static_load(contact, adhesion.has_value());
  std::variant<StaticLoad, TimedLoad> load;
  bool load_is_swept = false;
  if (scene.has("load")) {
    if (static_load)
      contact.refuse_table("the load is under [load]: no 'normal_force', 'approach' or 'contact_radius' here");
    if (sweep) scene.refuse("sweep", "not used beside [load]");
    load = read_timed_load(scene);
  } else if (static_load) {
    load = *static_load;
  } else if (sweep && sweep->kind <= SweepKind::contact_radius) {
    load = StaticLoad{static_cast<LoadKind>(sweep->kind), sweep->values[0], sweep->place};
    load_is_swept = true;
  } else {
    contact.refuse_table("needs 'normal_force', 'approach' or 'contact_radius', or a table [load]");
  }

  PressScene press{scene.has("title") ? scene.text("title") : "",
                   std::move(described.notes),
                   std::move(described.subject),
                   std::move(described.place),
                   std::move(load),
                   load_is_swept,
                   adhesion,
                   std::nullopt,
                   scene.has("profile") ? read_profile(scene) : ProfileRequest{},
                   std::move(sweep)};
  if (scene.has("friction")) press.mu = read_friction(scene).mu_static;
  check_profile(scene, press);
  check_sweep(scene, press);
  return press;
}

const Place& load_place(const PressScene& scene) {
  return std::visit([](const auto& load) -> const Place& { return load.place; }, scene.load);
}

PressScene at_sweep_value(PressScene scene, std::size_t index) {
  const Sweep& sweep = *scene.sweep;
  const double value = sweep.values[index];
  auto& load = std::get<StaticLoad>(scene.load);
  load.place = {sweep.place.file, sweep.place.line,
                fmt::format("sweep.{}[{}] = {}", name_of(sweep.kind), index, value)};
  switch (sweep.kind) {
    case SweepKind::radii_ratio: {
      auto& radii = std::get<CurvedSurface>(std::get<BodyPair>(scene.subject).first.shape).radii;
      const double large = std::max(radii[0], radii[1]);
      radii = radii[0] >= radii[1] ? std::array{large, value * large} : std::array{value * large, large};
      break;
    }
    case SweepKind::mu:
      scene.mu = value;
      break;
    default:
      load.kind = static_cast<LoadKind>(sweep.kind);
      load.value = value;
  }
  return scene;
}

}  // namespace patchgrip::cli
