#include <patchgrip/cli/scene/body_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <patchgrip/cli/scene/nearest_name.h>
#include <patchgrip/cli/scene/relaxation_reader.h>

namespace patchgrip::cli {
namespace {

constexpr std::array<std::string_view, 4> material_keys{"material", "youngs_modulus", "poisson_ratio", "rigid"};

template <std::size_t... N>
constexpr auto joined(const std::array<std::string_view, N>&... parts) {
  std::array<std::string_view, (N + ...)> all;
  auto end = all.begin();
  ((end = std::ranges::copy(parts, end).out), ...);
  return all;
}

contact::Material named_material(const TomlReader& body, const MaterialLibrary& materials) {
  const std::string name = body.text("material");
  const auto material = materials.find(name);
  if (!material) {
    const std::vector<std::string> names = materials.names();
    const std::vector<std::string_view> known(names.begin(), names.end());
    body.refuse("material", known.empty() ? "unknown material, and no folder of materials is found (--materials)"
                                          : "unknown material" + suggestion(name, known));
  }
  return *material;
}

struct BodyMaterial {
  contact::Material elastic;
  std::optional<contact::ViscoelasticMaterial> relaxing;
  std::string words;
};

BodyMaterial read_relaxing(const TomlReader& body, DescribedRelaxation relaxation) {
  for (const std::string_view other : {"material", "youngs_modulus", "rigid"}) {
    if (body.has(other)) body.refuse(other, "not used by a viscoelastic body");
  }
  // A dashpot alone answers a step like a rigid body.
  const double at_once = relaxation.material.compliance.instantaneous();
  const double nu = relaxation.material.poisson_ratio;
  const auto elastic = at_once > 0 ? contact::Material::elastic(1 / at_once, nu) : contact::Material::rigid();
  return {elastic, std::move(relaxation.material), fmt::format("{}, nu = {:.6g}", relaxation.words, nu)};
}

BodyMaterial read_material_of(const TomlReader& body, const MaterialLibrary& materials) {
  constexpr std::string_view one_of =
      "give one of 'material', 'youngs_modulus' with 'poisson_ratio', 'rigid = true', or a viscoelastic model";
  if (auto relaxation = read_relaxation(body)) return read_relaxing(body, *std::move(relaxation));
  const bool rigid = body.flag("rigid");
  const bool elastic = body.has("youngs_modulus") || body.has("poisson_ratio");
  const auto in_words = [](const contact::Material& m) {
    return fmt::format("E = {:.6g} Pa, nu = {:.6g}", m.youngs_modulus, m.poisson_ratio);
  };
  if (body.has("material")) {
    if (rigid || elastic) body.refuse("material", one_of);
    const contact::Material material = named_material(body, materials);
    return {material, std::nullopt, body.text("material") + ", " + in_words(material)};
  }
  if (rigid) {
    if (elastic) body.refuse("rigid", one_of);
    return {contact::Material::rigid(), std::nullopt, "rigid"};
  }
  if (!elastic) body.refuse_table(one_of);
  const double modulus = body.number("youngs_modulus", youngs_modulus);
  const auto material = contact::Material::elastic(modulus, body.number("poisson_ratio", poisson_ratio));
  return {material, std::nullopt, in_words(material)};
}

Body read_body(const TomlReader& body, const MaterialLibrary& materials) {
  DescribedShape shape = read_shape(body);
  BodyMaterial material = read_material_of(body, materials);
  std::string words = shape.words + ", " + material.words;
  return {std::move(shape.shape), material.elastic, std::move(material.relaxing), std::move(words), body.place()};
}

}  // namespace

BodyPair read_two_bodies(const TomlReader& contact, std::string_view key, const MaterialLibrary& materials) {
  static constexpr auto keys = joined(shape_keys, material_keys, relaxation_keys);
  const auto bodies = contact.tables(key, keys);
  if (bodies.size() != 2) {
    contact.refuse(key, fmt::format("two bodies, each under [[{}]], not {}", contact.full_name(key), bodies.size()));
  }
  return {read_body(bodies[0], materials), read_body(bodies[1], materials)};
}

}  // namespace patchgrip::cli
