#include <patchgrip/cli/scene/vector_reader.h>

#include <fmt/format.h>

namespace patchgrip::cli {

SpaceVector read_vector(const TomlReader& table, std::string_view key, std::string_view allowed,
                        const Quantity& component) {
  if (!table.has(key)) table.refuse(key, allowed);
  const toml::array& values = table.array(table.node(key), key, allowed);
  if (values.size() != 3) table.refuse(key, allowed);
  SpaceVector vector;
  for (std::size_t i = 0; i < 3; ++i) vector[i] = table.number(values[i], fmt::format("{}[{}]", key, i), component);
  return vector;
}

SpaceVector read_direction(const TomlReader& table, std::string_view key, std::string_view allowed) {
  const SpaceVector vector = read_vector(table, key, allowed, any_sign("a component of a direction"));
  if (vector == SpaceVector{}) table.refuse(key, allowed);
  return vector;
}

}  // namespace patchgrip::cli
