#include <patchgrip/cli/scene/contact_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

#include <patchgrip/cli/rubbed_bodies.h>
#include <patchgrip/cli/scene/body_reader.h>
#include <patchgrip/cli/scene/fingertip_reader.h>
#include <patchgrip/cli/scene/friction_reader.h>
#include <patchgrip/friction/several.h>

namespace patchgrip::cli {
namespace {

using friction::AnyPatch;
using friction::Several;

constexpr Quantity force_range = positive("a force in N");
constexpr std::size_t most_parts = 10'000;

bool is_hertz(const TomlReader& patch) {
  const std::string name = patch.text("patch");
  return name == "hertz_disc" || name == "hertz_ellipse";
}

// Relative, of the sum of n forces F_i >= 0, and of n products mu_i F_i: each product and each addition is rounded in
// extended precision, n roundings at most on the way of a term, and the sum once to a double (several.cc).
constexpr double error_of_sum(std::size_t n) {
  return 0x1p-53 + static_cast<double>(n) * static_cast<double>(std::numeric_limits<long double>::epsilon() / 2);
}

Contact read_bodies(const TomlReader& contact, const MaterialLibrary& materials, double factor) {
  contact.refuse_others({"bodies", "normal_force", "centre", "angle", "model"},
                        "not used beside 'bodies', from which the contact follows; give either bodies or a patch");
  const BodyPair pair = read_two_bodies(contact, "bodies", materials);
  if (pair.first.relaxing || pair.second.relaxing) {
    contact.refuse("bodies", "friction acts between elastic bodies");
  }
  const double force = factor * contact.number("normal_force", force_range);
  return made(contact, "bodies", [&]() -> Contact {
    RubbedBodies rubbed = rub(pair, force, contact);
    Contact result{std::move(rubbed.patch), read_frame(contact), force};
    result.frame.angle += rubbed.angle;
    result.radius_error = rubbed.radius_error;
    result.shape_error = rubbed.shape_error;
    result.extent = rubbed.extent;
    result.coarse = std::move(rubbed.coarse);
    result.growth = rubbed.growth;
    result.notes = std::move(rubbed.notes);
    result.warnings = std::move(rubbed.warnings);
    result.notes.push_back("body A: " + pair.first.words);
    result.notes.push_back("body B: " + pair.second.words);
    return result;
  });
}

// A power law says the radius, Xydas and Kao the pressure.
Contact read_rubbed_fingertip(const TomlReader& contact, double factor) {
  contact.refuse_others({"fingertip", "normal_force", "centre", "angle"},
                        "not used beside 'fingertip'; give bodies, a patch, parts or a fingertip");
  DescribedFingertip tip = read_fingertip(contact);
  const double force = factor * contact.number("normal_force", force_range);
  if (std::holds_alternative<WinklerFingertip>(tip.tip)) {
    tip.place.refuse("a Winkler bed is pressed, but not rubbed: give 'coefficient' and 'exponent', or 'measured'");
  }
  return at(tip.place, [&]() -> Contact {
    FingertipRadius known;
    double alpha = 0, exponent = 0;
    if (const auto* const measured = std::get_if<MeasuredFingertip>(&tip.tip)) {
      const contact::PowerLawFit fit = fit_to(*measured);
      known = radius_under(*measured, fit, force);
      alpha = measured->alpha;
      exponent = fit.law.gamma;
    } else {
      const auto& given = *std::get_if<PowerLawFingertip>(&tip.tip);
      known = radius_under(given, force);
      alpha = given.alpha;
      exponent = given.exponent;
    }
    const auto& [radius, scatter, warnings] = known;
    const auto disc = [&](double a) { return friction::XydasKaoDisc::of_radius(a, alpha); };
    Contact rubbed{disc(radius.value), read_frame(contact), force};
    if (scatter > 1) {
      rubbed.scatter = RadiusScatter{disc(radius.value), disc(radius.value / scatter), disc(radius.value * scatter)};
    } else {
      rubbed.radius_error = rubbed.shape_error = radius.error / radius.value;
    }
    rubbed.growth = exponent;
    rubbed.warnings = warnings;
    rubbed.notes = {std::move(tip.words),
                    fmt::format("disc with the pressure of Xydas and Kao, alpha = {}, radius {} m{}", alpha,
                                radius.value, scatter > 1 ? fmt::format(" within a factor of {:.4g}", scatter) : "")};
    return rubbed;
  });
}

Contact read_given_patch(const TomlReader& contact) {
  DescribedPatch patch = read_patch(contact);
  Contact given{std::move(patch.patch), read_frame(contact), contact.number("normal_force", force_range)};
  if (is_hertz(contact)) given.growth = hertz_growth;
  given.notes.push_back(std::move(patch.words));
  return given;
}

// The coefficient of parts that have none of their own.
double common_mu(const TomlReader& scene, const TomlReader& part) {
  if (!scene.has("friction")) {
    part.refuse("mu", fmt::format("needed here, or in a table [{}], as other parts have their own",
                                  scene.full_name("friction")));
  }
  const friction::Law law = read_friction(scene);
  if (law.mu_static != law.mu_kinetic || law.mu_viscous != 0) {
    scene.refuse("friction", "parts with their own 'mu' rub by Coulomb's law: give 'mu' alone");
  }
  return law.mu_static;
}

Contact read_parts(const TomlReader& scene, const TomlReader& contact) {
  contact.refuse_others({"parts"}, "not used beside 'parts', which have their own patches, places and forces");
  const auto parts = contact.tables(
      "parts", {"patch", "radius", "exponent", "alpha", "semi_axes", "length", "sides", "vertices", "holes",
                "pressures", "points", "cell", "mesh", "unit", "centre", "angle", "model", "normal_force", "mu"});
  if (parts.empty() || parts.size() > most_parts) {
    contact.refuse("parts", fmt::format("1 to {} parts, each under [[{}]]", most_parts, contact.full_name("parts")));
  }
  const bool own_mu = std::ranges::any_of(parts, [](const TomlReader& part) { return part.has("mu"); });
  std::vector<Several::Part> all;
  std::vector<std::string> notes;
  bool rubs = false;
  for (const TomlReader& table : parts) {
    DescribedPatch patch = read_patch(table);
    const friction::PlanarFrame frame = read_frame(table);
    const double force = table.number("normal_force", force_range);
    double mu = 1;
    if (own_mu) {
      mu = table.has("mu") ? table.number("mu", non_negative("a coefficient of friction")) : common_mu(scene, table);
    }
    rubs = rubs || mu > 0;
    all.push_back({visit_patch(patch.patch, frame, [](const auto& p) { return friction::AnyPatch(p); }), force, mu});
    const std::string place = in_words(frame);
    notes.push_back(fmt::format("part {}: {}{}{}, normal force {} N{}", notes.size() + 1, patch.words,
                                place.empty() ? "" : ", ", place, force, own_mu ? fmt::format(", mu = {}", mu) : ""));
  }
  if (!rubs) contact.refuse("parts", "parts of which at least one has mu > 0");
  const auto several = made(contact, "parts", [&] { return Several::of_parts(std::move(all)); });
  Contact together{AnyPatch(several), {}, several.normal_force()};
  if (std::ranges::any_of(parts, is_hertz)) together.growth.reset();  // they grow, their distances do not
  together.sum_error = error_of_sum(parts.size());
  if (own_mu) together.resistance = several.resistance();
  together.notes = std::move(notes);
  if (scene.has("friction") && std::ranges::all_of(parts, [](const TomlReader& part) { return part.has("mu"); })) {
    together.warnings.push_back(
        fmt::format("[{}] is not used: every part has its own 'mu'", scene.full_name("friction")));
  }
  return together;
}

}  // namespace

TomlReader contact_table(const TomlReader& scene) {
  return scene.table("contact",
                     {"patch",        "radius",   "exponent",       "alpha",           "semi_axes", "length",
                      "sides",        "vertices", "holes",          "pressures",       "points",    "cell",
                      "mesh",         "unit",     "centre",         "angle",           "model",     "parts",
                      "normal_force", "approach", "contact_radius", "contact_modulus", "bodies",    "fingertip"});
}

Contact read_contact(const TomlReader& scene, const MaterialLibrary& materials, double factor) {
  const TomlReader table = contact_table(scene);
  if (!table.has("patch") && !table.has("bodies") && !table.has("parts") && !table.has("fingertip")) {
    table.refuse_table(fmt::format("needs 'patch' (a name), two tables [[{}]], some [[{}]] or 'fingertip'",
                                   table.full_name("bodies"), table.full_name("parts")));
  }
  Contact contact = table.has("bodies")      ? read_bodies(table, materials, factor)
                    : table.has("parts")     ? read_parts(scene, table)
                    : table.has("fingertip") ? read_rubbed_fingertip(table, factor)
                                             : read_given_patch(table);
  const std::string place = in_words(contact.frame);
  if (!place.empty()) contact.notes.push_back(place);
  contact.notes.push_back(fmt::format("normal force {} N", contact.normal_force));
  return contact;
}

friction::AnyPatch any_patch(const Contact& contact) {
  return visit_patch(contact.patch, contact.frame, [](const auto& patch) { return friction::AnyPatch(patch); });
}

}  // namespace patchgrip::cli
