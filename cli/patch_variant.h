// Any of the patches that a scene can name, and one way to call a function on the patch that it is.
#pragma once

#include <utility>
#include <variant>

#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
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
                                  friction::PowerDisc, friction::XydasKaoDisc, friction::Rectangle, friction::Polygon,
                                  friction::SeedHertzDisc, friction::StampDisc, friction::Several, friction::AnyPatch>;

// f(patch) with the patch moved and turned so that its own axes lie at `frame`.
template <class F>
decltype(auto) visit_patch(const PatchVariant& patch, const friction::PlanarFrame& frame, F&& f) {
  return std::visit(
      [&](const auto& own) -> decltype(auto) {
        if (frame.x == 0 && frame.y == 0 && frame.angle == 0) return f(own);
        return f(friction::Placed{own, frame});
      },
      patch);
}

inline friction::AnyPatch placed(const friction::AnyPatch& patch, const friction::PlanarFrame& frame) {
  return friction::Placed{patch, frame};
}

}  // namespace patchgrip::cli
