// A patch of a scene by its kind and size: 'patch' and the keys that go with it, in [contact] or in a part of it.
#pragma once

#include <optional>
#include <string>

#include <patchgrip/cli/patch_variant.h>
#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/friction/placed.h>

namespace patchgrip::cli {

// Of the pressure of Xydas and Kao.
constexpr Quantity alpha_range{"the exponent alpha of (1 - (r/a)^alpha)^(1/alpha)", 0.5, 50};

struct DescribedPatch {
  PatchVariant patch;
  std::string words;
};

// All throw SceneError.
DescribedPatch read_patch(const TomlReader& table);  // without its place and its force

// A Hertz disc, exact or by the polynomials, as 'model' says.
DescribedPatch hertz_disc(const TomlReader& table, double radius);

// 'centre' and 'angle' of a patch, of parts or of what two bodies make.
friction::PlanarFrame read_frame(const TomlReader& table);
std::string in_words(const friction::PlanarFrame& frame);  // empty at the origin

}  // namespace patchgrip::cli
