#include <patchgrip/cli/scene/friction_reader.h>

#include <fmt/format.h>

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

}  // namespace

Law read_friction(const TomlReader& scene) {
  if (!scene.has("friction")) scene.refuse("friction", "a table [friction], with 'mu' say");
  const TomlReader table =
      scene.table("friction", {"mu", "mu_static", "mu_kinetic", "stribeck_velocity", "mu_viscous"});
  const Law law = read_dry(table);
  if (table.has("mu_viscous"))
    return law.with_viscous(table.number("mu_viscous", non_negative("a viscous coefficient in s/m")));
  if (!table.has("mu") && !table.has("mu_static")) {
    table.refuse_table("needs 'mu', or 'mu_static', 'mu_kinetic' and 'stribeck_velocity', or 'mu_viscous'");
  }
  return law;
}

std::string in_words(const Law& law) {
  std::string words = law.mu_static == law.mu_kinetic
                          ? fmt::format("Coulomb, mu = {}", law.mu_kinetic)
                          : fmt::format("Stribeck in the mean, mu(v) = {} + ({} - {}) exp(-v^2 / ({} m/s)^2)",
                                        law.mu_kinetic, law.mu_static, law.mu_kinetic, law.stribeck_velocity);
  if (law.mu_viscous != 0) words += fmt::format(", and viscous, mu_V = {} s/m", law.mu_viscous);
  return words;
}

}  // namespace patchgrip::cli
