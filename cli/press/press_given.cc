#include <patchgrip/cli/press/press_given.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <type_traits>

#include <patchgrip/cli/press/rounding.h>
#include <patchgrip/contact/falling_root.h>
#include <patchgrip/contact/fingertip/power_law.h>
#include <patchgrip/contact/fingertip/winkler.h>
#include <patchgrip/contact/fingertip/xydas_kao.h>
#include <patchgrip/contact/round_pressure.h>

namespace patchgrip::cli {
namespace {

double force_of(const PressScene& scene) {
  const auto& load = std::get<StaticLoad>(scene.load);
  if (load.kind != LoadKind::normal_force) load.place.refuse("this law takes 'normal_force'");
  return load.value;
}

// p ~ (1 - r^2/a^2)^(n - 1/2), told r and a - r.
std::function<double(double, double)> power_pressure(double radius, double n, double force) {
  const double peak = (n + 0.5) * force / (std::numbers::pi * radius * radius);
  return [=](double r, double inward) { return peak * std::pow(inward / radius * (1 + r / radius), n - 0.5); };
}

struct RoundPatch {
  double radius;
  std::function<double(double, double)> pressure;  // (r, a - r) -> [Pa]
  double growth;                                   // |d ln p / d ln(a - r)| is at most that

  // r carries a rounding, and so does its distance to the rim. At the rim a singular pressure is infinite.
  Estimate pressure_at(double r) const {
    if (std::fabs(radius - r) <= 4 * unit * radius) {
      if (std::isinf(pressure(radius, 0))) return {pressure(radius, 0), pressure(radius, 0)};
      return {r < radius ? pressure(r, radius - r) : 0, pressure(radius, 8 * unit * radius)};
    }
    if (r > radius) return {0, 0};
    const double p = pressure(r, radius - r);
    return {p, (16 + growth * (4 + 2 * radius / (radius - r))) * unit * p};
  }
};

RoundPatch power_patch(double radius, double n, double force) {
  return {radius, power_pressure(radius, n, force), std::fabs(n - 0.5)};
}

RoundPatch round_patch(const PatchVariant& any, double force) {
  return std::visit(
      [&](const auto& patch) -> RoundPatch {
        using P = std::decay_t<decltype(patch)>;
        if constexpr (std::is_same_v<P, friction::HertzDisc>) {
          return power_patch(patch.radius(), 1, force);
        } else if constexpr (std::is_same_v<P, friction::UniformDisc>) {
          return power_patch(patch.radius(), 0.5, force);
        } else if constexpr (std::is_same_v<P, friction::FlatPunchDisc>) {
          return power_patch(patch.radius(), 0, force);
        } else if constexpr (std::is_same_v<P, friction::PowerDisc>) {
          if (patch.exponent() < 0) throw std::invalid_argument("exponent: press takes 0 and above");
          return power_patch(patch.radius(), patch.exponent(), force);
        } else if constexpr (std::is_same_v<P, friction::XydasKaoDisc>) {
          const auto p = contact::XydasKaoPressure::of(force, patch.radius(), patch.alpha());
          return {patch.radius(),
                  [=](double r, double inward) {
                    // 1 - (r/a)^alpha, from the smaller of r and a - r.
                    const double level = r < inward ? 1 - std::pow(r / p.contact_radius, p.alpha)
                                                    : -std::expm1(p.alpha * std::log1p(-inward / p.contact_radius));
                    return p.peak_pressure * std::pow(level, 1 / p.alpha);
                  },
                  std::max(1., 2 / p.alpha)};
        } else if constexpr (std::is_same_v<P, friction::SeedHertzDisc>) {
          throw std::invalid_argument(
              "patch: the seed's polynomials are fits of friction and have no pressure; give hertz_disc without "
              "'model'");
        } else {
          throw std::invalid_argument("patch: press makes stamps of round pressures with a finite density");
        }
      },
      any);
}

// What a radius within a factor of p's does to the pressure at r. At a given r it is largest where (r/a)^alpha = 2/3.
double scattered(const contact::XydasKaoPressure& p, double force, double factor, double r) {
  const double steepest = r * std::pow(1.5, 1 / p.alpha);
  const double middle = std::clamp(steepest, p.contact_radius / factor, p.contact_radius * factor);
  double change = 0;
  for (const double a : {p.contact_radius / factor, middle, p.contact_radius * factor}) {
    const double other = contact::XydasKaoPressure::of(force, a, p.alpha).pressure(r);
    change = std::max(change, std::fabs(other - p.pressure(r)));
  }
  return change;
}

// No approach goes with an empirical pressure. Its radius is within the factor of the true one, besides its rounding.
Pressed with_pressure(LawAnswer answer, const contact::XydasKaoPressure& p, double force, double factor,
                      double relative_error) {
  Pressed result{{std::move(answer), {}, {}}, p.contact_radius, [=](double x, double y) -> SurfacePoint {
                   const double r = std::hypot(x, y);
                   const double pressure = p.pressure(r);
                   const double rim = r < p.contact_radius ? p.contact_radius / (p.contact_radius - r) : 0;
                   const double scatter = factor > 1 ? scattered(p, force, factor, r) : 0;
                   return {{pressure, relative_error * (1 + rim) * pressure + scatter}};
                 }};
  result.knows_displacement = false;
  return result;
}

// The radius is off by its rounding, or by the factor that holds it.
Pressed press_power_law(std::string name, double alpha, const Estimate& force, const Estimate& radius, double factor,
                        std::string remark) {
  const auto p = contact::XydasKaoPressure::of(force.value, radius.value, alpha);
  const double relative = force.error / force.value + 2 * radius.error / radius.value + 4 * unit;
  return with_pressure({std::move(name),
                        {{"contact_radius", radius.value, factor > 1 ? (factor - 1) * radius.value : radius.error, "m"},
                         {"normal_force", force.value, force.error, "N"},
                         {"peak_pressure", p.peak_pressure, (relative + factor * factor - 1) * p.peak_pressure, "Pa"}},
                        std::move(remark)},
                       p, force.value, factor, relative + 4 * unit);
}

// F = 2 pi c h^2 [y - ln(1 + y)], y = delta/h, h = R - delta (winkler.h), and its derivatives. p = c (1 - g) g falls
// where a spring keeps less than half its length: so the force has a largest value, where F' = 0.
double winkler_slope(const contact::WinklerFingertip& bed, double delta) {
  const double h = bed.tip_radius - delta;
  return 2 * std::numbers::pi * bed.spring_modulus * (2 * h * std::log1p(delta / h) - delta);
}

double winkler_bend(const contact::WinklerFingertip& bed, double delta) {  // -F''
  return 2 * std::numbers::pi * bed.spring_modulus * (2 * std::log1p(delta / (bed.tip_radius - delta)) - 1);
}

// F' = 0 where ln(1 + y) = y/2: delta / R = y / (1 + y).
constexpr double deepest_share = 0.71533186295916153832;

// delta on the branch that rises.
Estimate winkler_approach(const contact::WinklerFingertip& bed, double force) {
  const double deepest = deepest_share * bed.tip_radius;
  const double most = bed.normal_force(deepest);
  if (force > most) {
    throw std::invalid_argument(fmt::format("the bed carries at most {} N", most));
  }
  if (force == most) return {deepest, std::sqrt(16 * unit * most / winkler_bend(bed, deepest))};
  const auto lacking = [&](double delta) { return force - bed.normal_force(delta); };
  const double least = std::sqrt(force / (std::numbers::pi * bed.spring_modulus));  // F < pi c delta^2
  const double delta = contact::falling_root(lacking, std::min(least, deepest), deepest);
  // The force at delta is as far off as is seen, and as it is rounded. Where it falls short of a straight line, F''
  // limits the way to the root.
  const double missed = std::fabs(bed.normal_force(delta) - force) + 4 * unit * force;
  const double by_slope = 2 * missed / winkler_slope(bed, delta);
  const double bend = winkler_bend(bed, delta) / 2;
  const double error = bend > 0 ? std::min(by_slope, std::sqrt(2 * missed / bend)) : by_slope;
  return {delta, error + unit * delta};
}

}  // namespace

Pressed press_given_pressure(const GivenPressure& given, const PressScene& scene) {
  const double force = force_of(scene);
  const RoundPatch patch = at(scene.subject_place, [&] { return round_patch(given.patch, force); });
  const auto inverse = std::make_shared<const contact::RoundPressure>(
      contact::RoundPressure::of(patch.radius, given.contact_modulus, patch.pressure));
  const auto approach = inverse->displacement(0);
  const double central = patch.pressure(0, patch.radius);
  Pressed result{{{"given_pressure",
                   {{"contact_radius", patch.radius, 0, "m"},
                    {"normal_force", force, 0, "N"},
                    {"approach", approach.value, approach.error, "m"},
                    {"central_pressure", central, 8 * unit * central, "Pa"}},
                   "the stamp that makes this pressure; approach is the depth of its middle"},
                  {},
                  {}},
                 patch.radius,
                 [inverse, patch](double x, double y) -> SurfacePoint {
                   const double r = std::hypot(x, y);
                   const auto u = inverse->displacement(r);
                   return {patch.pressure_at(r), {u.value, u.error}, {0, 0}};
                 }};
  warn_if_steep(result.answer, Steepness::of_stamp(patch.radius, approach.value));
  return result;
}

Pressed press_fingertip(const PowerLawFingertip& tip, const PressScene& scene) {
  const auto law = at(scene.subject_place, [&] { return contact::PowerLaw::of(tip.coefficient, tip.exponent); });
  const auto& load = std::get<StaticLoad>(scene.load);
  if (load.kind == LoadKind::approach) load.place.refuse("the power law says nothing of it");
  Estimate force{load.value, 0};
  Estimate radius{load.value, 0};
  if (load.kind == LoadKind::normal_force) {
    radius = radius_under(tip, load.value).radius;
  } else {
    const double F = law.normal_force(load.value);
    force = {F, (2 + std::fabs(std::log(load.value / law.c))) / law.gamma * unit * F};  // power_law.h
  }
  Pressed result = press_power_law("power_law", tip.alpha, force, radius, 1,
                                   "empirical: a = c F^gamma, pressure of Xydas and Kao (Keppler 4.3.2)");
  warn_of_exponent(result.answer.warnings, tip.exponent);
  return result;
}

Pressed press_fingertip(const MeasuredFingertip& tip, const PressScene& scene) {
  const double force = force_of(scene);
  const auto fit = at(scene.subject_place, [&] { return fit_to(tip); });
  const auto [radius, factor, warnings] = at(scene.subject_place, [&] { return radius_under(tip, fit, force); });
  Pressed result = press_power_law(
      "power_law_fit", tip.alpha, {force, 0}, radius, factor,
      fmt::format("least squares of ln a on ln F; limits, and the error of the radius, by Student's t at {:g} %",
                  100 * tip.confidence));
  result.answer.warnings = warnings;
  const double off = fit.error_units * unit;  // of gamma, ln c and what is left of ln a
  auto& results = result.answer.main.results;
  results.push_back({"c", fit.law.c, off * fit.law.c, "m N^-gamma"});
  results.push_back({"gamma", fit.law.gamma, off, "1"});
  results.push_back({"rms_log", fit.rms_log, off * (1 + fit.log_range), "1"});
  if (fit.points > 2) {
    const auto gamma = fit.gamma_limits(tip.confidence);
    const auto c = fit.c_limits(tip.confidence);
    // The half-widths are Student's factor times the spreads, and those follow the rms.
    const double rms = fit.rms_log > 0 ? off * (1 + fit.log_range) / fit.rms_log + 16 * unit : 0;
    const double gamma_error = off + rms * (gamma.high - fit.law.gamma) + unit * fit.law.gamma;
    const double c_error = off + rms * std::log(c.high / fit.law.c) + 16 * unit;
    results.push_back({"gamma_low", gamma.low, gamma_error, "1"});
    results.push_back({"gamma_high", gamma.high, gamma_error, "1"});
    results.push_back({"c_low", c.low, c_error * c.low, "m N^-gamma"});
    results.push_back({"c_high", c.high, c_error * c.high, "m N^-gamma"});
    const auto limits = fit.radius_limits(force, tip.confidence);
    const double spread = radius.error / radius.value + rms * std::log(factor) + 16 * unit;
    results.push_back({"contact_radius_low", limits.low, spread * limits.low, "m"});
    results.push_back({"contact_radius_high", limits.high, spread * limits.high, "m"});
  }
  return result;
}

Pressed press_fingertip(const WinklerFingertip& tip, const PressScene& scene) {
  const auto bed = at(scene.subject_place, [&] { return contact::WinklerFingertip::of(tip.radius, tip.bed); });
  const auto& load = std::get<StaticLoad>(scene.load);
  if (load.kind == LoadKind::contact_radius) {
    load.place.refuse("the bed takes 'normal_force' or 'approach'");
  }
  const bool by_force = load.kind == LoadKind::normal_force;
  const Estimate approach = by_force ? winkler_approach(bed, load.value) : Estimate{load.value, 0};
  const double delta = approach.value;
  const double left = tip.radius - delta;
  const double a = bed.contact_radius(delta);
  const double force = by_force ? load.value : bed.normal_force(delta);
  // Once the middle keeps less than half its length, the largest pressure is that of a ring around it.
  const bool ring = delta > left;
  const double p = ring ? tip.bed / 4 : bed.peak_pressure(delta);
  const double a_error = 2 * unit * a + approach.error * left / a;
  const double p_moved = ring ? 0 : tip.bed * approach.error / tip.radius;
  Pressed result{{{"winkler",
                   {{"contact_radius", a, a_error, "m"},
                    {"normal_force", force, by_force ? 0 : 2 * unit * force, "N"},
                    {"approach", delta, approach.error, "m"},
                    {"peak_pressure", p, 2 * unit * p + p_moved, "Pa"}},
                   "independent springs: the radius is sqrt(2) times that of an elastic ball at the same approach"},
                  {},
                  {}},
                 a,
                 [=](double x, double y) -> SurfacePoint {
                   if (std::hypot(x, y) > a + 2 * a_error) return {{0, 0}};
                   const double pressure = bed.inclined_pressure(delta, 0, x, y);
                   // dp/d(delta) is at most c / h, h = R - delta.
                   return {{pressure, 2 * unit * pressure + tip.bed * (0x1p-60 + approach.error / left)}};
                 }};
  result.knows_displacement = false;
  return result;
}

}  // namespace patchgrip::cli
