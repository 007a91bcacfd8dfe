#include <patchgrip/cli/grasp/grasp_picture.h>

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <patchgrip/cli/picture/colours.h>
#include <patchgrip/cli/picture/picture_axes.h>
#include <patchgrip/cli/picture/svg.h>

namespace patchgrip::cli {
namespace {

using grasp::Contact;
using grasp::ContactAnswer;
using grasp::ContactState;
using grasp::Vector3;
using grasp::Verdict;

constexpr double width = 120, height = 110;  // [mm]

constexpr Colour grey{0.6, 0.6, 0.6};
constexpr Colour pale{0.82, 0.89, 0.95};

SpacePoint to_point(const Vector3& v) { return {v[0], v[1], v[2]}; }

struct Arrow {
  Vector3 from, to;
  Stroke stroke;
};

struct Picture {
  View view;
  Svg svg{width, height};

  Spot spot(const Vector3& p) const { return view(to_point(p)); }

  void draw(const Arrow& arrow) {
    const Spot a = spot(arrow.from), b = spot(arrow.to);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0.3)) return;
    const double head = std::min(2.4, 0.5 * length), half = 0.38 * head;
    const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
    const Spot neck{b.x - head * ux, b.y - head * uy};
    svg.line(std::array{a, neck}, arrow.stroke);
    svg.polygon(
        std::array{b, Spot{neck.x - half * uy, neck.y + half * ux}, Spot{neck.x + half * uy, neck.y - half * ux}},
        arrow.stroke.colour, {arrow.stroke.colour, 0.1});
  }

  // From the contact into the object.
  void draw_cone(const Contact& contact, double size) {
    constexpr int sides = 48;
    const double mu = contact.cone().mu();
    const double depth = size / std::hypot(1, mu);
    std::vector<Spot> rim;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      const Vector3 out = std::cos(angle) * contact.u() + std::sin(angle) * contact.v();
      rim.push_back(spot(contact.position() + depth * (-contact.normal() + mu * out)));
    }
    const Spot apex = spot(contact.position());
    for (std::size_t i = 0; i < rim.size(); ++i) {
      svg.polygon(std::array{apex, rim[i], rim[(i + 1) % rim.size()]}, pale, {pale, 0.1});
    }
    rim.push_back(rim.front());
    svg.line(rim, {blue, 0.2, false, 0.7});
    // Its outline on the page: the generators farthest to either side of the axis.
    const Spot axis = spot(contact.position() - depth * contact.normal());
    std::size_t left = 0, right = 0;
    double least = 0, most = 0;
    for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
      const double ax = axis.x - apex.x, ay = axis.y - apex.y, bx = rim[i].x - apex.x, by = rim[i].y - apex.y;
      const double turn = std::atan2(ax * by - ay * bx, ax * bx + ay * by);
      if (turn < least) least = turn, left = i;
      if (turn > most) most = turn, right = i;
    }
    for (const std::size_t side : {left, right}) svg.line(std::array{apex, rim[side]}, {blue, 0.2, false, 0.7});
  }
};

// 1, 2 or 5 times a power of ten, near and below x.
double round_below(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  return power * (x >= 5 * power ? 5 : x >= 2 * power ? 2 : 1);
}

std::string length_in_words(double metres) {
  if (metres >= 1) return fmt::format("{:.3g} m", metres);
  return metres >= 1e-3 ? fmt::format("{:.3g} mm", 1e3 * metres) : fmt::format("{:.3g} µm", 1e6 * metres);
}

std::string verdict_in_words(const GraspAnswer& answer, const GraspScene& scene) {
  constexpr std::array<std::string_view, 3> words{"holds", "cannot hold", "undecided"};
  if (answer.loads.empty()) return "";
  const GraspLoadAnswer& load = answer.loads.front();
  std::string text(words[static_cast<std::size_t>(load.verdict)]);
  if (load.verdict == Verdict::holds && !asks_of_no_load(scene.question)) {
    std::string name(grasp_questions[static_cast<std::size_t>(scene.question)]);
    std::ranges::replace(name, '_', ' ');
    const std::string_view unit = unit_of(scene.question);
    text += fmt::format(": {} {:.4g}{}{}", name, load.grip.value, unit == "1" ? "" : " ",
                        unit == "1"     ? ""
                        : unit == "N^2" ? "N²"
                                        : unit);
  }
  return text;
}

}  // namespace

