// Any of the patches that a scene can name, and one way to call a function on the patch that it is.
#pragma once

#include <utility>
#include <variant>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/seed_hertz_disc.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/stamp_disc.h>
#include <patchgrip/friction/twist.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>

namespace patchgrip::cli {

using PatchVariant = std::variant<friction::HertzDisc, friction::FlatPunchDisc, friction::UniformDisc, friction::Ring,
                                  friction::PowerDisc, friction::XydasKaoDisc, friction::HertzEllipse,
                                  friction::Rectangle, friction::Polygon, friction::SeedHertzDisc, friction::StampDisc,
                                  friction::Several>;

// f(patch) with the patch moved so that its own origin lies at `centre`.
template <class F>
decltype(auto) visit_patch(const PatchVariant& patch, const friction::Pole& centre, F&& f) {
  return std::visit(
      [&](const auto& at_origin) -> decltype(auto) {
        if (centre.x == 0 && centre.y == 0) return f(at_origin);
        return f(friction::Placed{at_origin, centre.x, centre.y});
      },
      patch);
}

}  // namespace patchgrip::cli
