#include <patchgrip/cli/scene/nearest_name.h>

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace patchgrip::cli {
namespace {

constexpr std::size_t longest_compared = 64;

}  // namespace

std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::vector<std::size_t>> d(from.size() + 1, std::vector<std::size_t>(to.size() + 1));
  for (std::size_t i = 0; i <= from.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= to.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = d[i - 1][j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[from.size()][to.size()];
}

std::optional<std::string_view> nearest_name(std::string_view name, std::span<const std::string_view> known) {
  std::optional<std::string_view> nearest;
  if (name.size() > longest_compared) return nearest;
  std::size_t least = name.size();
  for (const std::string_view candidate : known) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < least && distance <= std::max<std::size_t>(2, candidate.size() / 3)) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string suggestion(std::string_view name, std::span<const std::string_view> known) {
  if (known.empty()) return {};
  if (const auto nearest = nearest_name(name, known)) return fmt::format("; did you mean '{}'?", *nearest);
  std::string all;
  for (const std::string_view candidate : known) all += fmt::format("{}'{}'", all.empty() ? "" : ", ", candidate);
  return "; known are " + all;
}

}  // namespace patchgrip::cli
