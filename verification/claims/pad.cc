#include <patchgrip/verification/claims/pad.h>

#include <cmath>
#include <numbers>
#include <utility>

#include <patchgrip/dynamics/return_mapping.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/uniform_disc.h>

namespace patchgrip::verification {
namespace {

constexpr double height = 0.3, mu = 0.5;
const std::vector<double> turns{0.1, 0.3, 0.6, 0.8, 1, 1.35, 2, 3, 10, 100};

struct Face {
  double area, polar;  // [m^2], [m^4]
};

// Of the wrench of bristles in the mean, per unit of mu F = mu A p.
template <class P>
std::vector<friction::Wrench> breaking_away(const P& patch, double pole, const Face& face) {
  constexpr int steps = 200;  // from turn to turn
  const dynamics::ReturnMapping mapping(patch);
  // Per mu F of a turn of mu p h / G, where p A = F.
  const dynamics::Vector3 stiffness(1, 1, face.polar / face.area);
  const auto metric = dynamics::BristleMetric(stiffness.asDiagonal());
  std::vector<friction::Wrench> all;
  friction::Wrench s{};
  double at = 0;
  for (const double turn : turns) {
    const double step = (turn - at) / steps;
    const friction::Twist v = friction::twist_about({pole, 0}, step);
    for (int k = 0; k < steps; ++k) {
      const friction::Wrench trial{s.fx + stiffness[0] * v.vx, s.fy + stiffness[1] * v.vy, s.m + stiffness[2] * v.w};
      s = mapping(trial, 1, metric).wrench.value;
    }
    at = turn;
    all.push_back(s);
  }
  return all;
}

template <class P>
std::vector<Quantity> carried(const P& patch, double pole, double size, const Face& face) {
  const auto wrench = patch.gradient(friction::twist_about({pole, 0}, 1));
  const std::string reason = "0.2 % of mu F and of the moment mu F a: p and its arm by elements";
  const std::string mean =
      "20 % of mu F: bristles in the mean know no partial slip; 15 % was found where they break away";
  std::vector<double> forces, moments;
  for (const friction::Wrench& s : breaking_away(patch, pole, face)) {
    forces.push_back(s.fy);
    moments.push_back(s.m);
  }
  return {{"force / mu F", "1", {wrench.fy}, 1, 2e-3, reason},
          {"moment / mu F", "m", {wrench.m}, size, 2e-3, reason},
          {"force / mu F, breaking away", "1", forces, 1, 0.2, mean},
          {"moment / mu F, breaking away", "m", moments, size, 0.2, mean}};
}

}  // namespace

Pad pad(PadShape shape, double pole) {
  constexpr double pi = std::numbers::pi;
  switch (shape) {
    case PadShape::disc:
      return {shape, 1,   1,    height, mu,
              pi,    "1", pole, turns,  carried(friction::UniformDisc::of_radius(1), pole, 1, {pi, pi / 2})};
    case PadShape::ellipse:
      return {
          shape,
          1.5,
          1,
          height,
          mu,
          1.5 * pi,
          "1.5*sqrt(pos_part(1-sqr(X(1)/1.5)-sqr(X(2))))",
          pole,
          turns,
          carried(friction::HertzEllipse::of_semi_axes(1.5, 1), pole, 1, {1.5 * pi, 1.5 * pi * (1.5 * 1.5 + 1) / 4})};
    default:
      return {shape, 1.5, 1,    height, mu,
              6,     "1", pole, turns,  carried(friction::Rectangle::of_sides(3, 2), pole, 1, {6, 6 * (9. + 4) / 12})};
  }
}

}  // namespace patchgrip::verification
