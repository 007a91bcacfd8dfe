// The motions that a scene asks for: rotations about poles, and pure translations (poles at infinity).
//
// Poles come in sets, each a product of sequences that is never stored:
//
//     grid          every x with every y; x runs fastest
//     ray           from a point, at every distance in every direction; the distance runs fastest
//     list          given one by one
//     translation   every direction at every speed
//
// A pole is passed once for every spin and angular speed; the speed runs fastest, then the spin, then the pole.
//
// Units    poles, distances [m]; angular speeds [rad/s], speeds [m/s]; both > 0.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <patchgrip/cli/scene/direction.h>
#include <patchgrip/cli/scene/sequence.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::cli {

// Unit vectors from angles [rad] against the x-axis (direction.h), or along given vectors.
class Directions {
 public:
  explicit Directions(Sequence angles) : directions_(std::move(angles)) {}
  explicit Directions(std::vector<Direction> along) : directions_(std::move(along)) {}

  std::size_t size() const noexcept;
  Direction operator[](std::size_t i) const noexcept;

 private:
  std::variant<Sequence, std::vector<Direction>> directions_;
};

struct Grid {
  Sequence x;
  Sequence y;
};

struct Ray {
  friction::Pole from;
  Directions directions;
  Sequence distances;
};

struct PoleList {
  std::vector<friction::Pole> poles;
};

using PoleSet = std::variant<Grid, Ray, PoleList>;

struct Motion {
  friction::Pole pole;    // for a translation +-infinity or 0, the limit for w -> 0 from above: signs of its direction
  int spin;               // +1, -1; 0 for a translation
  double angular_speed;   // |w| [rad/s]; 0 for a translation
  friction::Twist twist;  // exact for a translation; for a rotation vx and vy are rounded unless |w| = 1
};

// Number of poles in a set; a double, as the product may be beyond every integer.
double pole_count(const PoleSet& set) noexcept;

class Motions {
 public:
  struct Rotations {
    std::vector<PoleSet> sets;
    std::vector<int> spins;
    Sequence angular_speeds;
  };
  struct Translations {
    Directions directions;
    Sequence speeds;
  };

  Motions(Rotations rotations, std::optional<Translations> translations);

  std::size_t size() const noexcept;
  Motion operator[](std::size_t i) const noexcept;

 private:
  friction::Pole pole(std::size_t i) const noexcept;

  Rotations rotations_;
  std::optional<Translations> translations_;
  std::size_t rotation_count_;
};

}  // namespace patchgrip::cli
