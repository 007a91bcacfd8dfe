#include <patchgrip/cli/limit/loads.h>

#include <utility>

#include <patchgrip/cli/scene/direction.h>

namespace patchgrip::cli {
namespace {

using friction::Wrench;

double count_of(const Sequence& sequence) noexcept { return static_cast<double>(sequence.size()); }

ForceLoads::Components force_of(const ForceLoads& set, std::size_t i) noexcept {
  if (const auto* const one = std::get_if<ForceLoads::Components>(&set.force)) return *one;
  const auto& polar = *std::get_if<ForceLoads::Polar>(&set.force);
  const double size = polar.size[i % polar.size.size()];
  const Direction along = direction_at(polar.angle[i / polar.size.size()]);
  return {size * along.x, size * along.y};
}

Wrench load_of(const ForceLoads& set, std::size_t i) noexcept {
  const auto [x, y] = force_of(set, i / set.moment.size());
  return {x, y, set.moment[i % set.moment.size()] + (set.at.x * y - set.at.y * x)};
}

Wrench load_of(const DirectionLoads& set, std::size_t i) noexcept {
  const double size = set.size[i % set.size.size()];
  i /= set.size.size();
  const Direction theta = direction_at(set.polar[i % set.polar.size()]);
  const Direction phi = direction_at(set.azimuth[i / set.polar.size()]);
  const double force = size * theta.y;
  return {force * phi.x, force * phi.y, size * set.length * theta.x};
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
