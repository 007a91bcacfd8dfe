#include <patchgrip/cli/scene/profile_of.h>

#include <limits>
#include <type_traits>

#include <patchgrip/contact/hertz_circle.h>

namespace patchgrip::cli {
namespace {

bool is_stamp(const Shape& shape) {
  return std::holds_alternative<SphereStamp>(shape) || std::holds_alternative<ConeStamp>(shape) ||
         std::holds_alternative<PowerStamp>(shape) || std::holds_alternative<FlatPunchStamp>(shape) ||
         std::holds_alternative<FlatEndParaboloidStamp>(shape) || std::holds_alternative<FlatEndConeStamp>(shape) ||
         std::holds_alternative<PointStamp>(shape);
}

std::optional<double> radius_of(const Shape& shape) {
  if (std::holds_alternative<Plane>(shape)) return std::numeric_limits<double>::infinity();
  if (const auto* ball = std::get_if<Ball>(&shape)) return ball->radius;
  return std::nullopt;
}

}  // namespace

std::optional<double> relative_radius_of(const BodyPair& pair) {
  const auto first = radius_of(pair.first.shape);
  const auto second = radius_of(pair.second.shape);
  if (!first || !second) return std::nullopt;
  return contact::relative_radius(*first, *second);
}

const Shape* stamp_of(const BodyPair& pair) {
  const Shape& first = pair.first.shape;
  const Shape& second = pair.second.shape;
  if (!is_stamp(first) && !is_stamp(second)) return nullptr;
  if (std::holds_alternative<Plane>(second)) return &first;
  if (std::holds_alternative<Plane>(first)) return &second;
  throw std::invalid_argument("a stamp presses on a plane");
}

}  // namespace patchgrip::cli