std::string picture_of(const GraspAnswer& answer, const GraspScene& scene) {
  const std::vector<Contact> contacts = contacts_of(scene.contacts);
  Vector3 low = contacts.front().position(), high = low;
  Vector3 centroid = Vector3::Zero();
  for (const Contact& c : contacts) {
    low = low.cwiseMin(c.position());
    high = high.cwiseMax(c.position());
    centroid += c.position() / static_cast<double>(contacts.size());
  }
  low = low.cwiseMin(Vector3::Zero());
  high = high.cwiseMax(Vector3::Zero());
  const double extent = (high - low).norm() > 0 ? (high - low).norm() : scene.length;
  const double reach = 0.42 * extent;  // of the longest arrow
  Picture picture{View(scene.azimuth, scene.elevation)};
  picture.view.fit(to_point(low - Vector3::Constant(0.65 * reach)), to_point(high + Vector3::Constant(0.65 * reach)),
                   {6, 12}, width - 12, height - 34);
  Svg& svg = picture.svg;

  std::vector<Arrow> arrows;
  double largest_force = 0, largest_velocity = 0;
  const GraspLoadAnswer* const load = answer.loads.empty() ? nullptr : &answer.loads.front();
  const bool held = load != nullptr && load->verdict == Verdict::holds;
  std::vector<Vector3> forces, velocities;
  for (std::size_t i = 0; load != nullptr && i < contacts.size(); ++i) {
    const ContactAnswer& c = load->grip.contacts[i];
    const auto wrench = contacts[i].wrench(c.normal_force, c.friction);
    forces.push_back(held ? Vector3(wrench.head<3>()) : Vector3::Zero());
    const Vector3 v = load->grip.escape_twist.head<3>(), omega = load->grip.escape_twist.tail<3>();
    velocities.push_back(held && asks_of_closure(scene.question) ? Vector3::Zero()
                                                                 : Vector3(v + omega.cross(contacts[i].position())));
    largest_force = std::max(largest_force, forces.back().norm());
    largest_velocity = std::max(largest_velocity, velocities.back().norm());
  }
  const Vector3 load_force = load != nullptr ? Vector3(load->load.head<3>()) : Vector3::Zero();
  const Vector3 load_moment = load != nullptr ? Vector3(load->load.tail<3>() / scene.length) : Vector3::Zero();
  const bool loaded = load != nullptr && !asks_of_no_load(scene.question);
  if (loaded) largest_force = std::max({largest_force, load_force.norm(), load_moment.norm()});
  const double force_scale = largest_force > 0 ? reach / largest_force : 0;
  const double velocity_scale = largest_velocity > 0 ? 0.6 * reach / largest_velocity : 0;

  // What is farther away first.
  std::vector<std::size_t> order(contacts.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto& viewer = picture.view.towards_viewer();
  const Vector3 towards(viewer[0], viewer[1], viewer[2]);
  std::ranges::sort(order, {}, [&](std::size_t i) { return contacts[i].position().dot(towards); });
  for (const Contact& c : contacts) {
    svg.line(std::array{picture.spot(centroid), picture.spot(c.position())}, {grey, 0.15, true});
  }
  for (const std::size_t i : order) {
    if (contacts[i].cone().mu() > 0) picture.draw_cone(contacts[i], 0.36 * reach);
  }
  for (const std::size_t i : order) {
    const Vector3& at = contacts[i].position();
    if (load != nullptr) {
      picture.draw({at, at + velocity_scale * velocities[i], {green, 0.4, true}});
      picture.draw({at, at + force_scale * forces[i], {vermilion, 0.5}});
    }
    const Vector3 away = at + 0.16 * reach * contacts[i].normal();
    svg.circle(picture.spot(at), 0.8, white, {black, 0.3});
    svg.rimmed_number({picture.spot(away).x, picture.spot(away).y + 1}, fmt::format("{}", i + 1), 8, Anchor::middle);
  }
  if (loaded) {
    picture.draw({Vector3::Zero(), force_scale * load_force, {black, 0.5}});
    picture.draw({Vector3::Zero(), force_scale * load_moment, {blue, 0.5, true}});
    svg.circle(picture.spot(Vector3::Zero()), 0.6, black, {white, 0.15});
  }

  // A triad with its length, the scales, and what the colours mean.
  const double bar = round_below(0.25 * extent);
  const Vector3 corner = low - Vector3::Constant(0.65 * reach);
  constexpr std::array<std::string_view, 3> axes{"*x", "*y", "*z"};
  const Spot at_corner = picture.spot(corner);
  const double down = height - 26 - at_corner.y, left = 14 - at_corner.x;
  for (int k = 0; k < 3; ++k) {
    const Spot end = picture.spot(corner + bar * Vector3::Unit(k));
    const Spot a{at_corner.x + left, at_corner.y + down}, b{end.x + left, end.y + down};
    svg.line(std::array{a, b}, {black, 0.25});
    const double stretch = 2.2 / std::max(0.5, std::hypot(b.x - a.x, b.y - a.y));
    svg.label({b.x + stretch * (b.x - a.x), b.y + stretch * (b.y - a.y) + 1}, axes[static_cast<std::size_t>(k)], 8,
              Anchor::middle);
  }
  svg.text({6, height - 12}, "axes: " + length_in_words(bar), 8);
  if (!scene.title.empty()) svg.text({4, 6}, scene.title, 9);
  svg.text({4, 10.5}, verdict_in_words(answer, scene), 8);
  double x = 34, y = height - 16;
  const auto entry = [&](std::string_view words, const Colour& colour, bool dashed) {
    svg.line(std::array{Spot{x, y - 1}, Spot{x + 6, y - 1}}, {colour, 0.5, dashed});
    svg.text({x + 7.5, y}, words, 8);
    y += 4.4;
  };
  if (held) entry(fmt::format("forces on the object, the longest {:.3g} N", largest_force), vermilion, false);
  if (loaded && !load_force.isZero(0)) entry("load: force, on the same scale", black, false);
  if (loaded && !load_moment.isZero(0)) {
    entry(fmt::format("load: moment over {}", length_in_words(scene.length)), blue, true);
  }
  if (largest_velocity > 0) entry(held ? "how the object would escape" : "how the object escapes", green, true);
  return std::move(svg).finished();
}

}  // namespace patchgrip::cli
