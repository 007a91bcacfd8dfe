// The scene is well and good, but its question was not answered: something does not converge.
//
//     rough.toml:5: contact.normal_force = 2: press: residual 3e-4 after 200 iterations
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include <patchgrip/cli/scene/place.h>
#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {

struct Unanswered : std::runtime_error {
  Unanswered(const Place& place, std::string_view why)
      : std::runtime_error(located(place.file, place.line, fmt::format("{}: {}", place.words, why))) {}
};

}  // namespace patchgrip::cli
