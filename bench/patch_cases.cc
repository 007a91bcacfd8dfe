#include <patchgrip/bench/patch_cases.h>

#include <cmath>
#include <numbers>
#include <random>

#include <patchgrip/bench/poles.h>
#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>

namespace patchgrip::bench {
namespace {

constexpr double radius = 5e-3;       // m
constexpr std::size_t count = 65536;  // poles, too many for a branch predictor to learn
constexpr std::size_t judged = 1000;

using friction::Point;
using Outline = std::vector<Point>;
using SharedTwists = std::shared_ptr<const std::vector<friction::Twist>>;

SharedTwists share_twists(const PoleSet& poles) {
  return std::make_shared<const std::vector<friction::Twist>>(twists_about(poles));
}

// Counterclockwise, the vertices at 0.7 to 1 radii.
Outline star(std::size_t edges) {
  std::mt19937_64 random(edges);
  std::uniform_real_distribution<double> distance(0.7 * radius, radius);
  Outline outline;
  for (std::size_t i = 0; i < edges; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(edges) + 0.1;
    const double r = distance(random);
    outline.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return outline;
}

template <class P>
Case outline_case(const std::string& name, const P& patch, const Outline& outline, const PoleSet& poles) {
  const SharedTwists twists = share_twists(poles);
  const Truth truth = polygon_truth(outline, std::span(*twists).first(judged));
  return scalar_case({"exact", static_cast<double>(outline.size()), name, poles.mix}, std::make_shared<const P>(patch),
                     twists, truth, patch.area_radius());
}

// t / |h|: position along an edge over distance from it, for every pole and every end of an edge.
std::vector<double> edge_arguments(const Outline& outline, const PoleSet& poles) {
  std::vector<double> arguments;
  for (std::size_t i = 0; i < count / outline.size() / 2; ++i) {
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Point& p = outline[k];
      const Point& q = outline[(k + 1) % outline.size()];
      const double length = std::hypot(q.x - p.x, q.y - p.y);
      const double ex = (q.x - p.x) / length;
      const double ey = (q.y - p.y) / length;
      const double t0 = ex * (p.x - poles.x[i]) + ey * (p.y - poles.y[i]);
      const double h = std::fabs(ey * (p.x - poles.x[i]) - ex * (p.y - poles.y[i]));
      arguments.push_back(t0 / h);
      arguments.push_back((t0 + length) / h);
    }
  }
  return arguments;
}

Case asinh_case(const Outline& outline, const PoleSet& poles) {
  const auto arguments = std::make_shared<const std::vector<double>>(edge_arguments(outline, poles));
  return {{"asinh", static_cast<double>(outline.size()), "polygon", poles.mix}, {}, 0, arguments->size(), [arguments] {
            for (const double x : *arguments) {
              double y = std::asinh(x);
              benchmark::DoNotOptimize(y);
            }
          }};
}

}  // namespace

std::vector<Case> round_cases() {
  const PoleSet poles = mixed_poles(radius, count);
  const SharedTwists twists = share_twists(poles);
  const std::span few = std::span(*twists).first(judged);
  std::vector<Case> cases;
  const auto add = [&]<class P>(const std::string& name, const P& patch, const Truth& truth) {
    cases.push_back(
        scalar_case({"exact", 0, name, poles.mix}, std::make_shared<const P>(patch), twists, truth, radius));
  };
  add("flat_punch_disc", friction::FlatPunchDisc::of_radius(radius), power_disc_truth(radius, 0, few));
  add("uniform_disc", friction::UniformDisc::of_radius(radius), power_disc_truth(radius, 0.5, few));
  add("ring", friction::Ring::of_radius(radius), power_disc_truth(radius, -0.5, few));
  add("power_disc", friction::PowerDisc::of_radius(radius, 0.3), power_disc_truth(radius, 0.3, few));
  add("xydas_kao_disc", friction::XydasKaoDisc::of_radius(radius, 1.8), xydas_kao_truth(radius, 1.8, few.first(30)));
  return cases;
}

std::vector<Case> ellipse_cases() {
  std::vector<Case> cases;
  for (const double aspect : {2.0, 100.0}) {
    const double minor = radius / aspect;
    const auto patch =
        std::make_shared<const friction::HertzEllipse>(friction::HertzEllipse::of_semi_axes(radius, minor));
    PoleSet inside = inside_poles(radius, count);
    for (double& y : inside.y) y /= aspect;
    for (const PoleSet& poles :
         {mixed_poles(radius, count), near_poles(radius, count), outside_poles(radius, count), inside}) {
      const SharedTwists twists = share_twists(poles);
      const Truth truth = hertz_ellipse_truth(radius, minor, std::span(*twists).first(judged));
      cases.push_back(
          scalar_case({"exact", aspect, "hertz_ellipse", poles.mix}, patch, twists, truth, patch->area_radius()));
    }
  }
  return cases;
}

std::vector<Case> polygon_cases() {
  std::vector<Case> cases;
  for (const std::size_t edges : {3U, 8U, 64U}) {
    const Outline outline = star(edges);
    const PoleSet poles = box_poles(outline, count);
    cases.push_back(outline_case("polygon", friction::Polygon::uniform(outline), outline, poles));
    cases.push_back(asinh_case(outline, poles));
  }
  const double a = radius;
  const Outline outline{{-a, -a / 2}, {a, -a / 2}, {a, a / 2}, {-a, a / 2}};
  cases.push_back(
      outline_case("rectangle", friction::Rectangle::of_sides(2 * a, a), outline, box_poles(outline, count)));
  cases.push_back(outline_case("rectangle", friction::Rectangle::of_sides(2 * a, a), outline, mixed_poles(a, count)));
  return cases;
}

}  // namespace patchgrip::bench
