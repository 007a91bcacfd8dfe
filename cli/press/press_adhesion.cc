#include <patchgrip/cli/press/press_adhesion.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <patchgrip/cli/press/loaded.h>
#include <patchgrip/cli/press/rounding.h>
#include <patchgrip/contact/adhesion/dmt.h>
#include <patchgrip/contact/adhesion/jkr.h>
#include <patchgrip/contact/adhesion/maugis_dugdale.h>
#include <patchgrip/contact/paraboloid.h>

namespace patchgrip::cli {
namespace {

using contact::AdhesiveSphere;
using contact::AdhesiveState;
using contact::Dmt;
using contact::Jkr;
using contact::MaugisDugdale;
using contact::MaugisState;

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

// Relative errors; what is given has none.
struct Relative {
  double radius;
  double force;     // of the larger term
  double approach;  // of the larger term
};

Relative without_given(Relative errors, LoadKind given) {
  if (given == LoadKind::contact_radius) errors.radius = 0;
  if (given == LoadKind::normal_force) errors.force = 0;
  if (given == LoadKind::approach) errors.approach = 0;
  return errors;
}

std::vector<Result> results_of(const AdhesiveSphere& sphere, const AdhesiveState& s, const Relative& errors) {
  const Terms terms = terms_of(sphere, s);
  return {{"contact_radius", s.contact_radius, errors.radius * s.contact_radius, "m"},
          {"normal_force", s.normal_force, errors.force * terms.force, "N"},
          {"approach", s.approach, errors.approach * terms.approach, "m"}};
}

// A state that is told by a condition; a zero is that condition.
void add_state(std::vector<Result>& results, const std::string& name, const AdhesiveSphere& sphere,
               const AdhesiveState& s) {
  constexpr double relative = 4 * unit;
  const Terms terms = terms_of(sphere, s);
  results.push_back({name + "_force", s.normal_force, s.normal_force == 0 ? 0 : relative * terms.force, "N"});
  results.push_back({name + "_radius", s.contact_radius, relative * s.contact_radius, "m"});
  results.push_back({name + "_approach", s.approach, s.approach == 0 ? 0 : relative * terms.approach, "m"});
}

void add_bodies(std::vector<Result>& results, const AdhesiveSphere& sphere) {
  results.push_back(within("contact_modulus", sphere.contact_modulus, 1.01, "Pa"));
  results.push_back(within("relative_radius", sphere.relative_radius, 1.01, "m"));
}

// y = sqrt(2 pi w R^2 / (E* a^3)): the tension over the pressure of JKR (jkr.h).
double jkr_tension(const AdhesiveSphere& sphere, double contact_radius) {
  const long double a = contact_radius;
  const long double R = sphere.relative_radius;
  return static_cast<double>(std::sqrt(2 * std::numbers::pi_v<long double> * sphere.work_of_adhesion * R * R /
                                       (sphere.contact_modulus * a * a * a)));
}

// Relative error of the radius of JKR before it is rounded. At a given approach it is that of t = (4/y)^(1/3) - 1,
// whose square is found to 2^-61: large next to the pull-off.
double jkr_unrounded(LoadKind given, double y) {
  constexpr double finest = 0x1p-60;
  if (given == LoadKind::contact_radius) return 0;
  if (given == LoadKind::normal_force) return finest;
  const double t = std::cbrt(4 / y) - 1;
  return t > 0x1p-30 ? finest + finest / t : 0x1p-30;
}

Relative jkr_errors(LoadKind given, double unrounded) {
  // F_1 (4 - 3y) 3/4 and delta_1 (4 - y) / 2 times that of a: at most one and two times the larger terms.
  return without_given({2 * unit + unrounded, 4 * unit + unrounded, 4 * unit + 2 * unrounded}, given);
}

// dF/d(delta) = 2 E* a (4 - 3y)/(4 - y) has a zero and a pole. Nothing where the pole is within the error of y.
std::optional<Result> jkr_stiffness(const AdhesiveSphere& sphere, const AdhesiveState& s, double y, double unrounded) {
  const double moved = y * (1.5 * unrounded + 0x1p-60);
  const double from_pole = std::fabs(4 - y);
  if (!std::isfinite(s.stiffness) || !(moved < from_pole / 2)) return std::nullopt;
  const double by_y = 2 * sphere.contact_modulus * s.contact_radius * 8 * moved / (from_pole * (from_pole - moved));
  return Result{"stiffness", s.stiffness, std::fabs(s.stiffness) * (4 * unit + unrounded) + 2 * by_y, "N/m"};
}

// What pulls harder than the contact holds.
void refuse_beyond(double pull_off, const StaticLoad& load) {
  if (load.kind == LoadKind::normal_force && load.value < pull_off) {
    load.place.refuse(fmt::format("the contact pulls off at {:.6g} N", pull_off));
  }
}

AdhesiveState state_of(const Jkr& jkr, const StaticLoad& load) {
  if (load.kind == LoadKind::normal_force) return jkr.under_force(load.value);
  return load.kind == LoadKind::approach ? jkr.at_approach(load.value) : jkr.at_radius(load.value);
}

LawAnswer jkr_answer(const AdhesiveSphere& sphere, const StaticLoad& load) {
  const Jkr jkr(sphere);
  const AdhesiveState s = state_of(jkr, load);
  const double y = jkr_tension(sphere, s.contact_radius);
  const double unrounded = jkr_unrounded(load.kind, y);
  LawAnswer answer{"jkr", results_of(sphere, s, jkr_errors(load.kind, unrounded)),
                   "Johnson, Kendall, Roberts: attraction of short range at the rim (large Tabor parameter)"};
  if (const auto stiffness = jkr_stiffness(sphere, s, y, unrounded)) answer.results.push_back(*stiffness);
  add_state(answer.results, "pull_off", sphere, jkr.load_pull_off());
  add_state(answer.results, "pull_off_held", sphere, jkr.displacement_pull_off());
  add_state(answer.results, "jump_in", sphere, jkr.jump_in());
  add_state(answer.results, "no_load", sphere, jkr.no_load());
  return answer;
}

AdhesiveState state_of(const Dmt& dmt, const StaticLoad& load) {
  if (load.kind == LoadKind::normal_force) return dmt.under_force(load.value);
  if (load.kind == LoadKind::approach) return dmt.at_approach(load.value);
  AdhesiveState state = dmt.at_approach(load.value * load.value / dmt.sphere.relative_radius);
  state.contact_radius = load.value;
  return state;
}

LawAnswer dmt_answer(const AdhesiveSphere& sphere, const StaticLoad& load) {
  const Dmt dmt(sphere);
  const auto s = state_of(dmt, load);
  constexpr double relative = 4 * unit;
  LawAnswer answer{
      "dmt", results_of(sphere, s, without_given({relative, relative, relative}, load.kind)),
      "Derjaguin, Muller, Toporov: attraction of long range outside a Hertz contact (small Tabor parameter)"};
  answer.results.push_back(within("stiffness", s.stiffness, 4, "N/m"));
  add_state(answer.results, "pull_off", sphere, dmt.pull_off());
  add_state(answer.results, "no_load", sphere, dmt.no_load());
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
  load.place.refuse("with a stress of adhesion give normal_force or contact_radius");
}

LawAnswer maugis_answer(const MaugisDugdale& maugis, const MaugisState& s, LoadKind given) {
  const AdhesiveSphere& sphere = maugis.sphere();
  // What an error of the radius does to force and approach is below their larger terms times three.
  const double relative = 3 * s.relative_radius_error + 4 * unit;
  const AdhesiveState state{s.normal_force, s.approach, s.contact_radius, 0};
  const MaugisState off = maugis.pull_off();
  const double lambda = maugis.maugis_parameter();
  LawAnswer answer{"maugis_dugdale", results_of(sphere, state, without_given({relative, relative, relative}, given)),
                   "Maugis, Dugdale: a constant attraction in a ring around the contact, between JKR and DMT"};
  answer.results.push_back({"outer_radius", s.outer_radius, relative * s.outer_radius, "m"});
  answer.results.push_back(within("maugis_parameter", lambda, 2, "1"));
  answer.results.push_back(within("pull_off_force", off.normal_force, 4, "N"));
  answer.results.push_back(within("pull_off_radius", off.contact_radius, 4, "m"));
  return answer;
}

// A law beside the main one; where it has no contact under this load, such as Hertz's under a pull, a warning.
template <class F>
void try_beside(Pressed& pressed, std::string_view law, F&& answer) {
  try {
    pressed.answer.beside.push_back(answer());
  } catch (const std::invalid_argument&) {
    pressed.answer.warnings.push_back(fmt::format("{} has no contact under this load", law));
  }
}

// JKR is Hertz and a flat punch that is pulled. `errors` of the state: the pressure is infinite where r may be a.
std::function<SurfacePoint(double, double)> jkr_surface(const AdhesiveSphere& sphere, const AdhesiveState& state,
                                                        const Relative& errors) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return [=](double x, double y) -> SurfacePoint {
    const double r = std::hypot(x, y);
    const double a = state.contact_radius;
    const double relative = errors.radius + 2 * unit;  // r is rounded, too
    const double moved = relative * a;
    const auto paraboloid = contact::Paraboloid::of_radius(sphere.relative_radius);
    const double height = paraboloid.height(r);
    const double deeper = a * a / sphere.relative_radius;  // of the Hertz contact of this radius
    const double pulled = deeper - state.approach;
    const double size =
        32 * unit * (deeper + height + std::fabs(state.approach)) + errors.approach * terms_of(sphere, state).approach;
    Estimate pressure{0, 0};
    if (std::fabs(r - a) <= moved) {
      pressure = {-infinity, infinity};
    } else if (r < a) {
      const double p = Jkr(sphere).pressure(a, r);
      const double hertz = sphere.contact_modulus * paraboloid.pressure(r, a);
      pressure = {p, (2 * hertz + std::fabs(p)) * (8 * unit + 2 * relative * (1 + a / (a - r - moved)))};
    }
    if (r < a) return {pressure, {state.approach - height, size}, {0, 0}};
    const double u = paraboloid.displacement(r, a) - 2 * pulled * std::asin(a / r) / std::numbers::pi;
    // The angle falls from its end like a root.
    const double turned = 4 * moved / std::sqrt(std::max(r - a, moved) * (r + a));
    const double error = size + 2 * relative * (deeper + pulled) + pulled * turned;
    return {pressure, {u, error}, {std::max(height - state.approach + u, 0.), 2 * error}};
  };
}

Pressed press_jkr(const AdhesiveSphere& sphere, const StaticLoad& load) {
  refuse_beyond(Jkr(sphere).load_pull_off().normal_force, load);
  const AdhesiveState state = state_of(Jkr(sphere), load);
  const double unrounded = jkr_unrounded(load.kind, jkr_tension(sphere, state.contact_radius));
  Pressed result{{jkr_answer(sphere, load), {}, {}},
                 state.contact_radius,
                 jkr_surface(sphere, state, jkr_errors(load.kind, unrounded))};
  result.answer.warnings.emplace_back(
      "how far the attraction reaches is not given ([adhesion] stress or equilibrium_distance): JKR is taken, which "
      "holds for a short reach");
  return result;
}

Pressed press_maugis(const AdhesiveSphere& sphere, const Adhesion& adhesion, const StaticLoad& load) {
  const auto maugis = at(adhesion.place, [&] { return MaugisDugdale::of(sphere, *adhesion.stress); });
  refuse_beyond(maugis.pull_off().normal_force, load);
  const MaugisState state = state_of(maugis, load);
  Pressed result{{maugis_answer(maugis, state, load.kind), {}, {}}, state.contact_radius};
  try_beside(result, "jkr", [&] { return jkr_answer(sphere, load); });
  return result;
}

}  // namespace

Pressed press_adhesive(double relative_radius, double contact_modulus, const PressScene& scene) {
  const auto& load = std::get<StaticLoad>(scene.load);
  const Adhesion& adhesion = *scene.adhesion;
  const auto sphere =
      at(adhesion.place, [&] { return AdhesiveSphere::of(relative_radius, contact_modulus, adhesion.work); });
  Pressed result = adhesion.stress ? press_maugis(sphere, adhesion, load) : press_jkr(sphere, load);
  try_beside(result, "dmt", [&] { return dmt_answer(sphere, load); });
  try_beside(result, "hertz", [&] { return hertz_answer(sphere, load); });
  add_bodies(result.answer.main.results, sphere);
  const double elastic_approach = result.extent * result.extent / relative_radius;
  warn_if_steep(result.answer,
                Steepness::of_circle(std::get<BodyPair>(scene.subject), result.extent, elastic_approach));
  return result;
}

}  // namespace patchgrip::cli
