#include <patchgrip/cli/simulate/moving_body.h>

#include <fmt/format.h>

namespace patchgrip::cli {

TomlReader body_table(const TomlReader& scene) {
  if (!scene.has("body")) scene.refuse("body", fmt::format("a table [{}] with its 'mass'", scene.full_name("body")));
  return scene.table("body", {"mass", "inertia", "place", "angle", "velocity", "spin", "settled", "spring", "damper",
                              "support_speed"});
}

dynamics::Vector3 read_pair(const TomlReader& table, std::string_view key, const Quantity& quantity,
                            std::string_view allowed) {
  if (!table.has(key)) return dynamics::Vector3::Zero();
  const toml::array& xy = table.array(table.node(key), key, allowed);
  if (xy.size() != 2) table.refuse(key, allowed);
  return {table.number(xy[0], fmt::format("{}[0]", key), quantity),
          table.number(xy[1], fmt::format("{}[1]", key), quantity), 0};
}

MovingBody read_body(const TomlReader& scene, bool point) {
  constexpr Quantity speed = any_sign("a velocity in m/s");
  const TomlReader table = body_table(scene);
  MovingBody body{.mass = table.number("mass", positive("a mass in kg"))};
  body.place = read_pair(table, "place", any_sign("a place in m"), "a place [x, y] in m");
  body.twist = read_pair(table, "velocity", speed, "a velocity [vx, vy] in m/s");
  body.settled = table.flag("settled");
  if (point) {
    for (const std::string_view key : {"inertia", "angle", "spin"}) {
      if (table.has(key)) table.refuse(key, "a point does not turn");
    }
    if (body.place[1] != 0 || body.twist[1] != 0)
      table.refuse(body.place[1] != 0 ? "place" : "velocity", "a point moves along x: its second component is 0");
    if (table.has("spring")) body.spring = table.number("spring", non_negative("a stiffness in N/m"));
    if (table.has("damper")) body.damper = table.number("damper", non_negative("a damping in N s/m"));
    if (table.has("support_speed")) body.support_speed = table.number("support_speed", speed);
    return body;
  }
  for (const std::string_view key : {"spring", "damper", "support_speed"}) {
    if (table.has(key)) table.refuse(key, "used with patch = \"point\"");
  }
  body.inertia = table.number("inertia", positive("a moment of inertia about the centre of mass in kg m^2"));
  if (table.has("angle")) body.place[2] = table.number("angle", any_angle("an angle in rad"));
  if (table.has("spin")) body.twist[2] = table.number("spin", any_sign("an angular velocity in rad/s"));
  return body;
}

}  // namespace patchgrip::cli
