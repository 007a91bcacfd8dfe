#include <stdexcept>

#include <patchgrip/cli/press/press_ellipse.h>
#include <patchgrip/cli/press/press_round.h>
#include <patchgrip/cli/press/pressed.h>
#include <patchgrip/cli/press/profile_of.h>
#include <patchgrip/contact/material.h>

namespace patchgrip::cli {
namespace {

Pressed press_pair(const BodyPair& pair, const PressScene& scene) {
  if (stamp_of(pair) != nullptr) return press_stamp(pair, scene);
  if (relative_radius_of(pair)) return press_balls(pair, scene);
  const auto first = curved_surface(pair.first.shape);
  const auto second = curved_surface(pair.second.shape);
  if (first && second) {
    return press_ellipse(*first, *second, contact::contact_modulus(pair.first.material, pair.second.material), scene);
  }
  throw std::invalid_argument("bodies: these two shapes cannot be pressed on each other");
}

}  // namespace

Pressed press(const PressScene& scene) {
  if (const auto* pair = std::get_if<BodyPair>(&scene.subject)) return press_pair(*pair, scene);
  throw std::invalid_argument("contact: not covered");
}

}  // namespace patchgrip::cli
