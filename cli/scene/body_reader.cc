#include <patchgrip/cli/scene/body_reader.h>

#include <fmt/format.h>

#include <vector>

#include <patchgrip/cli/scene/nearest_name.h>

namespace patchgrip::cli {
namespace {

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

contact::Material read_material_of(const TomlReader& body, const MaterialLibrary& materials) {
  constexpr std::string_view one_of =
      "give one of 'material', 'youngs_modulus' with 'poisson_ratio', or 'rigid = true'";
  const bool rigid = body.flag("rigid");
  const bool elastic = body.has("youngs_modulus") || body.has("poisson_ratio");
  if (body.has("material")) {
    if (rigid || elastic) body.refuse("material", one_of);
    return named_material(body, materials);
  }
  if (rigid) {
    if (elastic) body.refuse("rigid", one_of);
    return contact::Material::rigid();
  }
  if (!elastic) body.refuse_table(one_of);
  const double modulus = body.number("youngs_modulus", youngs_modulus);
  return contact::Material::elastic(modulus, body.number("poisson_ratio", poisson_ratio));
}

Body read_body(const TomlReader& body, const MaterialLibrary& materials) {
  DescribedShape shape = read_shape(body);
  const contact::Material material = read_material_of(body, materials);
  const std::string name = body.has("material") ? body.text("material") + ", " : "";
  std::string words = body.flag("rigid") ? fmt::format("{}, rigid", shape.words)
                                         : fmt::format("{}, {}E = {:.6g} Pa, nu = {:.6g}", shape.words, name,
                                                       material.youngs_modulus, material.poisson_ratio);
  return {std::move(shape.shape), material, std::move(words)};
}

}  // namespace

std::pair<Body, Body> read_two_bodies(const TomlReader& contact, std::string_view key,
                                      const MaterialLibrary& materials) {
  const auto bodies = contact.tables(
      key, {"radius", "plane",       "concave",    "radii",    "cylinder",       "direction",     "stamp",
            "slope",  "coefficient", "exponent",   "terms",    "end_radius",     "points",        "mesh",
            "point",  "unit",        "height_map", "material", "youngs_modulus", "poisson_ratio", "rigid"});
  if (bodies.size() != 2) {
    contact.refuse(key, fmt::format("two bodies, each under [[{}]], not {}", contact.full_name(key), bodies.size()));
  }
  return {read_body(bodies[0], materials), read_body(bodies[1], materials)};
}

}  // namespace patchgrip::cli
