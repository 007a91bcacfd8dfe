#include <patchgrip/cli/scene/fingertip_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <patchgrip/cli/scene/patch_reader.h>
#include <patchgrip/cli/scene/sequence_reader.h>

namespace patchgrip::cli {
namespace {

constexpr Quantity force_range = positive("a force in N");
constexpr Quantity radius_range = positive("a radius of the contact in m");
constexpr double unit = 0x1p-53;

// a = c F^gamma for c (relative) and gamma (absolute) right to so many units of 2^-53.
contact::Estimate rounded_radius(const contact::PowerLaw& law, double normal_force, double units) {
  const double a = law.contact_radius(normal_force);
  return {a, (4 + units * (1 + std::fabs(std::log(normal_force)))) * unit * a};
}

// Beyond the measured forces, and for radii that look like millimetres.
void warn_of_range(std::vector<std::string>& warnings, const MeasuredFingertip& tip, double force) {
  constexpr double far = 2;              // beyond that a fit says more than was measured
  constexpr double widest_finger = 0.1;  // [m]
  const auto measured_force = [](const auto& point) { return point[0]; };
  const auto measured_radius = [](const auto& point) { return point[1]; };
  const auto [lightest, heaviest] = std::ranges::minmax(tip.points, {}, measured_force);
  const double least = lightest[0], most = heaviest[0];
  if (force > far * most || far * force < least) {
    warnings.push_back(
        fmt::format("normal_force = {} N lies outside of the measured {} .. {} N by a factor of {:.3g}: the law is "
                    "extrapolated, and its error holds only if it goes on like that",
                    force, least, most, force > most ? force / most : least / force));
  }
  const double widest = std::ranges::max(tip.points, {}, measured_radius)[1];
  if (widest > widest_finger) {
    warnings.push_back(
        fmt::format("a measured contact radius of {} m is wider than any fingertip: radii are in m", widest));
  }
}

}  // namespace

DescribedFingertip read_fingertip(const TomlReader& contact) {
  const TomlReader tip = contact.table(
      "fingertip", {"coefficient", "exponent", "measured", "confidence", "alpha", "radius", "bed_modulus"});
  const auto alpha = [&] { return tip.has("alpha") ? tip.number("alpha", alpha_range) : 2; };
  if (tip.has("measured")) {
    tip.refuse_others({"measured", "confidence", "alpha"}, "not used beside 'measured'");
    auto points = read_pairs(tip, "measured", "points [[F, a], ...] of force in N and contact radius in m", force_range,
                             radius_range);
    const double confidence = tip.has("confidence") ? tip.number("confidence", {"a confidence", 0.01, 0.9999}) : 0.95;
    std::string note = fmt::format("fingertip measured at {} points", points.size());
    return {MeasuredFingertip{std::move(points), confidence, alpha()}, std::move(note), tip.place("measured")};
  }
  if (tip.has("bed_modulus")) {
    tip.refuse_others({"bed_modulus", "radius"}, "not used beside 'bed_modulus'");
    const WinklerFingertip bed{tip.number("radius", positive("the radius of the fingertip in m")),
                               tip.number("bed_modulus", positive("the modulus c of the bed in Pa"))};
    return {bed, fmt::format("fingertip of radius {} m on a Winkler bed, c = {} Pa", bed.radius, bed.bed), tip.place()};
  }
  if (!tip.has("coefficient"))
    tip.refuse_table("needs 'coefficient' and 'exponent', 'measured', or 'bed_modulus' and 'radius'");
  tip.refuse_others({"coefficient", "exponent", "alpha"}, "not used beside 'coefficient'");
  const PowerLawFingertip law{tip.number("coefficient", positive("the coefficient c of a = c F^gamma in m N^-gamma")),
                              tip.number("exponent", {"the exponent gamma of a = c F^gamma", 0.01, 1}), alpha()};
  return {law, fmt::format("fingertip with a = {} F^{}, alpha = {}", law.coefficient, law.exponent, law.alpha),
          tip.place()};
}

contact::PowerLawFit fit_to(const MeasuredFingertip& tip) {
  std::vector<contact::MeasuredRadius> points;
  for (const auto& [force, radius] : tip.points) points.push_back({force, radius});
  return contact::PowerLawFit::to(points);
}

void warn_of_exponent(std::vector<std::string>& warnings, double least) {
  if (least > 1. / 3.) {
    warnings.emplace_back("exponent above 1/3: no elastic ball does that; measured fingertips have 0.11 to 0.33");
  }
}

FingertipRadius radius_under(const PowerLawFingertip& tip, double normal_force) {
  FingertipRadius result{rounded_radius(contact::PowerLaw::of(tip.coefficient, tip.exponent), normal_force, 1), 1, {}};
  warn_of_exponent(result.warnings, tip.exponent);
  return result;
}

FingertipRadius radius_under(const MeasuredFingertip& tip, const contact::PowerLawFit& fit, double normal_force) {
  constexpr double too_far = 10, far = 2;
  FingertipRadius result{rounded_radius(fit.law, normal_force, fit.error_units), 1, {}};
  const auto& a = result.radius;
  const bool scatters = fit.points > 2;
  if (scatters) {
    const auto [low, high] = fit.radius_limits(normal_force, tip.confidence);
    result.factor = high / a.value * (1 + 2 * a.error / a.value + 8 * unit);
    if (!(result.factor <= too_far)) {
      throw std::invalid_argument(
          fmt::format("the points scatter too much for a radius at F = {} N: a factor of {:.3g} at {:g} %, must be at "
                      "most {}",
                      normal_force, result.factor, 100 * tip.confidence, too_far));
    }
    if (result.factor > far) {
      result.warnings.push_back(
          fmt::format("the points scatter: at {:g} % the contact radius lies between {:.3g} and "
                      "{:.3g} m, a factor of {:.3g} either way",
                      100 * tip.confidence, low, high, result.factor));
    }
  } else {
    result.warnings.emplace_back(
        "two points fix the line: no confidence limits, and the error of the radius is that of the rounding");
  }
  warn_of_exponent(result.warnings,
                   scatters ? fit.gamma_limits(tip.confidence).low : fit.law.gamma - fit.error_units * unit);
  warn_of_range(result.warnings, tip, normal_force);
  return result;
}

}  // namespace patchgrip::cli
