// Kinds about the half-space.
#include <array>

#include <patchgrip/cli/accuracy/contact_kinds.h>
#include <patchgrip/contact/half_space/love_kernel.h>

namespace patchgrip::cli {
namespace {

std::vector<Output> love_rectangle(const EntryInputs& in) {
  return {{"u_z_at_xy", contact::love_displacement(in["p"], in["E_star"], in["hx"], in["hy"], in["x"], in["y"])}};
}

constexpr std::array<ContactKind, 1> kinds{{{"love_rectangle", love_rectangle}}};

}  // namespace

std::span<const ContactKind> half_space_kinds() { return kinds; }

}  // namespace patchgrip::cli
