#include <patchgrip/verification/claims/pad.h>

#include <cmath>
#include <numbers>
#include <utility>

#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/uniform_disc.h>

namespace patchgrip::verification {
namespace {

constexpr double height = 0.3, mu = 0.5;

template <class Patch>
std::vector<Quantity> sliding(const Patch& patch, double pole, double size) {
  const auto wrench = patch.gradient(friction::twist_about({pole, 0}, 1));
  const std::string reason = "0.2 % of mu F and of the moment mu F a: p and its arm by elements";
  return {{"force / mu F", "1", {wrench.fy}, 1, 2e-3, reason}, {"moment / mu F", "m", {wrench.m}, size, 2e-3, reason}};
}

}  // namespace

Pad pad(PadShape shape, double pole) {
  constexpr double pi = std::numbers::pi;
  switch (shape) {
    case PadShape::disc:
      return {shape, 1, 1, height, mu, pi, "1", pole, sliding(friction::UniformDisc::of_radius(1), pole, 1)};
    case PadShape::ellipse:
      return {shape,
              1.5,
              1,
              height,
              mu,
              1.5 * pi,
              "1.5*sqrt(pos_part(1-sqr(X(1)/1.5)-sqr(X(2))))",
              pole,
              sliding(friction::HertzEllipse::of_semi_axes(1.5, 1), pole, 1)};
    default:
      return {shape, 1.5, 1, height, mu, 6, "1", pole, sliding(friction::Rectangle::of_sides(3, 2), pole, 1)};
  }
}

}  // namespace patchgrip::verification
