#include <patchgrip/friction/polygon.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/polygon_reference.h>
#include <patchgrip/tests/friction/shapes.h>

namespace patchgrip::friction {
namespace {

using ::testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// The centroid is formed in 113 bits: where it is 0 but for rounding that is what is left of it, in radii.
constexpr double rounding_of_moments = 1e-32;

double radius_of(const Shape& shape, const PressureMoments& s) {
  double radius = 0;
  for (const Point& p : shape.outer) radius = std::max(radius, std::hypot(p.x - s.x, p.y - s.y));
  return radius;
}

std::vector<Twist> about(const Pole& pole) { return {twist_about(pole, 1), twist_about(pole, -0.3)}; }

void append(std::vector<Twist>& twists, const std::vector<Twist>& more) {
  twists.insert(twists.end(), more.begin(), more.end());
}

// Poles inside and around, on vertices, on edges, a hair's breadth beside them, and in line with them.
std::vector<Twist> near_twists(const Shape& shape, const PressureMoments& s) {
  const double radius = radius_of(shape, s);
  std::vector<Twist> twists = about({s.x, s.y});
  for (const double r : {1e-12, 0.1, 0.5, 0.8, 1.1, 1.9})
    append(twists, about({s.x + r * radius * 0.6, s.y - r * radius * 0.8}));
  std::vector<PointRing> rings = shape.holes;
  rings.push_back(shape.outer);
  for (const PointRing& ring : rings) {
    for (std::size_t i = 0; i<ring.size(); i += ring.size()> 8 ? 5U : 1U) {
      const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      append(twists, about({p.x, p.y}));
      append(twists, about({p.x + 1e-13 * radius, p.y}));
      for (const double t : {0.5, 1.0 / 3, -0.5}) append(twists, about({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}));
      append(twists, about({(p.x + q.x) / 2 + 1e-13 * radius, (p.y + q.y) / 2 - 1e-13 * radius}));
    }
  }
  return twists;
}

std::vector<Twist> far_twists(const Shape& shape, const PressureMoments& s) {
  const double radius = radius_of(shape, s);
  std::vector<Twist> twists;
  for (const double angle : {0.0, 0.9, 2.3, -1.7}) {
    for (const double r : {2.0, 2.8, 3.2, 4.5, 5.999, 6.001, 10.0, 1e2, 1e4, 1e8}) {
      append(twists, about({s.x + r * radius * std::cos(angle), s.y + r * radius * std::sin(angle)}));
    }
    twists.push_back({std::cos(angle), std::sin(angle), 0});
  }
  return twists;
}

struct Errors {
  double force, moment;
};

Errors errors(const Wrench& g, const Wrench50& exact) {
  const Real50 dx = g.fx - exact.fx, dy = g.fy - exact.fy;
  return {static_cast<double>(sqrt(dx * dx + dy * dy)), static_cast<double>(abs(g.m - exact.m))};
}

class PolygonOf : public ::testing::TestWithParam<Shape> {
 protected:
  const Shape& shape() const { return GetParam(); }
  bool origin_within() const { return shape().name != "Away"; }
  bool within_aspect_100() const { return shape().name != "Slender1000"; }
};

INSTANTIATE_TEST_SUITE_P(, PolygonOf, ::testing::ValuesIn(all_shapes),
                         [](const auto& instance) { return instance.param.name; });

TEST_P(PolygonOf, ForceAndMomentAreGoodToTheScaleOfThePatchAndWithinTheirBounds) {
  const Polygon patch = shape().patch();
  const PolygonReference exact(shape().rings());
  std::vector<Twist> twists = near_twists(shape(), patch.moments());
  append(twists, far_twists(shape(), patch.moments()));
  const double a = patch.area_radius();
  double worst_force = 0, worst_moment = 0;
  for (const Twist& v : twists) {
    const BoundedWrench g = patch.bounded_gradient(v);
    const Errors e = errors(g.value, exact.gradient(v));
    EXPECT_LE(e.force, g.force_error) << v.vx << ' ' << v.vy << ' ' << v.w;
    EXPECT_LE(e.moment, g.moment_error) << v.vx << ' ' << v.vy << ' ' << v.w;
    const Wrench same = patch.gradient(v);
    EXPECT_TRUE(same.fx == g.value.fx && same.fy == g.value.fy && same.m == g.value.m);
    worst_force = std::max(worst_force, e.force);
    worst_moment = std::max(worst_moment, e.moment / a);
  }
  RecordProperty("worst_force", std::to_string(worst_force * 1e15) + "e-15");
  RecordProperty("worst_moment", std::to_string(worst_moment * 1e15) + "e-15");
  if (within_aspect_100() && origin_within()) {
    EXPECT_LE(worst_force, 1e-13);
    EXPECT_LE(worst_moment, 1e-13);
  }
}

TEST_P(PolygonOf, BoundsAreNotIdle) {
  const Polygon patch = shape().patch();
  const double a = patch.area_radius();
  const double lever = std::hypot(patch.moments().x, patch.moments().y);
  std::vector<Twist> twists = near_twists(shape(), patch.moments());
  append(twists, far_twists(shape(), patch.moments()));
  for (const Twist& v : twists) {
    const BoundedWrench g = patch.bounded_gradient(v);
    const double size = within_aspect_100() ? 1e-12 : 1e-11;
    EXPECT_LE(g.force_error, size);
    EXPECT_LE(g.moment_error, size * (a + lever)) << v.vx << ' ' << v.vy << ' ' << v.w;
  }
}

// About the centroid the moment of a far pole is small, and every digit of it is there.
TEST_P(PolygonOf, MomentOfAFarPoleIsRelativelyExact) {
  const PolygonReference given(shape().rings());
  const auto m = given.moments();
  // The same shape with the origin close to its centroid; what rounding moves the vertices by does not matter.
  Shape centred = shape();
  const auto centre = [&](PointRing& ring) {
    ring = moved(ring, -static_cast<double>(m[0]), -static_cast<double>(m[1]));
  };
  centre(centred.outer);
  for (PointRing& hole : centred.holes) centre(hole);
  const Polygon patch = centred.patch();
  const PolygonReference exact(centred.rings());
  for (const Twist& v : far_twists(centred, {0, 0, 0})) {
    // Beyond 1e6 radii what is left of the centroid outweighs the rest: a moment arm of 1e-17.
    if (std::fabs(v.w) * radius_of(centred, {0, 0, 0}) < 1e-6 * std::hypot(v.vx, v.vy)) continue;
    const Wrench50 reference = exact.gradient(v);
    const double relative = errors(patch.gradient(v), reference).moment / std::fabs(static_cast<double>(reference.m));
    EXPECT_LE(relative, within_aspect_100() ? 1e-12 : 1e-11) << v.vx << ' ' << v.vy << ' ' << v.w;
  }
}

TEST_P(PolygonOf, DissipationIsThePowerOfItsWrench) {
  const Polygon patch = shape().patch();
  const PolygonReference exact(shape().rings());
  std::vector<Twist> twists = near_twists(shape(), patch.moments());
  append(twists, far_twists(shape(), patch.moments()));
  for (const Twist& v : twists) {
    const Wrench50 g = exact.gradient(v);
    const double D = static_cast<double>(g.fx * v.vx + g.fy * v.vy + g.m * v.w);
    EXPECT_NEAR(patch.dissipation(v), D, (within_aspect_100() ? 1e-13 : 1e-12) * D);
  }
}

TEST_P(PolygonOf, MomentsAreThoseOfTheArea) {
  const PolygonReference exact(shape().rings());
  const auto m = exact.moments();
  const Polygon patch = shape().patch();
  const PressureMoments s = patch.moments();
  const auto tolerance = [radius = radius_of(shape(), s)](const Real50& x) {
    return 0x1p-52 * std::fabs(static_cast<double>(x)) + rounding_of_moments * radius;
  };
  EXPECT_NEAR(s.x, static_cast<double>(m[0]), tolerance(m[0]));
  EXPECT_NEAR(s.y, static_cast<double>(m[1]), tolerance(m[1]));
  EXPECT_DOUBLE_EQ(s.polar, static_cast<double>(m[2]));
  EXPECT_DOUBLE_EQ(patch.area_radius(), std::sqrt(static_cast<double>(exact.area()) / std::numbers::pi));
}

TEST_P(PolygonOf, HessianEqualsDifferencesOfTheExactGradient) {
  const Polygon patch = shape().patch();
  const PolygonReference exact(shape().rings());
  const PressureMoments s = patch.moments();
  const double radius = radius_of(shape(), s);
  const auto gradient = [&](const Real50& vx, const Real50& vy, const Real50& w) { return exact.gradient(vx, vy, w); };
  // Moments about a distant origin are larger: the scale is the lever.
  const double length = radius + std::hypot(s.x, s.y);
  double worst = 0;
  std::vector<Twist> twists{{0.6, -0.8, 0}};
  for (const double r : {0.07, 0.7, 1.5, 2.5, 4.5, 5.999, 6.001, 40.0, 1e6}) {
    twists.push_back(twist_about({s.x + r * radius * 0.28, s.y + r * radius * 0.96}, r == 0.7 ? -2 : 1));
  }
  for (const Twist& v : twists) {
    const Hessian reference = hessian_by_differences(gradient, v, length, v.w == 0 ? 1e-6 : 1e-10);
    const double size = scaled_size(reference, v, length);
    const double difference = scaled_difference(patch.hessian(v), reference, v, length) / size;
    EXPECT_LE(difference, within_aspect_100() ? 1e-13 : 1e-12) << v.vx << ' ' << v.vy << ' ' << v.w;
    worst = std::max(worst, difference);
  }
  RecordProperty("worst", std::to_string(worst * 1e15) + "e-15");
}

TEST_P(PolygonOf, HessianIsFlatAlongTheTwistAndNowhereConcave) {
  const Polygon patch = shape().patch();
  const PressureMoments s = patch.moments();
  const double length = radius_of(shape(), s) + std::hypot(s.x, s.y);
  std::vector<Twist> twists = near_twists(shape(), s);
  append(twists, far_twists(shape(), s));
  for (const Twist& v : twists) {
    const Hessian h = patch.hessian(v);
    const double size = scaled_size(h, v, length);
    EXPECT_TRUE(std::isfinite(size));
    EXPECT_LE(along_itself(h, v, length), 1e-14 * size) << v.vx << ' ' << v.vy << ' ' << v.w;
    EXPECT_GE(least_curvature(h, v, length), -1e-14 * size) << v.vx << ' ' << v.vy << ' ' << v.w;
  }
}

// Double, extended precision and the far field take turns between 0 and 6 radii: nobody can tell where.
TEST_P(PolygonOf, TheThreeWaysAgreeWhereTheyMeet) {
  const Polygon patch = shape().patch();
  const PolygonReference exact(shape().rings());
  const PressureMoments s = patch.moments();
  const double radius = radius_of(shape(), s);
  for (int i = 0; i < 40; ++i) {
    const double r = radius * (1.5 + 5 * i / 40.0);
    const Twist v = twist_about({s.x + r * std::cos(i), s.y + r * std::sin(i)}, 1);
    const BoundedWrench g = patch.bounded_gradient(v);
    const Errors e = errors(g.value, exact.gradient(v));
    EXPECT_LE(e.force, g.force_error) << r / radius;
    EXPECT_LE(e.moment, g.moment_error) << r / radius;
  }
}

// Along a slender patch the moment about its centroid falls by the square of the aspect ratio within an angle of its
// inverse.
TEST(Polygon, BoundsHoldAlongASlenderPatch) {
  struct Slender {
    const Shape& shape;
    double angle, aspect;
  };
  for (const Slender& slender : {Slender{slender_10, 0.3, 10}, {slender_100, 1.2, 100}, {slender_1000, -0.7, 1000}}) {
    const Polygon patch = slender.shape.patch();
    const PolygonReference exact(slender.shape.rings());
    for (const double off : {0.0, 0.01, 0.1, 0.5, 1.0, -3.0, 10.0}) {
      for (const double r : {2.5, 5.0, 6.001, 8.0, 1e3, 1e7}) {
        const double phi = slender.angle + off / slender.aspect;
        const Twist v = twist_about({r * std::cos(phi), r * std::sin(phi)}, 1);
        const BoundedWrench g = patch.bounded_gradient(v);
        const Errors e = errors(g.value, exact.gradient(v));
        EXPECT_LE(e.force, g.force_error) << slender.shape.name << ' ' << off << ' ' << r;
        EXPECT_LE(e.moment, g.moment_error) << slender.shape.name << ' ' << off << ' ' << r;
      }
    }
  }
}

// Two answers to the same question may differ by their bounds, no more.
void expect_same(const Polygon& a, const Polygon& b, const std::vector<Twist>& twists) {
  const double floor = rounding_of_moments * std::sqrt(a.moments().polar);
  for (const Twist& v : twists) {
    const BoundedWrench g = a.bounded_gradient(v), h = b.bounded_gradient(v);
    EXPECT_LE(std::hypot(g.value.fx - h.value.fx, g.value.fy - h.value.fy), g.force_error + h.force_error);
    EXPECT_LE(std::fabs(g.value.m - h.value.m), g.moment_error + h.moment_error + floor);
  }
}

TEST_P(PolygonOf, NeitherStartNorOrientationMatter) {
  const Polygon patch = shape().patch();
  std::vector<Twist> twists = near_twists(shape(), patch.moments());
  append(twists, far_twists(shape(), patch.moments()));
  Shape turned_round = shape();
  std::rotate(turned_round.outer.begin(), turned_round.outer.begin() + 2, turned_round.outer.end());
  std::reverse(turned_round.outer.begin(), turned_round.outer.end());
  for (PointRing& hole : turned_round.holes) std::reverse(hole.begin(), hole.end());
  std::reverse(turned_round.holes.begin(), turned_round.holes.end());
  expect_same(patch, turned_round.patch(), twists);
}

TEST(Polygon, AVertexWithinASideChangesNothing) {
  Shape split = l_shape;
  split.outer.insert(split.outer.begin() + 1, Point{0.5, -0.75});
  const Polygon patch = l_shape.patch();
  EXPECT_EQ(split.patch().edges(), patch.edges() + 1);
  std::vector<Twist> twists = near_twists(split, patch.moments());
  append(twists, far_twists(split, patch.moments()));
  expect_same(patch, split.patch(), twists);
}

// What adds up to one patch: areas with the sign they count by.
struct Part {
  double area;
  Polygon patch;
};

void expect_sum(const Polygon& whole, double area, const std::vector<Part>& parts, const std::vector<Twist>& twists) {
  for (const Twist& v : twists) {
    const BoundedWrench g = whole.bounded_gradient(v);
    Wrench sum;
    double force_error = g.force_error, moment_error = g.moment_error;
    for (const Part& part : parts) {
      const double share = part.area / area;
      const BoundedWrench h = part.patch.bounded_gradient(v);
      sum = {sum.fx + share * h.value.fx, sum.fy + share * h.value.fy, sum.m + share * h.value.m};
      force_error += std::fabs(share) * (h.force_error + 4 * 0x1p-53);  // and the rounding of this sum
      moment_error += std::fabs(share) * (h.moment_error + 4 * 0x1p-53 * std::fabs(h.value.m));
    }
    EXPECT_LE(std::hypot(g.value.fx - sum.fx, g.value.fy - sum.fy), force_error);
    EXPECT_LE(std::fabs(g.value.m - sum.m), moment_error);
  }
}

TEST(Polygon, IsTheSumOfTheTwoThatACutMakesOfIt) {
  const Polygon foot = Polygon::uniform(box(-0.75, -0.75, 1.25, -0.25));
  const Polygon stem = Polygon::uniform(box(-0.75, -0.25, -0.25, 1.25));
  std::vector<Twist> twists = near_twists(l_shape, l_shape.patch().moments());
  append(twists, far_twists(l_shape, l_shape.patch().moments()));
  expect_sum(l_shape.patch(), 1.75, {{1, foot}, {0.75, stem}}, twists);
}

TEST(Polygon, WithHolesIsTheOuterOneLessTheHoles) {
  const Polygon outer = Polygon::uniform(frame.outer);
  std::vector<Part> parts{{8, outer}};
  double area = 8;
  for (const PointRing& hole : frame.holes) {
    const double hole_area = (hole[1].x - hole[0].x) * (hole[2].y - hole[1].y);
    parts.push_back({-hole_area, Polygon::uniform(hole)});
    area -= hole_area;
  }
  std::vector<Twist> twists = near_twists(frame, frame.patch().moments());
  append(twists, far_twists(frame, frame.patch().moments()));
  expect_sum(frame.patch(), area, parts, twists);
}

TEST(Polygon, WithManySidesIsADisc) {
  // A regular n-gon of the disc's area differs from it by order 1/n^4 in S at the centre.
  const double pi = std::numbers::pi;
  const Polygon patch = Polygon::uniform(regular(400, std::sqrt(2 * pi / (400 * std::sin(2 * pi / 400)))));
  EXPECT_NEAR(patch.area_radius(), 1, 1e-14);
  EXPECT_NEAR(patch.gradient({0, 0, 1}).m, 2.0 / 3, 1e-8);
  const Wrench rim = patch.gradient(twist_about({0, 1}, 1));
  EXPECT_NEAR(rim.fx, 8 / (3 * pi), 1e-4);
}

TEST_P(PolygonOf, MovesWithItsVertices) {
  // Whole multiples of a power of two near the size: the vertices move without rounding where they are dyadic.
  const Polygon patch = shape().patch();
  const PressureMoments s = patch.moments();
  const double step = std::exp2(std::floor(std::log2(radius_of(shape(), s))));
  const PointRing outer = moved(shape().outer, 8 * step, -4 * step);
  std::vector<PointRing> holes;
  for (const PointRing& hole : shape().holes) holes.push_back(moved(hole, 8 * step, -4 * step));
  const Polygon there = Polygon::uniform(outer, holes);
  for (const Twist& v : near_twists(shape(), s)) {
    // The same motion of the patch: what it does to the origin of the moved patch's vertices.
    const Twist u{v.vx + v.w * -4 * step, v.vy - v.w * 8 * step, v.w};
    const Wrench g = patch.gradient(v), h = there.gradient(u);
    const double rounding = 64 * 0x1p-53 * (8 * step / patch.area_radius() + 1);
    EXPECT_LE(std::hypot(g.fx - h.fx, g.fy - h.fy), rounding * (origin_within() ? 1 : 1024));
    EXPECT_NEAR(h.m, g.m + 8 * step * h.fy + 4 * step * h.fx, rounding * 16 * step * (origin_within() ? 1 : 1 << 20));
  }
}

TEST_P(PolygonOf, SpeedScalesTheDissipationAndNothingElse) {
  const Polygon patch = shape().patch();
  const PressureMoments s = patch.moments();
  const double radius = radius_of(shape(), s);
  for (const double r : {0.3, 4.0, 50.0}) {
    const Twist v = twist_about({s.x + r * radius, s.y}, 1);
    const Wrench g = patch.gradient(v);
    for (const double k : {0x1p-664, 0x1p664}) {
      const Twist scaled_twist{k * v.vx, k * v.vy, k * v.w};
      const Wrench h = patch.gradient(scaled_twist);
      EXPECT_TRUE(h.fx == g.fx && h.fy == g.fy && h.m == g.m) << r;
      EXPECT_EQ(patch.dissipation(scaled_twist), k * patch.dissipation(v)) << r;
    }
  }
}

TEST_P(PolygonOf, AtRestItAnswersTheLeastSubgradientAndHasNoHessian) {
  const Polygon patch = shape().patch();
  const BoundedWrench g = patch.bounded_gradient({});
  EXPECT_TRUE(g.value.fx == 0 && g.value.fy == 0 && g.value.m == 0);
  EXPECT_EQ(patch.dissipation({}), 0);
  EXPECT_THAT([&] { patch.hessian({}); },
              ThrowsMessage<std::domain_error>("twist = 0 is not allowed: the Hessian of D exists only in motion"));
}

TEST_P(PolygonOf, NotANumberComesOutWhereItGoesIn) {
  const Polygon patch = shape().patch();
  for (const Twist& v : {Twist{nan, 1, 1}, Twist{1, nan, 1}, Twist{1, 1, nan}, Twist{nan, nan, nan}, Twist{nan, 0, 0},
                         Twist{infinity, 1, 1}, Twist{1, 1, infinity}}) {
    const Wrench g = patch.gradient(v);
    EXPECT_TRUE(std::isnan(g.fx) && std::isnan(g.fy) && std::isnan(g.m)) << v.vx << ' ' << v.vy << ' ' << v.w;
    EXPECT_TRUE(std::isnan(patch.dissipation(v)));
  }
}

TEST(Polygon, ExtremeSizesAreRefusedWhereTheirMomentsAreNotNumbers) {
  EXPECT_THROW(Polygon::uniform(scaled(l_ring, 1e-200)), std::invalid_argument);
  EXPECT_THROW(Polygon::uniform(scaled(l_ring, 1e200)), std::invalid_argument);
  EXPECT_NO_THROW(Polygon::uniform(scaled(l_ring, 1e-100)));
  EXPECT_NO_THROW(Polygon::uniform(scaled(l_ring, 1e100)));
}

TEST(Polygon, SizesScaleTheMomentAndNothingElse) {
  const Wrench g = l_shape.patch().gradient({0.3, -0.2, 1});
  for (const double k : {0x1p-300, 0x1p300}) {
    const Wrench h = Polygon::uniform(scaled(l_ring, k)).gradient({0.3, -0.2, 1 / k});
    EXPECT_TRUE(h.fx == g.fx && h.fy == g.fy && h.m == k * g.m);
  }
}

}  // namespace
}  // namespace patchgrip::friction
