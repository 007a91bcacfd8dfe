#include <patchgrip/cli/scene/friction_reader.h>

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace patchgrip::cli {
namespace {

using friction::Law;

constexpr Quantity coefficient = non_negative("a coefficient of friction");

Law read_dry(const TomlReader& table) {
  const bool stribeck = table.has("mu_static") || table.has("mu_kinetic") || table.has("stribeck_velocity");
  if (table.has("mu")) {
    if (stribeck) table.refuse("mu", "give either 'mu' or 'mu_static', 'mu_kinetic' and 'stribeck_velocity'");
    return Law::coulomb(table.number("mu", coefficient));
  }
  if (!stribeck) return Law::coulomb(0);
  const double mu_static = table.number("mu_static", coefficient);
  const double mu_kinetic = table.number("mu_kinetic", coefficient);
  return Law::stribeck(mu_static, mu_kinetic, table.number("stribeck_velocity", positive("a speed in m/s")));
}

// Where its speed is taken: true at each point, false in the mean.
bool read_stribeck(const TomlReader& table) {
  constexpr std::array<std::string_view, 2> speeds{"mean", "local"};
  if (!table.has("stribeck")) return false;
  const bool local = table.choice("stribeck", speeds) == 1;
  if (!table.has("mu_static")) table.refuse("stribeck", "used with 'mu_static', 'mu_kinetic' and 'stribeck_velocity'");
  return local;
}

}  // namespace

TomlReader friction_table(const TomlReader& scene) {
  if (!scene.has("friction"))
    scene.refuse("friction", fmt::format("a table [{}], with 'mu' say", scene.full_name("friction")));
  return scene.table("friction", {"mu", "mu_static", "mu_kinetic", "stribeck_velocity", "stribeck", "mu_viscous"});
}

Law read_friction(const TomlReader& scene) {
  const TomlReader table = friction_table(scene);
  const Law law = read_dry(table);
  read_stribeck(table);
  if (table.has("mu_viscous"))
    return law.with_viscous(table.number("mu_viscous", non_negative("a viscous coefficient in s/m")));
  if (!table.has("mu") && !table.has("mu_static")) {
    table.refuse_table("needs 'mu', or 'mu_static', 'mu_kinetic' and 'stribeck_velocity', or 'mu_viscous'");
  }
  return law;
}

bool is_local_stribeck(const TomlReader& scene) {
  return scene.has("friction") && read_stribeck(friction_table(scene));
}

std::string in_words(const Law& law, bool local) {
  std::string words = law.mu_static == law.mu_kinetic
                          ? fmt::format("Coulomb, mu = {}", law.mu_kinetic)
                          : fmt::format("Stribeck {}, mu(v) = {} + ({} - {}) exp(-v^2 / ({} m/s)^2)",
                                        local ? "at each point" : "in the mean", law.mu_kinetic, law.mu_static,
                                        law.mu_kinetic, law.stribeck_velocity);
  if (law.mu_viscous != 0) words += fmt::format(", and viscous, mu_V = {} s/m", law.mu_viscous);
  return words;
}

}  // namespace patchgrip::cli
