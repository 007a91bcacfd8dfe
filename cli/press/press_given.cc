#include <patchgrip/cli/press/press_given.h>

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <type_traits>

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <patchgrip/contact/fingertip/power_law.h>
#include <patchgrip/contact/fingertip/winkler.h>
#include <patchgrip/contact/fingertip/xydas_kao.h>
#include <patchgrip/contact/round_pressure.h>

namespace patchgrip::cli {
namespace {

constexpr double unit = 0x1p-53;

double force_of(const PressScene& scene) {
  const auto& load = std::get<StaticLoad>(scene.load);
  if (load.kind != LoadKind::normal_force) throw std::invalid_argument("contact: this law takes 'normal_force'");
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
};

RoundPatch round_patch(const PatchVariant& any, double force) {
  return std::visit(
      [&](const auto& patch) -> RoundPatch {
        using P = std::decay_t<decltype(patch)>;
        if constexpr (std::is_same_v<P, friction::HertzDisc>) {
          return {patch.radius(), power_pressure(patch.radius(), 1, force)};
        } else if constexpr (std::is_same_v<P, friction::UniformDisc>) {
          return {patch.radius(), power_pressure(patch.radius(), 0.5, force)};
        } else if constexpr (std::is_same_v<P, friction::FlatPunchDisc>) {
          return {patch.radius(), power_pressure(patch.radius(), 0, force)};
        } else if constexpr (std::is_same_v<P, friction::PowerDisc>) {
          if (patch.exponent() < 0) throw std::invalid_argument("exponent: press takes 0 and above");
          return {patch.radius(), power_pressure(patch.radius(), patch.exponent(), force)};
        } else if constexpr (std::is_same_v<P, friction::XydasKaoDisc>) {
          const auto p = contact::XydasKaoPressure::of(force, patch.radius(), patch.alpha());
          return {patch.radius(), [=](double r, double inward) {
                    // 1 - (r/a)^alpha close to the rim, from a - r.
                    const double root = -std::expm1(p.alpha * std::log1p(-inward / p.contact_radius));
                    return r > 0 ? p.peak_pressure * std::pow(root, 1 / p.alpha) : p.peak_pressure;
                  }};
        } else {
          throw std::invalid_argument("patch: press makes stamps of round pressures with a finite density");
        }
      },
      any);
}

// No approach goes with an empirical pressure.
Pressed with_pressure(LawAnswer answer, const contact::XydasKaoPressure& p, double relative_error) {
  Pressed result{{std::move(answer), {}, {}}, p.contact_radius, [=](double x, double y) -> SurfacePoint {
                   const double r = std::hypot(x, y);
                   const double pressure = p.pressure(r);
                   const double rim = r < p.contact_radius ? p.contact_radius / (p.contact_radius - r) : 0;
                   return {{pressure, relative_error * (1 + rim) * pressure}};
                 }};
  result.knows_displacement = false;
  return result;
}

Pressed press_power_law(std::string name, const contact::PowerLaw& law, double alpha, double force,
                        std::string remark) {
  const double a = law.contact_radius(force);
  const auto p = contact::XydasKaoPressure::of(force, a, alpha);
  const double relative = 4 * (1 + std::fabs(law.gamma * std::log(force))) * unit;
  return with_pressure({std::move(name),
                        {{"contact_radius", a, relative * a, "m"},
                         {"normal_force", force, 0, "N"},
                         {"peak_pressure", p.peak_pressure, (2 * relative + 2 * unit) * p.peak_pressure, "Pa"}},
                        std::move(remark)},
                       p, 4 * relative);
}

}  // namespace

Pressed press_given_pressure(const GivenPressure& given, const PressScene& scene) {
  const double force = force_of(scene);
  const RoundPatch patch = round_patch(given.patch, force);
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
                   const double p = r < patch.radius ? patch.pressure(r, patch.radius - r) : 0;
                   // The distance to the rim carries half a unit of the radius.
                   const double rim = r < patch.radius ? patch.radius / (patch.radius - r) : 0;
                   return {{p, std::isfinite(p) ? (16 + 2 * rim) * unit * p : p}, {u.value, u.error}, {0, 0}};
                 }};
  return result;
}

