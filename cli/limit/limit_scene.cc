#include <patchgrip/cli/limit/limit_scene.h>

#include <fmt/format.h>

#include <numbers>
#include <utility>
#include <vector>

#include <patchgrip/cli/scene/friction_reader.h>
#include <patchgrip/cli/scene/outline_reader.h>
#include <patchgrip/cli/scene/scene.h>
#include <patchgrip/cli/scene/sequence_reader.h>

namespace patchgrip::cli {
namespace {

constexpr Quantity force_size = positive("the size of a force in N");
constexpr Quantity component = any_sign("a component of a force in N");
constexpr Quantity moments = any_sign("a moment in N m");
constexpr Quantity angle = any_angle("an angle in rad");
constexpr Quantity polar_angle{"an angle from the axis of moments in rad", smallest_size, std::numbers::pi, true};
constexpr Quantity lengths = positive("a length in m");

std::variant<ForceLoads::Components, ForceLoads::Polar> read_force(const TomlReader& load) {
  if (!load.has("force")) return ForceLoads::Components{0, 0};
  constexpr std::string_view allowed = "a force [x, y] in N, or { size, angle } in N and rad";
  const toml::node& value = load.node("force");
  if (value.is_table()) {
    const TomlReader polar = load.table("force", {"size", "angle"});
    return ForceLoads::Polar{read_sequence(polar, "size", force_size), read_sequence(polar, "angle", angle)};
  }
  const toml::array& xy = load.array(value, "force", allowed);
  if (xy.size() != 2) load.refuse("force", allowed);
  return ForceLoads::Components{load.number(xy[0], "force[0]", component), load.number(xy[1], "force[1]", component)};
}

LoadSet read_force_loads(const TomlReader& load) {
  load.refuse_others({"force", "at", "moment"}, "not used beside 'force' and 'moment'");
  if (load.has("at") && !load.has("force")) load.refuse("at", "where the force acts: it needs 'force'");
  return ForceLoads{read_force(load), load.has("at") ? read_point(load, load.node("at"), "at") : friction::Pole{},
                    load.has("moment") ? read_sequence(load, "moment", moments) : Sequence::of_values({0})};
}

LoadSet read_direction_loads(const TomlReader& load, double area_radius) {
  load.refuse_others({"azimuth", "polar", "size", "length"}, "not used beside 'azimuth' and 'polar'");
  if (!load.has("length") && !(area_radius > 0)) {
    load.refuse("length", "a length in m that makes a force of the moment; this contact has no area to take it from");
  }
  return DirectionLoads{load.has("azimuth") ? read_sequence(load, "azimuth", angle) : Sequence::of_values({0}),
                        read_sequence(load, "polar", polar_angle),
                        load.has("size") ? read_sequence(load, "size", force_size) : Sequence::of_values({1}),
                        load.has("length") ? load.number("length", lengths) : area_radius};
}

Loads read_loads(const TomlReader& scene, double area_radius) {
  std::vector<LoadTable> tables;
  if (!scene.has("loads")) return Loads(std::move(tables));
  double total = 0;
  for (const TomlReader& load :
       scene.tables("loads", {"force", "at", "moment", "azimuth", "polar", "size", "length"})) {
    if (!load.has("force") && !load.has("moment") && !load.has("polar")) {
      load.refuse_table("needs 'force' or 'moment', or a direction by 'polar' and 'azimuth'");
    }
    tables.push_back(
        {load.has("polar") ? read_direction_loads(load, area_radius) : read_force_loads(load), load.place()});
    total += load_count(tables.back().set);
    if (total > most_loads) {
      load.refuse_table(fmt::format("that makes {:.0f} loads, but a scene may have at most {:.0f}", total, most_loads));
    }
  }
  return Loads(std::move(tables));
}

int read_steps(const TomlReader& surface, std::string_view key, int by_default) {
  if (!surface.has(key)) return by_default;
  constexpr std::string_view allowed = "a whole number from 4 to 4000";
  const auto* const steps = surface.node(key).as_integer();
  if (steps == nullptr || steps->get() < 4 || steps->get() > 4000) surface.refuse(key, allowed);
  return static_cast<int>(steps->get());
}

SurfaceRequest read_surface(const TomlReader& scene) {
  SurfaceRequest request;
  if (!scene.has("surface")) return request;
  const TomlReader surface = scene.table("surface", {"meridians", "parallels", "length", "view"});
  request.meridians = read_steps(surface, "meridians", request.meridians);
  request.parallels = read_steps(surface, "parallels", request.parallels);
  if (surface.has("length")) request.length = surface.number("length", lengths);
  if (surface.has("view")) {
    const TomlReader view = surface.table("view", {"azimuth", "elevation"});
    constexpr Quantity elevation{"an elevation in rad", smallest_size, std::numbers::pi / 2, true, true};
    if (view.has("azimuth")) request.azimuth = view.number("azimuth", angle);
    if (view.has("elevation")) request.elevation = view.number("elevation", elevation);
  }
  return request;
}

}  // namespace

LimitScene read_limit_scene(const TomlDocument& document, const MaterialLibrary& materials) {
  const TomlReader scene = scene_table(document);
  for (const std::string_view key : {"adhesion", "load"}) {
    if (scene.has(key)) scene.refuse(key, "not used by 'limit', which takes a constant normal force; see [[loads]]");
  }
  if (!scene.has("contact")) scene.refuse("contact", "a table [contact] with a patch, parts or two bodies");
  std::string title = scene.has("title") ? scene.text("title") : "";
  std::optional<double> mu;
  if (scene.has("friction")) mu = read_friction(scene).mu_static;
  const SurfaceRequest surface = read_surface(scene);
  Contact contact = read_contact(scene, materials);
  if (!(any_patch(contact).moments().polar > 0)) {
    scene.refuse("contact", "a single point, which holds no moment: give it a size, or add points that rub elsewhere");
  }
  Loads loads = read_loads(scene, any_patch(contact).area_radius());
  if (contact.resistance) mu.reset();  // parts have their own
  return {std::move(title),
          std::move(contact),
          mu,
          std::move(loads),
          surface,
          scene.place("contact"),
          scene.place(mu ? "friction" : "contact")};
}

}  // namespace patchgrip::cli
