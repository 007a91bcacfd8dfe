#include <patchgrip/cli/scene/relaxation_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/contact/creep/standard_models.h>

namespace patchgrip::cli {
namespace {

using contact::CreepCompliance;
using contact::RelaxationModulus;

constexpr Quantity modulus = positive("a modulus in Pa");
constexpr Quantity viscosity = positive("a viscosity in Pa s");
constexpr Quantity time = positive("a time in s");
constexpr std::size_t most_modes = 50;

contact::Modes<double> read_modes(const TomlReader& table, const Quantity& strength) {
  constexpr std::string_view allowed = "modes [[strength, time in s], ...], at most 50";
  contact::Modes<double> modes;
  for (const toml::node& node : table.array(table.node("modes"), "modes", allowed)) {
    const std::string name = fmt::format("modes[{}]", modes.size());
    const toml::array& mode = table.array(node, name, allowed);
    if (mode.size() != 2) table.refuse(node, name, allowed);
    modes.push_back({table.number(mode[0], name, strength), table.number(mode[1], name, time)});
  }
  if (modes.empty() || modes.size() > most_modes) table.refuse("modes", allowed);
  return modes;
}

DescribedRelaxation of_modulus(RelaxationModulus relaxing, double nu, std::string words) {
  return {contact::ViscoelasticMaterial::of(std::move(relaxing), nu), std::move(words)};
}

DescribedRelaxation read_poynting_thomson(const TomlReader& body, double nu) {
  const TomlReader table = body.table("poynting_thomson", {"E1", "E2", "eta"});
  const double E1 = table.number("E1", modulus);
  const double E2 = table.number("E2", modulus);
  const double eta = table.number("eta", viscosity);
  return of_modulus(contact::PoyntingThomson::of(E1, E2, eta).modulus(), nu,
                    fmt::format("Poynting-Thomson, E1 = {} Pa, E2 = {} Pa, eta = {} Pa s", E1, E2, eta));
}

DescribedRelaxation read_kelvin_voigt(const TomlReader& body, double nu) {
  const TomlReader table = body.table("kelvin_voigt", {"E2", "eta"});
  const double E2 = table.number("E2", modulus);
  const double eta = table.number("eta", viscosity);
  return of_modulus(contact::kelvin_voigt(E2, eta), nu,
                    fmt::format("Kelvin-Voigt, E2 = {} Pa, eta = {} Pa s", E2, eta));
}

DescribedRelaxation read_maxwell(const TomlReader& body, double nu) {
  const TomlReader table = body.table("maxwell", {"E1", "eta"});
  const double E1 = table.number("E1", modulus);
  const double eta = table.number("eta", viscosity);
  return of_modulus(contact::maxwell(E1, eta), nu, fmt::format("Maxwell, E1 = {} Pa, eta = {} Pa s", E1, eta));
}

DescribedRelaxation read_relaxation_series(const TomlReader& body, double nu) {
  const TomlReader table = body.table("relaxation", {"E_inf", "modes"});
  const double E_inf = table.number("E_inf", non_negative("the modulus E_inf in Pa"));
  auto modes = read_modes(table, modulus);
  std::string words = fmt::format("relaxing, E_inf = {} Pa and {} modes", E_inf, modes.size());
  return of_modulus(RelaxationModulus::of(E_inf, std::move(modes)), nu, std::move(words));
}

DescribedRelaxation read_creep_series(const TomlReader& body, double nu) {
  const TomlReader table = body.table("creep", {"J_0", "modes", "fluidity"});
  const double J_0 = table.number("J_0", non_negative("the compliance J_0 in 1/Pa"));
  const double fluidity = table.has("fluidity") ? table.number("fluidity", non_negative("a fluidity in 1/(Pa s)")) : 0;
  auto modes = read_modes(table, positive("a compliance in 1/Pa"));
  std::string words = fmt::format("creeping, J_0 = {} 1/Pa and {} modes", J_0, modes.size());
  return {contact::ViscoelasticMaterial::of(CreepCompliance::of(J_0, std::move(modes), fluidity), nu),
          std::move(words)};
}

}  // namespace

std::optional<DescribedRelaxation> read_relaxation(const TomlReader& body) {
  using Read = DescribedRelaxation (*)(const TomlReader&, double);
  constexpr std::array<Read, relaxation_keys.size()> readers{read_poynting_thomson, read_kelvin_voigt, read_maxwell,
                                                             read_relaxation_series, read_creep_series};
  const auto key = std::ranges::find_if(relaxation_keys, [&](std::string_view k) { return body.has(k); });
  if (key == relaxation_keys.end()) return std::nullopt;
  for (const std::string_view other : relaxation_keys) {
    if (other != *key && body.has(other)) body.refuse(other, fmt::format("not used beside '{}'", *key));
  }
  const double nu = body.number("poisson_ratio", poisson_ratio);
  try {
    return readers[static_cast<std::size_t>(key - relaxation_keys.begin())](body, nu);
  } catch (const std::invalid_argument& error) {
    body.refuse(*key, error.what());
  }
}

}  // namespace patchgrip::cli
