// Kinds about materials.
#include <array>

#include <patchgrip/cli/accuracy/contact_kinds.h>
#include <patchgrip/contact/hertz_circle.h>

namespace patchgrip::cli {
namespace {

std::vector<Output> hertz_sphere_inverse(const EntryInputs& in) {
  const auto circle = contact::HertzCircle::under_force(in["F_N"], in["R"], in["E_star"]);
  return {{"a_K", circle.radius},
          {"delta", circle.approach},
          {"p0", circle.peak_pressure},
          {"stiffness", 2 * in["E_star"] * circle.radius}};
}

constexpr std::array<ContactKind, 1> kinds{{{"hertz_sphere_inverse", hertz_sphere_inverse}}};

}  // namespace

std::span<const ContactKind> material_kinds() { return kinds; }

}  // namespace patchgrip::cli
