// The patch that two bodies make when they are pressed on each other, for friction to act in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchgrip/cli/patch_variant.h>
#include <patchgrip/cli/scene/body_reader.h>
#include <patchgrip/cli/scene/toml_reader.h>

namespace patchgrip::cli {

constexpr double hertz_growth = 1. / 3;  // a ~ F_N^(1/3) (contact/hertz_circle.h, contact/hertz_ellipse.h)

struct RubbedBodies {
  PatchVariant patch;
  double angle = 0;         // of its axes against the contact frame [rad]
  double radius_error = 0;  // relative, of a disc
  double shape_error = 0;   // of any patch: how far its points may be off, relative to their distance from the centre
  double extent = 0;        // that distance at most [m]
  std::optional<friction::AnyPatch>
      coarse{};                    // by half as many cells a side: how far the numerical pressure may be off
  std::optional<double> growth{};  // e: with its force the patch grows as F_N^e, alike; none: by another law
  std::vector<std::string> notes{};
  std::vector<std::string> warnings{};
};

// `contact` for its 'model'. Library errors (std::invalid_argument) pass; Unanswered where a pressure does not
// converge.
RubbedBodies rub(const BodyPair& pair, double normal_force, const TomlReader& contact);

}  // namespace patchgrip::cli
