#include <patchgrip/verification/cases/creep.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <patchgrip/verification/fe/half_space.h>

namespace patchgrip::verification {
namespace {

Model fading_half_space(const CreepingPress& press, const Setting& setting) {
  constexpr double contact_reach = 1.5;
  Model model = bare_half_space(setting, contact_reach, press.glassy, 1);
  set_far_force(model, setting, press.glassy, 0);
  model.hold("u", region::far, "far_u");
  model.remember("before", "u");
  model.history("h", {3, 3});
  model.known("stays", 1 - press.fading_share);
  model.known("fades", press.fading_share);
  model.known("left", 1.);
  model.known("mean_left", 1.);
  return model;
}

const std::string faded =
    "(left*h+mean_left*(" + strain_of_revolution("u") + "-" + strain_of_revolution("before") + "))";

}  // namespace

Solved solve_creep(const CreepingPress& press, const Setting& setting) {
  Model model = fading_half_space(press, setting);
  const std::string strain = fmt::format("(stays*{}+fades*{})", strain_of_revolution("u"), faded);
  const std::string volume = press.bulk_fades ? strain : strain_of_revolution("u");
  model.nonlinear(fmt::format("(((la+2*G/3)*Trace({})*Id(3)+2*G*Deviator({})):{})*X(1)", volume, strain,
                              strain_of_revolution("Test_u")));
  press_without_friction(model, fmt::format("sqr(X(1))/{}", 2 * press.sphere_radius), 0,
                         0.5 * press.quantities[0].library.front());

  Solved solved;
  std::vector<double> approaches;
  double at = 0;
  const auto step_to = [&](double t) {
    const double age = (t - at) / press.fading_time;
    model.known("left", std::exp(-age));
    model.known("mean_left", age > 0 ? -std::expm1(-age) / age : 1);
    const FarField far = far_field(press, t);
    set_far_force(model, setting, far.material, far.force);
    model.load("delta", -press.force(t));
    solved.iterations += model.solve(1e-8 * far_field(press, press.end / 2).force, fmt::format("creep at {:g} s", t));
    model.record("h", faded);
    model.remember("before", "u");
    at = t;
  };
  if (press.force(0) > 0) step_to(0);
  const int steps = static_cast<int>(std::lround(setting.elements / 3));
  for (const double time : press.times) {
    const double from = at;
    for (int k = 1; k <= steps; ++k) step_to(std::lerp(from, time, static_cast<double>(k) / steps));
    approaches.push_back(model.number("delta"));
  }
  solved.unknowns = model.unknowns();
  solved.values = {approaches, approaches};
  solved.curves.push_back({"approach",
                           "t [s]",
                           "approach [m]",
                           {{"FE", press.times, approaches},
                            {"library", press.times, press.quantities[0].library, true},
                            {"seed 4.72", press.times, press.quantities[1].library, true}}});
  return solved;
}

}  // namespace patchgrip::verification
