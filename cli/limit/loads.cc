#include <patchgrip/cli/limit/loads.h>

#include <cmath>
#include <utility>

namespace patchgrip::cli {
namespace {

using friction::Wrench;

double count_of(const Sequence& sequence) noexcept { return static_cast<double>(sequence.size()); }

ForceLoads::Components force_of(const ForceLoads& set, std::size_t i) noexcept {
  if (const auto* const one = std::get_if<ForceLoads::Components>(&set.force)) return *one;
  const auto& polar = *std::get_if<ForceLoads::Polar>(&set.force);
  const double size = polar.size[i % polar.size.size()];
  const double angle = polar.angle[i / polar.size.size()];
  return {size * std::cos(angle), size * std::sin(angle)};
}

Wrench load_of(const ForceLoads& set, std::size_t i) noexcept {
  const auto [x, y] = force_of(set, i / set.moment.size());
  return {x, y, set.moment[i % set.moment.size()] + (set.at.x * y - set.at.y * x)};
}

Wrench load_of(const DirectionLoads& set, std::size_t i) noexcept {
  const double size = set.size[i % set.size.size()];
  i /= set.size.size();
  const double theta = set.polar[i % set.polar.size()];
  const double phi = set.azimuth[i / set.polar.size()];
  const double force = size * std::sin(theta);
  return {force * std::cos(phi), force * std::sin(phi), size * set.length * std::cos(theta)};
}

}  // namespace

double load_count(const LoadSet& set) noexcept {
  if (const auto* const directions = std::get_if<DirectionLoads>(&set)) {
    return count_of(directions->azimuth) * count_of(directions->polar) * count_of(directions->size);
  }
  const auto& loads = *std::get_if<ForceLoads>(&set);
  const auto* const polar = std::get_if<ForceLoads::Polar>(&loads.force);
  return count_of(loads.moment) * (polar == nullptr ? 1 : count_of(polar->size) * count_of(polar->angle));
}

Loads::Loads(std::vector<LoadTable> tables) : tables_(std::move(tables)), size_(0) {
  for (const LoadTable& table : tables_) size_ += static_cast<std::size_t>(load_count(table.set));
}

Loads::Entry Loads::entry(std::size_t i) const noexcept {
  auto table = tables_.begin();
  for (;; ++table) {
    const auto count = static_cast<std::size_t>(load_count(table->set));
    if (i < count) return {*table, i};
    i -= count;
  }
}

Wrench Loads::operator[](std::size_t i) const noexcept {
  const auto [table, index] = entry(i);
  return std::visit([index = index](const auto& loads) { return load_of(loads, index); }, table.set);
}

const Place& Loads::place(std::size_t i) const noexcept { return entry(i).table.place; }

}  // namespace patchgrip::cli
