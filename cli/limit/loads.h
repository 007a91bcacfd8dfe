// The loads that a scene asks about: wrenches on body A in the contact plane, that friction is to hold.
//
// Loads come in sets, each a product of sequences that is never stored:
//
//     force        (Fx, Fy), or every size in every direction, at a point, with every moment about the origin
//     direction    size (sin theta cos phi, sin theta sin phi, length cos theta)                          (seed 4.51)
//
// The moment runs fastest, then the size, then the angle (theta, then phi).
//
// Units    forces and sizes [N], moments [N m], points and lengths [m], angles [rad].
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include <patchgrip/cli/scene/place.h>
#include <patchgrip/cli/scene/sequence.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::cli {

struct ForceLoads {
  struct Components {
    double x, y;  // [N]
  };
  struct Polar {
    Sequence size;   // [N]
    Sequence angle;  // [rad] against the x-axis
  };

  std::variant<Components, Polar> force;
  friction::Pole at;  // where the force acts [m]
  Sequence moment;    // beside it, about the origin [N m]
};

struct DirectionLoads {
  Sequence azimuth;  // phi [rad]
  Sequence polar;    // theta [rad], from the axis of moments
  Sequence size;     // [N]
  double length;     // [m]
};

using LoadSet = std::variant<ForceLoads, DirectionLoads>;

// Number of loads in a set; a double, as the product may be beyond every integer.
double load_count(const LoadSet& set) noexcept;

// A set and where the scene asks for it.
struct LoadTable {
  LoadSet set;
  Place place;
};

class Loads {
 public:
  explicit Loads(std::vector<LoadTable> tables);

  std::size_t size() const noexcept { return size_; }
  friction::Wrench operator[](std::size_t i) const noexcept;
  const Place& place(std::size_t i) const noexcept;

 private:
  struct Entry {
    const LoadTable& table;
    std::size_t index;  // within it
  };
  Entry entry(std::size_t i) const noexcept;  // i < size()

  std::vector<LoadTable> tables_;
  std::size_t size_;
};

}  // namespace patchgrip::cli
