#include <patchgrip/cli/scene/fingertip_reader.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include <patchgrip/cli/scene/patch_reader.h>
#include <patchgrip/cli/scene/sequence_reader.h>

namespace patchgrip::cli {
namespace {

constexpr Quantity force_range = positive("a force in N");
constexpr Quantity radius_range = positive("a radius of the contact in m");

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

contact::Estimate radius_under(const contact::PowerLaw& law, double normal_force, double units) {
  const double a = law.contact_radius(normal_force);
  return {a, (4 + units * (1 + std::fabs(std::log(normal_force)))) * 0x1p-53 * a};
}

}  // namespace patchgrip::cli
