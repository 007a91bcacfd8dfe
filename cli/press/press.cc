#include <optional>
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

[[noreturn]] void refuse_adhesion(const PressScene& scene) {
  scene.adhesion->place.refuse("covered between balls, hollows and planes");
}

// What two elastic bodies are to each other, whatever the load.
struct Touching {
  double modulus;                // E* [Pa]
  std::optional<double> radius;  // [m], of two balls, hollows or planes
  const Shape* stamp;
};

Touching touching(const BodyPair& pair) {
  if (pair.first.relaxing || pair.second.relaxing) {
    throw std::invalid_argument("a viscoelastic body needs its load over time, [load]");
  }
  return {contact::contact_modulus(pair.first.material, pair.second.material), relative_radius_of(pair),
          stamp_of(pair)};
}

Pressed press_pair(const BodyPair& pair, const PressScene& scene) {
  const auto [modulus, radius, stamp] = at(scene.subject_place, [&] { return touching(pair); });
  if (scene.adhesion) {
    if (!radius) refuse_adhesion(scene);
    return press_adhesive(*radius, modulus, scene);
  }
  if (has_mesh(pair)) return press_mesh(pair, modulus, scene);
  if (height_map_of(pair) != nullptr) return press_height_map(pair, modulus, scene);
  if (radius) return press_balls(pair, scene);
  if (stamp != nullptr) return press_stamp(pair, scene);
  const auto first = curved_surface(pair.first.shape);
  const auto second = curved_surface(pair.second.shape);
  if (first && second) return press_ellipse(*first, *second, modulus, scene);
  scene.subject_place.refuse("these two shapes cannot be pressed on each other");
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
  if (scene.adhesion && !std::holds_alternative<BodyPair>(scene.subject)) refuse_adhesion(scene);
  return at(load_place(scene), [&] { return std::visit(PressSubject{scene}, scene.subject); });
}

}  // namespace patchgrip::cli
