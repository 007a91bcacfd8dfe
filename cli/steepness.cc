#include <patchgrip/cli/steepness.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <patchgrip/cli/scene/profile_of.h>

namespace patchgrip::cli {
namespace {

constexpr std::string_view beyond = "; slopes and strains of that order are outside the half-space theory";

double curvature(double radius) { return 1 / radius; }

double curvature_of_ball(const Shape& shape) {
  const auto* ball = std::get_if<Ball>(&shape);
  return ball == nullptr ? 0 : std::fabs(curvature(ball->radius));
}

// The largest slope of x^2 k_1 / 2 + y^2 k_2 / 2, turned by `turn` against the ellipse, on its edge: the norm of
// the matrix of curvature times diag(a, b).
double slope_at_edge(const CurvedSurface& surface, double angle, double a, double b) {
  const double c = std::cos(surface.direction - angle), s = std::sin(surface.direction - angle);
  const double k1 = curvature(surface.radii[0]), k2 = curvature(surface.radii[1]);
  const double along = k1 * c * c + k2 * s * s, across = k1 * s * s + k2 * c * c, mixed = (k1 - k2) * c * s;
  const double first = std::hypot(along * a, mixed * a), second = std::hypot(mixed * b, across * b);
  const double product = (along * a) * (mixed * b) + (mixed * a) * (across * b);
  const double sum = first * first + second * second, difference = first * first - second * second;
  return std::sqrt((sum + std::hypot(difference, 2 * product)) / 2);
}

}  // namespace

Steepness::Steepness(std::string name, double shown, double ratio, std::string_view of)
    : name_(std::move(name)), of_(of), shown_(shown), ratio_(ratio) {}

void Steepness::take_if_steeper(const Steepness& other) {
  constexpr double rounding = 1e-12;  // a ball on a plane has one radius
  if (other.ratio_ > (1 + rounding) * ratio_) *this = other;
}

Steepness Steepness::of_stamp(double a, double elastic_approach) {
  const double ratio = a > 0 ? elastic_approach / a : 0;
  return {"approach / contact radius", ratio, ratio};
}

Steepness Steepness::of_circle(const BodyPair& pair, double a, double elastic_approach) {
  const auto relative = relative_radius_of(pair);
  if (!relative) return of_stamp(a, elastic_approach);
  Steepness steepest{"a/R", a / *relative, a / *relative};
  const double first = a * curvature_of_ball(pair.first.shape), second = a * curvature_of_ball(pair.second.shape);
  steepest.take_if_steeper({"a/R", first, first, " of body A"});
  steepest.take_if_steeper({"a/R", second, second, " of body B"});
  return steepest;
}

Steepness Steepness::of_ellipse(const CurvedSurface& first, const CurvedSurface& second,
                                const contact::RelativeRadii& radii, double angle, double a, double b) {
  Steepness steepest{"b/R_small", b / radii.small, b / radii.small};
  const double of_first = slope_at_edge(first, angle, a, b), of_second = slope_at_edge(second, angle, a, b);
  steepest.take_if_steeper({"slope at the edge", of_first, of_first, " of body A"});
  steepest.take_if_steeper({"slope at the edge", of_second, of_second, " of body B"});
  return steepest;
}

Steepness Steepness::of_mesh(const contact::MeshContact& mesh, double a, double b) {
  const auto first = mesh.first.curvatures.radii(), second = mesh.second.curvatures.radii();
  return of_ellipse({{first.R1, first.R2}, 0}, {{second.R1, second.R2}, mesh.turn}, mesh.radii, mesh.radii.angle_a, a,
                    b);
}

Steepness Steepness::of_pressure(double peak_pressure, double contact_modulus) {
  const double strain = peak_pressure / contact_modulus;
  return {"peak pressure / E*", strain, std::numbers::pi / 2 * strain};
}

Steepness Steepness::of_cells(double highest_pressure, double contact_modulus) {
  Steepness result = of_pressure(highest_pressure, contact_modulus);
  result.name_ = "highest pressure of a cell / E*";
  return result;
}

std::string Steepness::text() const { return fmt::format("{} = {:.3g}{}", name_, shown_, of_); }

std::string Steepness::warning() const { return fmt::format("{} is not small{}", text(), beyond); }

}  // namespace patchgrip::cli
