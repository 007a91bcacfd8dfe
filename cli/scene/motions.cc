#include <patchgrip/cli/scene/motions.h>

#include <cmath>
#include <limits>
#include <utility>

namespace patchgrip::cli {
namespace {

using friction::Pole;
using friction::Twist;

std::size_t count(const PoleSet& set) noexcept { return static_cast<std::size_t>(pole_count(set)); }

Pole pole_of(const Grid& set, std::size_t i) noexcept { return {set.x[i % set.x.size()], set.y[i / set.x.size()]}; }

Pole pole_of(const Ray& set, std::size_t i) noexcept {
  const double distance = set.distances[i % set.distances.size()];
  const Direction along = set.directions[i / set.distances.size()];
  return {set.from.x + distance * along.x, set.from.y + distance * along.y};
}

Pole pole_of(const PoleList& set, std::size_t i) noexcept { return set.poles[i]; }

double towards_infinity(double component) noexcept {
  return component == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), component);
}

}  // namespace

std::size_t Directions::size() const noexcept {
  return std::visit([](const auto& all) { return all.size(); }, directions_);
}

Direction Directions::operator[](std::size_t i) const noexcept {
  if (const auto* const angles = std::get_if<Sequence>(&directions_)) return direction_at((*angles)[i]);
  const Direction along = (*std::get_if<std::vector<Direction>>(&directions_))[i];
  const double length = std::hypot(along.x, along.y);
  return {along.x / length, along.y / length};
}

double pole_count(const PoleSet& set) noexcept {
  if (const auto* const grid = std::get_if<Grid>(&set)) {
    return static_cast<double>(grid->x.size()) * static_cast<double>(grid->y.size());
  }
  if (const auto* const ray = std::get_if<Ray>(&set)) {
    return static_cast<double>(ray->directions.size()) * static_cast<double>(ray->distances.size());
  }
  return static_cast<double>(std::get_if<PoleList>(&set)->poles.size());
}

Motions::Motions(Rotations rotations, std::optional<Translations> translations)
    : rotations_(std::move(rotations)), translations_(std::move(translations)), rotation_count_(0) {
  for (const PoleSet& set : rotations_.sets) rotation_count_ += count(set);
  rotation_count_ *= rotations_.spins.size() * rotations_.angular_speeds.size();
}

std::size_t Motions::size() const noexcept {
  return rotation_count_ + (translations_ ? translations_->directions.size() * translations_->speeds.size() : 0);
}

Pole Motions::pole(std::size_t i) const noexcept {
  auto set = rotations_.sets.begin();
  for (;; ++set) {
    const std::size_t poles = count(*set);
    if (i < poles) break;
    i -= poles;
  }
  return std::visit([i](const auto& s) { return pole_of(s, i); }, *set);
}

Motion Motions::operator[](std::size_t i) const noexcept {
  if (i < rotation_count_) {
    const std::size_t speeds = rotations_.angular_speeds.size();
    const double angular_speed = rotations_.angular_speeds[i % speeds];
    i /= speeds;
    const int spin = rotations_.spins[i % rotations_.spins.size()];
    const Pole at = pole(i / rotations_.spins.size());
    return {at, spin, angular_speed, friction::twist_about(at, spin * angular_speed)};
  }
  i -= rotation_count_;
  const double speed = translations_->speeds[i % translations_->speeds.size()];
  const Direction along = translations_->directions[i / translations_->speeds.size()];
  const Twist twist{speed * along.x, speed * along.y, 0};
  return {{towards_infinity(-twist.vy), towards_infinity(twist.vx)}, 0, 0, twist};
}

}  // namespace patchgrip::cli
