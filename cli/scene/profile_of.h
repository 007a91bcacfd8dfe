// The profile of revolution that two bodies make together, as the library has it.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <patchgrip/cli/scene/body_reader.h>
#include <patchgrip/contact/cone.h>
#include <patchgrip/contact/flat_end_cone.h>
#include <patchgrip/contact/flat_end_paraboloid.h>
#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/point_profile.h>
#include <patchgrip/contact/power_profile.h>
#include <patchgrip/contact/power_sum.h>
#include <patchgrip/contact/sphere.h>

namespace patchgrip::cli {

// Relative radius of the pair [m] where both are balls, hollows or planes.
std::optional<double> relative_radius_of(const BodyPair& pair);

// The stamp of revolution that one of them is, on the plane that the other one is; nothing where there is no stamp.
// Throws std::invalid_argument for a stamp on anything else.
const Shape* stamp_of(const BodyPair& pair);

struct ProfileName {
  std::string law;
  std::string remark;
};

// f(profile, ProfileName) for everything that has a profile; a flat punch has none. Throws std::invalid_argument, and
// SceneError at the body of which the library makes no profile.
template <class F>
auto visit_profile(const BodyPair& pair, F&& f) {
  if (const auto radius = relative_radius_of(pair)) {
    return f(contact::Paraboloid::of_radius(*radius),
             ProfileName{"hertz", "two paraboloids, circle of contact small against the radii"});
  }
  const Shape* stamp = stamp_of(pair);
  if (stamp == nullptr) throw std::invalid_argument("the two do not make a round contact");
  const Place& place = stamp == &pair.first.shape ? pair.first.place : pair.second.place;
  const auto visit = [&](auto make, const ProfileName& name) { return f(at(place, make), name); };
  if (const auto* s = std::get_if<SphereStamp>(stamp)) {
    if (s->terms == 0) {
      return visit([&] { return contact::Sphere::of_radius(s->radius); },
                   {"sphere", "a sphere on a half-space, its height taken exactly"});
    }
    return visit([&] { return contact::PowerSum::sphere_series(s->radius, s->terms); },
                 {"sphere_series", "the first terms of the sphere's series in r^2 (Keppler 4.14, corrected)"});
  }
  if (const auto* s = std::get_if<ConeStamp>(stamp)) {
    return visit([&] { return contact::Cone::of_slope(s->slope); }, {"cone", "a cone"});
  }
  if (const auto* s = std::get_if<PowerStamp>(stamp)) {
    return visit([&] { return contact::PowerProfile::of_coefficient(s->coefficient, s->exponent); },
                 {"power", "a stamp whose height is a power of the radius"});
  }
  if (const auto* s = std::get_if<FlatEndParaboloidStamp>(stamp)) {
    return visit([&] { return contact::FlatEndParaboloid::of(s->end_radius, s->radius); },
                 {"flat_end_paraboloid", "a flat end that goes on as a paraboloid"});
  }
  if (const auto* s = std::get_if<FlatEndConeStamp>(stamp)) {
    return visit([&] { return contact::FlatEndCone::of(s->end_radius, s->slope); },
                 {"flat_end_cone", "a flat end that goes on as a cone"});
  }
  if (const auto* s = std::get_if<PointStamp>(stamp)) {
    return visit([&] { return contact::PointProfile::through(s->points); },
                 {"points", "a profile given by points, straight between them"});
  }
  throw std::invalid_argument("a flat punch has no profile");
}

}  // namespace patchgrip::cli
