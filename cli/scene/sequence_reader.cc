#include <patchgrip/cli/scene/sequence_reader.h>

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <vector>

namespace patchgrip::cli {
namespace {

constexpr std::int64_t most_values = 100'000'000;
constexpr std::size_t most_pairs = 100'000;

std::size_t read_count(const TomlReader& range) {
  constexpr std::string_view allowed = "a whole number from 2 to 100000000";
  if (!range.has("count")) range.refuse("count", allowed);
  const auto* const count = range.node("count").as_integer();
  if (count == nullptr || count->get() < 2 || count->get() > most_values) range.refuse("count", allowed);
  return static_cast<std::size_t>(count->get());
}

Sequence read_range(const TomlReader& range, const Quantity& quantity) {
  const double from = range.number("from", quantity);
  const double to = range.number("to", quantity);
  if (from == to) range.refuse("to", "an end other than 'from'; for one value, give that value instead of a range");
  const std::size_t count = read_count(range);
  constexpr std::array<std::string_view, 2> spacings{"linear", "log"};
  if (!range.has("spacing") || range.choice("spacing", spacings) == 0) return Sequence::equal_steps(from, to, count);
  if (from == 0 || to == 0 || (from < 0) != (to < 0))
    range.refuse("spacing", "\"log\" needs ends of the same sign, not 0");
  return Sequence::equal_ratios(from, to, count);
}

}  // namespace

Sequence read_sequence(const TomlReader& table, std::string_view key, const Quantity& quantity) {
  if (!table.has(key))
    table.refuse(key,
                 fmt::format("a number, a list of numbers or a range {{from, to, count}}: {}", quantity.allowed()));
  const toml::node& value = table.node(key);
  if (value.is_table()) return read_range(table.table(key, {"from", "to", "count", "spacing"}), quantity);
  if (!value.is_array()) return Sequence::of_values({table.number(key, quantity)});
  std::vector<double> values;
  for (const toml::node& element : *value.as_array()) {
    values.push_back(table.number(element, fmt::format("{}[{}]", key, values.size()), quantity));
  }
  if (values.empty()) table.refuse(key, "at least one number");
  return Sequence::of_values(std::move(values));
}

std::vector<std::array<double, 2>> read_pairs(const TomlReader& table, std::string_view key, std::string_view allowed,
                                              const Quantity& first, const Quantity& second) {
  std::vector<std::array<double, 2>> pairs;
  for (const toml::node& node : table.array(table.node(key), key, allowed)) {
    const std::string name = fmt::format("{}[{}]", key, pairs.size());
    const toml::array& pair = table.array(node, name, allowed);
    if (pair.size() != 2) table.refuse(node, name, allowed);
    pairs.push_back({table.number(pair[0], name, first), table.number(pair[1], name, second)});
  }
  if (pairs.empty() || pairs.size() > most_pairs) table.refuse(key, allowed);
  return pairs;
}

}  // namespace patchgrip::cli