Pressed press_fingertip(const PowerLawFingertip& tip, const PressScene& scene) {
  const auto law = contact::PowerLaw::of(tip.coefficient, tip.exponent);
  const auto& load = std::get<StaticLoad>(scene.load);
  if (load.kind == LoadKind::approach) throw std::invalid_argument("approach: the power law says nothing of it");
  const double force = load.kind == LoadKind::normal_force ? load.value : law.normal_force(load.value);
  Pressed result = press_power_law("power_law", law, tip.alpha, force,
                                   "empirical: a = c F^gamma, pressure of Xydas and Kao (Keppler 4.3.2)");
  if (tip.exponent > 1. / 3.) {
    result.answer.warnings.emplace_back(
        "exponent above 1/3: no elastic ball does that; measured fingertips have 0.11 to 0.33");
  }
  return result;
}

Pressed press_fingertip(const MeasuredFingertip& tip, const PressScene& scene) {
  std::vector<contact::MeasuredRadius> points;
  for (const auto& [force, radius] : tip.points) points.push_back({force, radius});
  const auto fit = contact::PowerLawFit::to(points);
  const double force = force_of(scene);
  Pressed result = press_power_law("power_law_fit", fit.law, tip.alpha, force,
                                   "least squares of ln a on ln F; limits by Student's t");
  const auto add = [&](const char* name, double value, const char* of) {
    result.answer.main.results.push_back({name, value, 64 * unit * std::fabs(value), of});
  };
  add("c", fit.law.c, "m N^-gamma");
  add("gamma", fit.law.gamma, "1");
  add("rms_log", fit.rms_log, "1");
  if (fit.points > 2) {
    const auto gamma = fit.gamma_limits(tip.confidence);
    const auto c = fit.c_limits(tip.confidence);
    add("gamma_low", gamma.low, "1");
    add("gamma_high", gamma.high, "1");
    add("c_low", c.low, "m N^-gamma");
    add("c_high", c.high, "m N^-gamma");
  } else {
    result.answer.warnings.emplace_back("two points fix the line: no confidence limits");
  }
  return result;
}

Pressed press_fingertip(const WinklerFingertip& tip, const PressScene& scene) {
  const auto bed = contact::WinklerFingertip::of(tip.radius, tip.bed);
  const auto& load = std::get<StaticLoad>(scene.load);
  double approach = load.value;
  double relative = 0;
  if (load.kind == LoadKind::contact_radius) {
    throw std::invalid_argument("contact_radius: the bed takes 'normal_force' or 'approach'");
  }
  if (load.kind == LoadKind::normal_force) {
    // p = c (1 - g) g falls where a spring keeps less than half its length: the force has a largest value.
    const auto [deepest, minus_most] = boost::math::tools::brent_find_minima(
        [&](double delta) { return -bed.normal_force(delta); }, 0.1 * tip.radius, (1 - 1e-12) * tip.radius, 30);
    if (load.value > -minus_most) {
      throw std::invalid_argument(
          fmt::format("normal_force = {} is not allowed: the bed carries at most {} N", load.value, -minus_most));
    }
    std::uintmax_t steps = 200;
    const auto [lo, hi] = boost::math::tools::toms748_solve(
        [&](double log_delta) { return std::log(bed.normal_force(std::exp(log_delta)) / load.value); },
        std::log(1e-150 * tip.radius), std::log(deepest), boost::math::tools::eps_tolerance<double>(52), steps);
    approach = std::exp((lo + hi) / 2);
    relative = 1e-13;  // of the logarithm, and F ~ delta^2
  }
  const double a = bed.contact_radius(approach);
  const double p = bed.peak_pressure(approach);
  const double force = load.kind == LoadKind::normal_force ? load.value : bed.normal_force(approach);
  Pressed result{{{"winkler",
                   {{"contact_radius", a, (relative + 2 * unit) * a, "m"},
                    {"normal_force", force, load.kind == LoadKind::normal_force ? 0 : 2 * unit * force, "N"},
                    {"approach", approach, relative * approach, "m"},
                    {"peak_pressure", p, (relative + 2 * unit) * p, "Pa"}},
                   "independent springs: the radius is sqrt(2) times that of an elastic ball at the same approach"},
                  {},
                  {}},
                 a,
                 [=](double x, double y) -> SurfacePoint {
                   const double pressure = bed.inclined_pressure(approach, 0, x, y);
                   return {{pressure, (relative + 32 * unit) * p}};
                 }};
  result.knows_displacement = false;
  return result;
}

}  // namespace patchgrip::cli
