#include <patchgrip/cli/press/press_adhesion.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <patchgrip/cli/press/loaded.h>
#include <patchgrip/contact/adhesion/dmt.h>
#include <patchgrip/contact/adhesion/jkr.h>
#include <patchgrip/contact/adhesion/maugis_dugdale.h>
#include <patchgrip/contact/adhesion/tabor.h>
#include <patchgrip/contact/paraboloid.h>

namespace patchgrip::cli {
namespace {

using contact::AdhesiveSphere;
using contact::AdhesiveState;
using contact::Dmt;
using contact::Jkr;
using contact::MaugisDugdale;
using contact::MaugisState;

constexpr double unit = 0x1p-53;
constexpr double jkr_from = 5;     // lambda above which JKR holds (tabor.h)
constexpr double dmt_up_to = 0.1;  // lambda below which DMT holds

// Errors of force and approach are relative to the larger of their two terms.
struct Terms {
  double force;
  double approach;
};

Terms terms_of(const AdhesiveSphere& sphere, const AdhesiveState& s) {
  const double a = s.contact_radius;
  return {4. / 3. * sphere.contact_modulus * a * a * a / sphere.relative_radius + std::fabs(s.normal_force),
          a * a / sphere.relative_radius + std::fabs(s.approach)};
}

std::vector<Result> results_of(const AdhesiveSphere& sphere, const AdhesiveState& s, double units) {
  const Terms terms = terms_of(sphere, s);
  return {{"contact_radius", s.contact_radius, units * unit * s.contact_radius, "m"},
          {"normal_force", s.normal_force, units * unit * terms.force, "N"},
          {"approach", s.approach, units * unit * terms.approach, "m"}};
}

void add_state(std::vector<Result>& results, const std::string& name, const AdhesiveSphere& sphere,
               const AdhesiveState& s, double units) {
  const Terms terms = terms_of(sphere, s);
  results.push_back({name + "_force", s.normal_force, units * unit * terms.force, "N"});
  results.push_back({name + "_radius", s.contact_radius, units * unit * s.contact_radius, "m"});
  results.push_back({name + "_approach", s.approach, units * unit * terms.approach, "m"});
}

AdhesiveState state_of(const Jkr& jkr, const StaticLoad& load) {
  if (load.kind == LoadKind::normal_force) return jkr.under_force(load.value);
  return load.kind == LoadKind::approach ? jkr.at_approach(load.value) : jkr.at_radius(load.value);
}

LawAnswer jkr_answer(const AdhesiveSphere& sphere, const StaticLoad& load) {
  const Jkr jkr(sphere);
  constexpr double units = 8;
  const AdhesiveState s = state_of(jkr, load);
  LawAnswer answer{"jkr", results_of(sphere, s, units),
                   "Johnson, Kendall, Roberts: attraction of short range at the rim (large Tabor parameter)"};
  if (std::isfinite(s.stiffness)) {
    answer.results.push_back({"stiffness", s.stiffness, 64 * unit * std::fabs(s.stiffness), "N/m"});
  }
  add_state(answer.results, "pull_off", sphere, jkr.load_pull_off(), units);
  add_state(answer.results, "pull_off_held", sphere, jkr.displacement_pull_off(), units);
  add_state(answer.results, "jump_in", sphere, jkr.jump_in(), units);
  add_state(answer.results, "no_load", sphere, jkr.no_load(), units);
  return answer;
}

AdhesiveState state_of(const Dmt& dmt, const StaticLoad& load) {
  if (load.kind == LoadKind::normal_force) return dmt.under_force(load.value);
  if (load.kind == LoadKind::approach) return dmt.at_approach(load.value);
  return dmt.at_approach(load.value * load.value / dmt.sphere.relative_radius);
}

LawAnswer dmt_answer(const AdhesiveSphere& sphere, const StaticLoad& load) {
  const Dmt dmt(sphere);
  constexpr double units = 8;
  const auto s = state_of(dmt, load);
  LawAnswer answer{
      "dmt", results_of(sphere, s, units),
      "Derjaguin, Muller, Toporov: attraction of long range outside a Hertz contact (small Tabor parameter)"};
  answer.results.push_back({"stiffness", s.stiffness, units * unit * s.stiffness, "N/m"});
  add_state(answer.results, "pull_off", sphere, dmt.pull_off(), units);
  add_state(answer.results, "no_load", sphere, dmt.no_load(), units);
  return answer;
}

LawAnswer hertz_answer(const AdhesiveSphere& sphere, const StaticLoad& load) {
  const auto profile = contact::Paraboloid::of_radius(sphere.relative_radius);
  const auto c = loaded(profile, load, sphere.contact_modulus);
  return {"hertz",
          {{"contact_radius", c.radius(), c.radius_error(), "m"},
           {"normal_force", c.force(), c.force_error(), "N"},
           {"approach", c.approach(), c.approach_error(), "m"},
           {"stiffness", c.stiffness(), c.stiffness_error(), "N/m"}},
          "without adhesion"};
}

MaugisState state_of(const MaugisDugdale& maugis, const StaticLoad& load) {
  if (load.kind == LoadKind::normal_force) return maugis.under_force(load.value);
  if (load.kind == LoadKind::contact_radius) return maugis.at_radius(load.value);
  throw std::invalid_argument("approach: with a stress of adhesion give normal_force or contact_radius");
}

LawAnswer maugis_answer(const MaugisDugdale& maugis, const MaugisState& s) {
  const AdhesiveSphere& sphere = maugis.sphere();
  // What an error of the radius does to force and approach is below their larger terms times three.
  const double relative = 3 * s.relative_radius_error + 4 * unit;
  const Terms terms = terms_of(sphere, {s.normal_force, s.approach, s.contact_radius, 0});
  const MaugisState off = maugis.pull_off();
  const double lambda = maugis.maugis_parameter();
  return {"maugis_dugdale",
          {{"contact_radius", s.contact_radius, relative * s.contact_radius, "m"},
           {"outer_radius", s.outer_radius, relative * s.outer_radius, "m"},
           {"normal_force", s.normal_force, relative * terms.force, "N"},
           {"approach", s.approach, relative * terms.approach, "m"},
           {"maugis_parameter", lambda, 2 * unit * lambda, "1"},
           {"pull_off_force", off.normal_force, 4 * unit * std::fabs(off.normal_force), "N"},
           {"pull_off_radius", off.contact_radius, 4 * unit * off.contact_radius, "m"}},
          "Maugis, Dugdale: a constant attraction in a ring around the contact, between JKR and DMT"};
}

// A law beside the main one; where it has no contact under this load, a warning.
template <class F>
void try_beside(Pressed& pressed, std::string_view law, F&& answer) {
  try {
    pressed.answer.beside.push_back(answer());
  } catch (const std::invalid_argument& error) {
    pressed.answer.warnings.push_back(fmt::format("{}: {}", law, error.what()));
  }
}

// JKR is Hertz and a flat punch that is pulled.
std::function<SurfacePoint(double, double)> jkr_surface(const AdhesiveSphere& sphere, const AdhesiveState& state) {
  return [=](double x, double y) -> SurfacePoint {
    const double r = std::hypot(x, y);
    const double a = state.contact_radius;
    const auto paraboloid = contact::Paraboloid::of_radius(sphere.relative_radius);
    const double height = paraboloid.height(r);
    const double deeper = a * a / sphere.relative_radius;  // of the Hertz contact of this radius
    const double size = 32 * unit * (deeper + height + std::fabs(state.approach));
    if (r < a) {
      const double p = Jkr(sphere).pressure(a, r);
      const double hertz = sphere.contact_modulus * paraboloid.pressure(r, a);
      return {{p, 32 * unit * (hertz + std::fabs(p)) * a / (a - r)}, {state.approach - height, size}, {0, 0}};
    }
    const double pulled = deeper - state.approach;
    const double u = paraboloid.displacement(r, a) - 2 * pulled * std::asin(a / r) / std::numbers::pi;
    return {{0, 0}, {u, size}, {std::max(height - state.approach + u, 0.), 2 * size}};
  };
}

Pressed press_jkr(const AdhesiveSphere& sphere, const StaticLoad& load) {
  const AdhesiveState state = state_of(Jkr(sphere), load);
  Pressed result{{jkr_answer(sphere, load), {}, {}}, state.contact_radius, jkr_surface(sphere, state)};
  result.answer.warnings.emplace_back(
      "how far the attraction reaches is not given ([adhesion] stress or equilibrium_distance): JKR is taken, which "
      "holds "
      "for a short reach");
  return result;
}

Pressed press_maugis(const AdhesiveSphere& sphere, double stress, const StaticLoad& load) {
  const auto maugis = MaugisDugdale::of(sphere, stress);
  const MaugisState state = state_of(maugis, load);
  Pressed result{{maugis_answer(maugis, state), {}, {}}, state.contact_radius};
  try_beside(result, "jkr", [&] { return jkr_answer(sphere, load); });
  return result;
}

}  // namespace

Pressed press_adhesive(double relative_radius, double contact_modulus, const PressScene& scene) {
  const auto& load = std::get<StaticLoad>(scene.load);
  const auto sphere = AdhesiveSphere::of(relative_radius, contact_modulus, scene.adhesion->work);
  Pressed result =
      scene.adhesion->stress ? press_maugis(sphere, *scene.adhesion->stress, load) : press_jkr(sphere, load);
  try_beside(result, "dmt", [&] { return dmt_answer(sphere, load); });
  try_beside(result, "hertz", [&] { return hertz_answer(sphere, load); });
  if (result.extent > 0.1 * relative_radius) {
    result.answer.warnings.push_back(fmt::format(
        "a/R = {:.3g} is not small: slopes of that order are outside the theory", result.extent / relative_radius));
  }
  return result;
}

}  // namespace patchgrip::cli
