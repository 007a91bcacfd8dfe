#include <stdexcept>

#include <patchgrip/cli/press/press_adhesion.h>
#include <patchgrip/cli/press/press_ellipse.h>
#include <patchgrip/cli/press/press_given.h>
#include <patchgrip/cli/press/press_height_map.h>
#include <patchgrip/cli/press/press_mesh.h>
#include <patchgrip/cli/press/press_round.h>
#include <patchgrip/cli/press/pressed.h>
#include <patchgrip/cli/scene/profile_of.h>
#include <patchgrip/contact/material.h>

namespace patchgrip::cli {
namespace {

Pressed press_pair(const BodyPair& pair, const PressScene& scene) {
  if (pair.first.relaxing || pair.second.relaxing) {
    throw std::invalid_argument("bodies: a viscoelastic body needs its load over time, [load]");
  }
  const double modulus = contact::contact_modulus(pair.first.material, pair.second.material);
  const auto radius = relative_radius_of(pair);
  if (scene.adhesion) {
    if (!radius) throw std::invalid_argument("adhesion: covered between balls, hollows and planes");
    return press_adhesive(*radius, modulus, scene);
  }
  if (has_mesh(pair)) return press_mesh(pair, modulus, scene);
  if (height_map_of(pair) != nullptr) return press_height_map(pair, modulus, scene);
  if (radius) return press_balls(pair, scene);
  if (stamp_of(pair) != nullptr) return press_stamp(pair, scene);
  const auto first = curved_surface(pair.first.shape);
  const auto second = curved_surface(pair.second.shape);
  if (first && second) return press_ellipse(*first, *second, modulus, scene);
  throw std::invalid_argument("bodies: these two shapes cannot be pressed on each other");
}

struct PressSubject {
  const PressScene& scene;

  Pressed operator()(const BodyPair& pair) const { return press_pair(pair, scene); }
  Pressed operator()(const GivenPressure& given) const { return press_given_pressure(given, scene); }
  template <class Fingertip>
  Pressed operator()(const Fingertip& tip) const {
    return press_fingertip(tip, scene);
  }
};

}  // namespace

Pressed press(const PressScene& scene) {
  if (scene.adhesion && !std::holds_alternative<BodyPair>(scene.subject)) {
    throw std::invalid_argument("adhesion: covered between balls, hollows and planes");
  }
  return std::visit(PressSubject{scene}, scene.subject);
}

}  // namespace patchgrip::cli
