// Viscoelastic material of a body in a scene: one of the standard models, or a Prony series of relaxation or of creep.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/contact/creep/contact_creep.h>

namespace patchgrip::cli {

struct DescribedRelaxation {
  contact::ViscoelasticMaterial material;
  std::string words;
};

inline constexpr std::array<std::string_view, 5> relaxation_keys{"poynting_thomson", "kelvin_voigt", "maxwell",
                                                                 "relaxation", "creep"};

// Nothing where the body has none of these keys; all need 'poisson_ratio' beside them. Throws SceneError.
std::optional<DescribedRelaxation> read_relaxation(const TomlReader& body);

}  // namespace patchgrip::cli
