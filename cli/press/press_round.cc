#include <patchgrip/cli/press/press_round.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include <boost/math/tools/minima.hpp>

#include <patchgrip/cli/press/loaded.h>
#include <patchgrip/cli/press/rounding.h>
#include <patchgrip/cli/scene/profile_of.h>
#include <patchgrip/cli/steepness.h>
#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/dundurs.h>
#include <patchgrip/contact/flat_punch.h>
#include <patchgrip/contact/stick_radius.h>

namespace patchgrip::cli {
namespace {

using contact::AxisymmetricContact;

// Where the slope of the stamp jumps the pressure is infinite, and no look at some radii would find that out.
template <contact::Profile P>
bool pressure_is_finite(const AxisymmetricContact<P>& c) {
  if constexpr (std::same_as<P, contact::FlatEndParaboloid> || std::same_as<P, contact::FlatEndCone> ||
                std::same_as<P, contact::Cone> || std::same_as<P, contact::PointProfile>) {
    return false;
  } else {
    return std::isfinite(c.pressure(0));  // a tip, a power not above 1
  }
}

// The largest pressure, where it is finite: searched over t = ln(r / (a - r)), as it may be close to the rim.
template <contact::Profile P>
Estimate peak_of(const AxisymmetricContact<P>& c) {
  constexpr double far = 24;
  constexpr double step = 0.5;
  const double a = c.radius();
  const auto radius = [a](double t) {
    return t < 0 ? a * (std::exp(t) / (1 + std::exp(t))) : a - a / (1 + std::exp(t));
  };
  const auto pressure = [&](double t) { return c.pressure(radius(t)); };
  double best = -far;
  double most = pressure(best);
  for (double t = -far + step; t <= far; t += step) {
    const double p = pressure(t);
    if (p > most) {
      best = t;
      most = p;
    }
  }
  const auto [offset, minus_p] = boost::math::tools::brent_find_minima(
      [&](double x) { return -pressure(best + x); }, -step, step, std::numeric_limits<double>::digits / 2);
  if (c.pressure(0) >= -minus_p) return {c.pressure(0), c.pressure_error(0) + 4 * unit * c.pressure(0)};
  // Where p bends downwards, its maximum between two neighbors is not further above the point found than those are
  // below; twice the error of p, as it misleads the search, too.
  constexpr double neighbor = 0x1p-22;
  const double t = best + offset;
  const double change =
      std::max(std::fabs(-minus_p - pressure(t - neighbor)), std::fabs(-minus_p - pressure(t + neighbor)));
  return {-minus_p, 2 * c.pressure_error(radius(t)) + change};
}

template <contact::Profile P>
LawAnswer answer_of(std::string law, const AxisymmetricContact<P>& c, std::string remark) {
  LawAnswer answer{std::move(law), {}, std::move(remark)};
  const double mean_error =
      c.mean_pressure() * (c.force_error() / c.force() + 2 * c.radius_error() / c.radius() + 4 * unit);
  answer.results = {{"contact_radius", c.radius(), c.radius_error(), "m"},
                    {"normal_force", c.force(), c.force_error(), "N"},
                    {"approach", c.approach(), c.approach_error(), "m"},
                    {"stiffness", c.stiffness(), c.stiffness_error(), "N/m"},
                    {"mean_pressure", c.mean_pressure(), mean_error, "Pa"}};
  if (pressure_is_finite(c)) {
    const Estimate peak = peak_of(c);
    answer.results.push_back({"peak_pressure", peak.value, peak.error, "Pa"});
  }
  return answer;
}

template <contact::Profile P>
Pressed pressed(std::string law, const AxisymmetricContact<P>& c, std::string remark) {
  const auto shared = std::make_shared<const AxisymmetricContact<P>>(c);
  return {{answer_of(std::move(law), c, std::move(remark)), {}, {}},
          c.radius(),
          [shared](double x, double y) -> SurfacePoint {
            const double r = std::hypot(x, y);
            return {{shared->pressure(r), shared->pressure_error(r)},
                    {shared->displacement(r), shared->displacement_error(r)},
                    {shared->gap(r), shared->gap_error(r)}};
          }};
}

template <contact::Profile P>
void add_beside(Pressed& pressed, const std::string& law, const AxisymmetricContact<P>& c, std::string remark) {
  pressed.answer.beside.push_back(answer_of(law, c, std::move(remark)));
  pressed.beside.push_back({law, [c](double x, double y) { return c.pressure(std::hypot(x, y)); }});
}

// The same load by another law; nothing where that law does not reach so far.
template <contact::Profile P>
void try_beside(Pressed& pressed, const std::string& law, P profile, const StaticLoad& load, double modulus,
                const std::string& remark) {
  try {
    add_beside(pressed, law, loaded(std::move(profile), load, modulus), remark);
  } catch (const std::invalid_argument& error) {
    pressed.answer.warnings.push_back(fmt::format("{} does not reach this load: {}", law, error.what()));
  }
}

double value_of(const LawAnswer& law, std::string_view name) {
  return std::ranges::find(law.results, name, &Result::name)->value;
}

// Of a quantity that both laws have: by how much the other one is larger [%].
double change(const LawAnswer& law, const LawAnswer& other, std::string_view name) {
  return 100 * (value_of(other, name) / value_of(law, name) - 1);
}

void warn_of_infinite_pressure(Pressed& pressed) {
  const auto& results = pressed.answer.main.results;
  if (std::ranges::find(results, "peak_pressure", &Result::name) == results.end()) {
    pressed.answer.warnings.emplace_back(
        "the pressure is infinite where the slope of the stamp jumps (in theory: integrable): no peak pressure");
  }
}

void add_modulus(Pressed& pressed, double modulus) {
  pressed.answer.main.results.push_back(within("contact_modulus", modulus, 1.01, "Pa"));
}

void add_other_spheres(Pressed& pressed, const SphereStamp& stamp, const StaticLoad& load, double modulus) {
  if (stamp.terms > 0) {
    return try_beside(pressed, "sphere", contact::Sphere::of_radius(stamp.radius), load, modulus, "the whole sphere");
  }
  for (const int terms : {1, 2, 3, 4}) {
    try_beside(pressed, fmt::format("sphere_series_{}", terms), contact::PowerSum::sphere_series(stamp.radius, terms),
               load, modulus, "the first terms of the sphere's series in r^2 (Keppler 4.14, corrected)");
  }
}

Pressed press_flat_punch(const FlatPunchStamp& stamp, const StaticLoad& load, double modulus) {
  if (load.kind == LoadKind::contact_radius) {
    load.place.refuse("a flat punch has its own; give normal_force or approach");
  }
  const auto punch = load.kind == LoadKind::normal_force
                         ? contact::FlatPunch::under_force(stamp.radius, load.value, modulus)
                         : contact::FlatPunch::at_approach(stamp.radius, load.value, modulus);
  Pressed result{
      {{"flat_punch",
        {within("contact_radius", punch.radius, 0, "m"),
         within("normal_force", punch.force, load.kind == LoadKind::normal_force ? 0 : 2, "N"),
         within("approach", punch.approach, load.kind == LoadKind::approach ? 0 : 2, "m"),
         within("stiffness", punch.stiffness(), 2, "N/m"), within("central_pressure", punch.pressure(0), 5, "Pa"),
         within("strain_energy", punch.strain_energy(), 4, "J")},
        "a rigid flat-ended cylinder on a half-space"},
       {},
       {"the pressure is infinite at the edge (in theory: integrable): no peak pressure"}},
      punch.radius,
      [punch](double x, double y) -> SurfacePoint {
        const double r = std::hypot(x, y);
        const double p = punch.pressure(r);
        const double u = punch.displacement(r);
        // Beyond the edge the punch has no face.
        return {{p, std::isfinite(p) ? 5 * unit * p : p}, {u, 4 * unit * u}, {0, 0}};
      }};
  return result;
}

void add_stick(Pressed& pressed, const BodyPair& pair, double mu) {
  const double beta = std::fabs(contact::Dundurs::of(pair.first.material, pair.second.material).beta);
  auto& results = pressed.answer.main.results;
  results.push_back({"dundurs_beta", beta, 2 * unit * beta + 0x1p-62, "1"});
  if (beta == 0) {
    results.push_back({"stick_radius_ratio", 1, 0, "1"});
    results.push_back({"one_minus_stick_radius_ratio", 0, 0, "1"});
    return;
  }
  // beta carries a unit, and 2^-62 where similar bodies nearly cancel; both ratios are monotone in beta / mu.
  const double chi = beta / mu;
  const double uncertain = 0x1p-62 / beta + 4 * unit;
  const auto s = contact::StickRatio::of(chi);
  const auto error = [&](double value, double at_less, double at_more) {
    return std::max(std::fabs(at_less - value), std::fabs(at_more - value)) + 8 * unit * value;
  };
  const auto more = contact::StickRatio::of(chi * (1 + uncertain));
  const auto less = uncertain < 1 ? contact::StickRatio::of(chi * (1 - uncertain)) : contact::StickRatio{1, 0, 0, 0};
  results.push_back({"stick_radius_ratio", s.stick, error(s.stick, less.stick, more.stick), "1"});
  results.push_back({"one_minus_stick_radius_ratio", s.slip, error(s.slip, less.slip, more.slip), "1"});
  // Of what is printed beta / mu stands in the denominator: the ratio grows with it, from 0.
  const auto printed = [mu](double any_beta) { return contact::seed_printed_stick_ratio(4 * any_beta / mu).stick; };
  const double low = uncertain < 1 ? printed(beta * (1 - uncertain)) : 0;
  pressed.answer.beside.push_back(
      {"stick_as_printed",
       {{"stick_radius_ratio", printed(beta), error(printed(beta), low, printed(beta * (1 + uncertain))), "1"}},
       "the relation that Keppler 4.1.4 prints, with the right side inverted"});
}

}  // namespace

Pressed press_balls(const BodyPair& pair, const PressScene& scene) {
  const double radius = *relative_radius_of(pair);
  const double modulus = contact::contact_modulus(pair.first.material, pair.second.material);
  const auto& load = std::get<StaticLoad>(scene.load);
  Pressed result = pressed("hertz", loaded(contact::Paraboloid::of_radius(radius), load, modulus),
                           "two paraboloids, circle of contact small against the radii");
  add_modulus(result, modulus);
  result.answer.main.results.push_back(within("relative_radius", radius, 1.01, "m"));
  try_beside(result, "sphere", contact::Sphere::of_radius(radius), load, modulus,
             "a rigid sphere of the relative radius on a half-space: what Hertz leaves out of the shape");
  if (scene.mu && *scene.mu > 0) add_stick(result, pair, *scene.mu);
  const auto steepness = Steepness::of_circle(pair, result.extent, value_of(result.answer.main, "approach"));
  if (!steepness.is_small()) {
    std::string warning = steepness.warning();
    const auto sphere = std::ranges::find(result.answer.beside, "sphere", &LawAnswer::law);
    if (sphere != result.answer.beside.end() && result.extent > narrow * radius) {
      const LawAnswer& hertz = result.answer.main;
      warning += fmt::format(
          "; with the height of a sphere instead of its paraboloid force, approach and radius change by "
          "{:+.2g} %, {:+.2g} % and {:+.2g} %",
          change(hertz, *sphere, "normal_force"), change(hertz, *sphere, "approach"),
          change(hertz, *sphere, "contact_radius"));
    }
    result.answer.warnings.push_back(std::move(warning));
  }
  return result;
}

Pressed press_stamp(const BodyPair& pair, const PressScene& scene) {
  const Shape& stamp = *stamp_of(pair);
  const double modulus = contact::contact_modulus(pair.first.material, pair.second.material);
  const auto& load = std::get<StaticLoad>(scene.load);
  const auto* punch = std::get_if<FlatPunchStamp>(&stamp);
  Pressed result = punch != nullptr
                       ? press_flat_punch(*punch, load, modulus)
                       : visit_profile(pair, [&](auto profile, const ProfileName& name) {
                           return pressed(name.law, loaded(std::move(profile), load, modulus), name.remark);
                         });
  if (const auto* sphere = std::get_if<SphereStamp>(&stamp)) add_other_spheres(result, *sphere, load, modulus);
  add_modulus(result, modulus);
  if (punch == nullptr) warn_of_infinite_pressure(result);
  warn_if_steep(result.answer, Steepness::of_stamp(result.extent, value_of(result.answer.main, "approach")));
  return result;
}

}  // namespace patchgrip::cli
