#include <patchgrip/cli/scene/contact_reader.h>

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <patchgrip/cli/scene/body_reader.h>
#include <patchgrip/cli/scene/outline_reader.h>
#include <patchgrip/cli/scene/profile_of.h>
#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/hertz_circle.h>

namespace patchgrip::cli {
namespace {

constexpr Quantity radius_range = positive("a radius in m");
constexpr Quantity exponent_range{"the exponent n of (1 - r^2/a^2)^(n - 1/2)", -0.5, 20, false, false, true};
constexpr Quantity alpha_range{"the exponent alpha of (1 - (r/a)^alpha)^(1/alpha)", 0.5, 50};

// Relative: 4 units of 2^-53 of its own, and a third of those of contact modulus (6) and relative radius (4).
constexpr double computed_radius_error = 8 * 0x1p-53;

// The profiles' own, up to 4 + 8 / m units for the least m = 0.05 of a power, and that of their punch loads.
constexpr double stamp_radius_error = 256 * 0x1p-53;

enum class Kind { hertz_disc, flat_punch_disc, uniform_disc, ring, power_disc, xydas_kao_disc, rectangle, polygon };
constexpr std::array<std::string_view, 8> kind_names{"hertz_disc", "flat_punch_disc", "uniform_disc", "ring",
                                                     "power_disc", "xydas_kao_disc",  "rectangle",    "polygon"};

bool seed_model(const TomlReader& contact) {
  constexpr std::array<std::string_view, 2> models{"exact", "seed_polynomial"};
  return contact.has("model") && contact.choice("model", models) == 1;
}

using Described = DescribedPatch;

Described hertz_disc(const TomlReader& contact, double radius) {
  if (seed_model(contact)) {
    return {friction::SeedHertzDisc::of_radius(radius),
            fmt::format("Hertz disc by the polynomials of Keppler 2006, 4.2.5, radius {} m", radius)};
  }
  return {friction::HertzDisc::of_radius(radius), fmt::format("Hertz disc, radius {} m", radius)};
}

Described read_disc(const TomlReader& contact, Kind kind) {
  const double radius = contact.number("radius", radius_range);
  const std::string size = fmt::format("radius {} m", radius);
  switch (kind) {
    case Kind::hertz_disc:
      return hertz_disc(contact, radius);
    case Kind::flat_punch_disc:
      return {friction::FlatPunchDisc::of_radius(radius), "disc under a flat punch, " + size};
    case Kind::uniform_disc:
      return {friction::UniformDisc::of_radius(radius), "uniform disc, " + size};
    case Kind::ring:
      return {friction::Ring::of_radius(radius), "thin ring, " + size};
    case Kind::power_disc: {
      const double exponent = contact.number("exponent", exponent_range);
      return {made(contact, "exponent", [&] { return friction::PowerDisc::of_radius(radius, exponent); }),
              fmt::format("disc with p ~ (1 - r^2/a^2)^(n - 1/2), n = {}, {}", exponent, size)};
    }
    default: {
      const double alpha = contact.number("alpha", alpha_range);
      return {made(contact, "alpha", [&] { return friction::XydasKaoDisc::of_radius(radius, alpha); }),
              fmt::format("disc with the pressure of Xydas and Kao, alpha = {}, {}", alpha, size)};
    }
  }
}

Described read_rectangle(const TomlReader& contact) {
  const auto [along_x, along_y] = read_sides(contact, "sides");
  return {made(contact, "sides", [&, x = along_x, y = along_y] { return friction::Rectangle::of_sides(x, y); }),
          fmt::format("uniform rectangle, sides {} m along x and {} m along y", along_x, along_y)};
}

Described read_polygon(const TomlReader& contact) {
  auto outline = read_outline(contact, "vertices", "holes");
  std::string words =
      fmt::format("uniform polygon, outer vertices {}, holes {}", outline.outer.size(), outline.holes.size());
  return {made(contact, "vertices",
               [&] { return friction::Polygon::uniform(std::move(outline.outer), std::move(outline.holes)); }),
          std::move(words)};
}

// The exponent m of w ~ s^m at the axis (stamp_disc.h).
struct Order {
  double operator()(const contact::Cone&) const { return 1; }
  double operator()(const contact::PowerProfile& power) const { return power.exponent(); }
  template <class Smooth>
  double operator()(const Smooth&) const {
    return 2;
  }
};

Described punch_stack(const BodyPair& pair, double force, double modulus) {
  return visit_profile(pair, [&](auto profile, const ProfileName& name) -> Described {
    using P = decltype(profile);
    if constexpr (std::is_same_v<P, contact::FlatEndCone> || std::is_same_v<P, contact::FlatEndParaboloid> ||
                  std::is_same_v<P, contact::PointProfile>) {
      throw std::invalid_argument("a stamp with a flat end or kinks is pressed, but not rubbed");
    } else {
      const double order = Order{}(profile);
      const auto c = contact::AxisymmetricContact<P>::under_force(std::move(profile), force, modulus);
      return {friction::StampDisc::of_punches(
                  c.radius(), [&](double x) { return c.punch_load_density(x); }, order),
              fmt::format("disc under {}, radius {} m", name.remark, c.radius())};
    }
  });
}

struct RoundContact {
  Described disc;
  double radius_error;  // relative
  std::string validity;
};

RoundContact round_contact(const TomlReader& contact, const BodyPair& pair, double force) {
  const double modulus = contact::contact_modulus(pair.first.material, pair.second.material);
  if (const auto radius = relative_radius_of(pair)) {
    const double a = contact::HertzCircle::under_force(force, *radius, modulus).radius;
    return {hertz_disc(contact, a), computed_radius_error,
            fmt::format("from two bodies by Hertz, a/R = {:.2g} (the half-space theory wants it small)", a / *radius)};
  }
  const Shape* stamp = stamp_of(pair);
  if (stamp == nullptr)
    throw std::invalid_argument("friction is tabulated between balls, hollows and planes, and under stamps");
  if (const auto* punch = std::get_if<FlatPunchStamp>(stamp)) {
    return {{friction::FlatPunchDisc::of_radius(punch->radius),
             fmt::format("disc under a flat punch, radius {} m", punch->radius)},
            0,
            "from two bodies: a flat punch on a half-space"};
  }
  return {punch_stack(pair, force, modulus), stamp_radius_error, "from two bodies: a stamp on a half-space"};
}

Contact read_bodies(const TomlReader& contact, const MaterialLibrary& materials) {
  contact.refuse_others({"bodies", "normal_force", "centre", "model"},
                        "not used beside 'bodies', from which the contact follows; give either bodies or a patch");
  const BodyPair pair = read_two_bodies(contact, "bodies", materials);
  if (pair.first.relaxing || pair.second.relaxing) {
    contact.refuse("bodies", "friction is tabulated between elastic bodies");
  }
  const double force = contact.number("normal_force", positive("a force in N"));
  return made(contact, "bodies", [&]() -> Contact {
    RoundContact round = round_contact(contact, pair, force);
    return {std::move(round.disc.patch),
            {},
            force,
            round.radius_error,
            {std::move(round.disc.words), std::move(round.validity), "body A: " + pair.first.words,
             "body B: " + pair.second.words}};
  });
}

Contact read_given_patch(const TomlReader& contact) {
  Described patch = read_patch(contact);
  return {std::move(patch.patch),
          {},
          contact.number("normal_force", positive("a force in N")),
          0,
          {std::move(patch.words)}};
}

}  // namespace

DescribedPatch read_patch(const TomlReader& contact) {
  const auto kind = static_cast<Kind>(contact.choice("patch", kind_names));
  const auto takes = [&](TomlReader::Keys keys, std::string_view words) {
    contact.refuse_others(
        keys, fmt::format("not used by a {}, which takes {}", kind_names[static_cast<std::size_t>(kind)], words));
  };
  switch (kind) {
    case Kind::rectangle:
      takes({"patch", "normal_force", "contact_modulus", "centre", "sides"}, "'sides' and 'centre'");
      return read_rectangle(contact);
    case Kind::polygon:
      takes({"patch", "normal_force", "contact_modulus", "vertices", "holes"}, "'vertices' and 'holes'");
      return read_polygon(contact);
    case Kind::hertz_disc:
      takes({"patch", "normal_force", "contact_modulus", "centre", "radius", "model"},
            "'radius', 'model' and 'centre'");
      break;
    case Kind::power_disc:
      takes({"patch", "normal_force", "contact_modulus", "centre", "radius", "exponent"},
            "'radius', 'exponent' and 'centre'");
      break;
    case Kind::xydas_kao_disc:
      takes({"patch", "normal_force", "contact_modulus", "centre", "radius", "alpha"},
            "'radius', 'alpha' and 'centre'");
      break;
    default:
      takes({"patch", "normal_force", "contact_modulus", "centre", "radius"}, "'radius' and 'centre'");
  }
  return read_disc(contact, kind);
}

TomlReader contact_table(const TomlReader& scene) {
  return scene.table("contact",
                     {"patch", "radius", "exponent", "alpha", "sides", "vertices", "holes", "centre", "model",
                      "normal_force", "approach", "contact_radius", "contact_modulus", "bodies", "fingertip"});
}

Contact read_contact(const TomlReader& scene, const MaterialLibrary& materials) {
  const TomlReader table = contact_table(scene);
  if (!table.has("patch") && !table.has("bodies")) {
    table.refuse_table("needs 'patch' (a name) or two tables [[contact.bodies]]");
  }
  Contact contact = table.has("bodies") ? read_bodies(table, materials) : read_given_patch(table);
  if (table.has("centre")) {
    contact.centre = read_point(table, table.node("centre"), "centre");
    contact.notes.push_back(fmt::format("centre ({}, {}) m", contact.centre.x, contact.centre.y));
  }
  contact.notes.push_back(fmt::format("normal force {} N", contact.normal_force));
  return contact;
}

}  // namespace patchgrip::cli
