#include <patchgrip/cli/rubbed_bodies.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>

#include <patchgrip/cli/press/press_ellipse.h>
#include <patchgrip/cli/press/press_height_map.h>
#include <patchgrip/cli/press/press_mesh.h>
#include <patchgrip/cli/scene/patch_reader.h>
#include <patchgrip/cli/scene/profile_of.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/cli/steepness.h>
#include <patchgrip/cli/unanswered.h>
#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/flat_punch.h>
#include <patchgrip/contact/hertz_circle.h>
#include <patchgrip/contact/hertz_ellipse.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/sampled/pressure_grid.h>

namespace patchgrip::cli {
namespace {

// Relative: 4 units of 2^-53 of its own, and a third of those of contact modulus (6) and relative radius (4).
constexpr double computed_radius_error = 8 * 0x1p-53;

// Relative, of the semi-axes: 1.6 units of their own, a third of those of the modulus, two thirds of those of the
// radii.
constexpr double computed_axes_error = 8 * 0x1p-53;

// The profiles' own, up to 4 + 8 / m units for the least m = 0.05 of a power, and that of their punch loads.
constexpr double stamp_radius_error = 256 * 0x1p-53;

// Where it is small a note says how small; else a warning does.
RubbedBodies with(RubbedBodies rubbed, const Steepness& steepness) {
  if (steepness.is_small()) {
    rubbed.notes.back() += fmt::format(", {} (the half-space theory wants it small)", steepness.text());
  } else {
    rubbed.warnings.push_back(steepness.warning());
  }
  return rubbed;
}

RubbedBodies disc(DescribedPatch patch, double radius_error, std::optional<double> growth, std::string law,
                  const Steepness& steepness) {
  return with({.patch = std::move(patch.patch),
               .radius_error = radius_error,
               .shape_error = radius_error,
               .growth = growth,
               .notes = {std::move(patch.words), std::move(law)}},
              steepness);
}

// Of stamps that look alike at every depth: F ~ a^(n + 1) under f ~ r^n (contact/power_profile.h).
struct Growth {
  std::optional<double> operator()(const contact::Cone&) const { return 1. / 2; }
  std::optional<double> operator()(const contact::PowerProfile& power) const { return 1 / (1 + power.exponent()); }
  template <class Other>
  std::optional<double> operator()(const Other&) const {
    return std::nullopt;
  }
};

// The exponent m of w ~ s^m at the axis (stamp_disc.h).
struct Order {
  double operator()(const contact::Cone&) const { return 1; }
  double operator()(const contact::PowerProfile& power) const { return power.exponent(); }
  template <class Smooth>
  double operator()(const Smooth&) const {
    return 2;
  }
};

RubbedBodies punch_stack(const BodyPair& pair, double force, double modulus) {
  return visit_profile(pair, [&](auto profile, const ProfileName& name) -> RubbedBodies {
    using P = decltype(profile);
    if constexpr (std::is_same_v<P, contact::FlatEndCone> || std::is_same_v<P, contact::FlatEndParaboloid> ||
                  std::is_same_v<P, contact::PointProfile>) {
      throw std::invalid_argument("a stamp with a flat end or kinks is pressed, but not rubbed");
    } else {
      const double order = Order{}(profile);
      const std::optional<double> growth = Growth{}(profile);
      const auto c = contact::AxisymmetricContact<P>::under_force(std::move(profile), force, modulus);
      return disc({friction::StampDisc::of_punches(
                       c.radius(), [&](double x) { return c.punch_load_density(x); }, order),
                   fmt::format("disc under {}, radius {} m", name.remark, c.radius())},
                  stamp_radius_error, growth, "from two bodies: a stamp on a half-space",
                  Steepness::of_stamp(c.radius(), c.approach()));
    }
  });
}

RubbedBodies ellipse_of_bodies(const CurvedSurface& first, const CurvedSurface& second, double force, double modulus) {
  const auto radii = relative_radii_of(first, second);
  const auto e = contact::HertzEllipse::under_force(force, radii, modulus);
  const auto direction = EllipseDirection::of(first, second, radii);
  // Turned by d, the points of an ellipse move by (a - b) sin d at most; relative to b where they are nearest.
  const double turned = e.one_minus_b_a * e.a / e.b * std::min(direction.error, 1.);
  return with(
      {.patch = friction::AnyPatch(friction::HertzEllipse::of_semi_axes(e.a, e.b)),
       .angle = direction.angle,
       .shape_error = computed_axes_error + turned,
       .extent = e.a,
       .growth = hertz_growth,
       .notes = {fmt::format("Hertz ellipse, semi-axes {} m and {} m, the first at {} rad", e.a, e.b, direction.angle),
                 "from two bodies by Hertz"}},
      Steepness::of_ellipse(first, second, radii, direction.angle, e.a, e.b));
}

RubbedBodies ellipse_of_mesh(const contact::MeshContact& mesh, double force, double modulus) {
  const auto pressed = mesh.under_force(force, modulus);
  const auto& e = pressed.ellipse;
  return with({.patch = friction::AnyPatch(friction::HertzEllipse::of_semi_axes(e.a, e.b)),
               .shape_error = std::max(pressed.a_error / e.a, pressed.b_error / e.b),
               .extent = e.a,
               .growth = hertz_growth,
               .notes = {fmt::format("Hertz ellipse, semi-axes {} m and {} m, the x-axis along the first", e.a, e.b),
                         "from a mesh by Hertz; its errors are those of the fitted curvature"}},
              Steepness::of_mesh(mesh, e.a, e.b));
}

friction::AnyPatch sampled(const contact::PressedHalfSpace& pressed) {
  const contact::Grid& grid = pressed.grid;
  const friction::PressureCells cells{
      static_cast<std::size_t>(grid.nx), static_cast<std::size_t>(grid.ny), grid.dx,         grid.dy,
      -0.5 * grid.nx * grid.dx,          -0.5 * grid.ny * grid.dy,          pressed.pressure};
  return friction::PressureGrid::within(friction::PressureGrid::default_tolerance, cells);
}

RubbedBodies grid_of_bodies(const BodyPair& pair, double force, double modulus, const TomlReader& contact) {
  if (height_map_of(pair)->periodic) throw std::invalid_argument("a periodic height map has no end, and so no patch");
  const StaticLoad load{LoadKind::normal_force, force, contact.place("normal_force")};
  const Place bodies = contact.place("bodies");
  try {
    return at(load.place, [&]() -> RubbedBodies {
      const auto pressed = press_map(pair, modulus, load, bodies);
      const auto& [nx, ny, dx, dy] = pressed.grid;
      return with({.patch = sampled(pressed),
                   .coarse = sampled(press_map(pair, modulus, load, bodies, 2)),
                   .notes = {fmt::format("pressure by the numerical half-space on {} by {} cells of {} m by {} m", nx,
                                         ny, dx, dy),
                             "errors hold the difference from half as many cells a side: an estimate"}},
                  steepness_of(pressed, modulus));
    });
  } catch (const SceneError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw Unanswered(load.place, error.what());
  }
}

}  // namespace

RubbedBodies rub(const BodyPair& pair, double normal_force, const TomlReader& contact) {
  const double modulus = contact::contact_modulus(pair.first.material, pair.second.material);
  if (const auto radius = relative_radius_of(pair)) {
    const auto circle = contact::HertzCircle::under_force(normal_force, *radius, modulus);
    return disc(hertz_disc(contact, circle.radius), computed_radius_error, hertz_growth, "from two bodies by Hertz",
                Steepness::of_circle(pair, circle.radius, circle.approach));
  }
  if (has_mesh(pair)) return ellipse_of_mesh(mesh_contact(pair, contact.place("bodies")), normal_force, modulus);
  const auto first = curved_surface(pair.first.shape);
  const auto second = curved_surface(pair.second.shape);
  if (first && second) return ellipse_of_bodies(*first, *second, normal_force, modulus);
  if (height_map_of(pair) != nullptr) return grid_of_bodies(pair, normal_force, modulus, contact);
  const Shape* stamp = stamp_of(pair);
  if (stamp == nullptr) throw std::invalid_argument("these two shapes make no patch that friction is known of");
  if (const auto* punch = std::get_if<FlatPunchStamp>(stamp)) {
    const auto pressed = contact::FlatPunch::under_force(punch->radius, normal_force, modulus);
    return disc({friction::FlatPunchDisc::of_radius(punch->radius),
                 fmt::format("disc under a flat punch, radius {} m", punch->radius)},
                0, 0, "from two bodies: a flat punch on a half-space",
                Steepness::of_stamp(punch->radius, pressed.approach));
  }
  return punch_stack(pair, normal_force, modulus);
}

}  // namespace patchgrip::cli
