#include <patchgrip/friction/polygon_rings.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace patchgrip::friction {
namespace {

using ::testing::ThrowsMessage;
using Ring = std::vector<Point>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const Ring square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

double area(const std::vector<kernels::Vertex>& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& p = ring[i];
    const auto& q = ring[(i + 1) % ring.size()];
    twice += p.x * q.y - q.x * p.y;
  }
  return twice / 2;
}

auto of(const Ring& outer, const std::vector<Ring>& holes = {}) {
  return [=] { oriented_rings(outer, holes); };
}
auto refused(const std::string& message) { return ThrowsMessage<std::invalid_argument>(message); }

TEST(OrientedRings, HaveTheInteriorToTheLeftHoweverTheyAreGiven) {
  const Ring hole = box(1, 1, 2, 3);
  for (const Ring& outer : {square, reversed(square)}) {
    for (const Ring& inner : {hole, reversed(hole)}) {
      const auto rings = oriented_rings(outer, {inner});
      ASSERT_EQ(rings.size(), 2U);
      EXPECT_EQ(area(rings[0]), 16);
      EXPECT_EQ(area(rings[1]), -2);
    }
  }
}

TEST(OrientedRings, KeepVerticesAsTheyAre) {
  const Ring uneven{{0.1, 0.2}, {1 / 3.0, 1e-17}, {0.7, 1e10}};
  const auto rings = oriented_rings(uneven, {});
  ASSERT_EQ(rings[0].size(), 3U);
  for (const Point& p : uneven) {
    EXPECT_TRUE(std::any_of(rings[0].begin(), rings[0].end(), [&](const auto& q) { return q.x == p.x && q.y == p.y; }));
  }
}

TEST(OrientedRings, AllowVerticesWithinASide) { EXPECT_NO_THROW(of({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}})()); }

TEST(OrientedRings, AllowSeveralDisjointHoles) {
  EXPECT_NO_THROW(of(square, {box(1, 1, 2, 2), box(3, 1, 3.5, 3), box(1, 3, 2, 3.5)})());
}

TEST(OrientedRings, RefuseFewerThanThreeVertices) {
  EXPECT_THAT(of({}), refused("vertices has 0 vertices: a ring needs at least 3"));
  EXPECT_THAT(of({{0, 0}, {1, 0}}), refused("vertices has 2 vertices: a ring needs at least 3"));
  EXPECT_THAT(of(square, {{{1, 1}}}), refused("holes[0] has 1 vertices: a ring needs at least 3"));
}

TEST(OrientedRings, RefuseCoordinatesThatAreNotFinite) {
  EXPECT_THAT(of({{0, 0}, {1, nan}, {0, 1}}),
              refused("vertices vertex 1 = [1.000000, nan]: coordinates must be finite"));
  EXPECT_THAT(of({{0, 0}, {1, 0}, {infinity, 1}}),
              refused("vertices vertex 2 = [inf, 1.000000]: coordinates must be finite"));
  EXPECT_THROW(of(square, {{{1, 1}, {2, 1}, {-infinity, 2}}})(), std::invalid_argument);
}

TEST(OrientedRings, RefuseEdgesWithoutLength) {
  EXPECT_THAT(of({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),
              refused("vertices vertices 1 and 2 coincide: each edge must have a length"));
  EXPECT_THAT(of({{0, 0}, {1, 0}, {0, 1}, {0, 0}}),
              refused("vertices vertices 3 and 0 coincide: each edge must have a length"));
}

TEST(OrientedRings, RefuseRingsThatCrossOrTouchThemselves) {
  const char* message = "vertices crosses or touches itself: the edges of a ring may meet only at common vertices";
  const Ring bow_tie{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  const Ring spike{{0, 0}, {4, 0}, {2, 0}, {2, 3}};
  const Ring eight{{0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}, {1, 1}, {0.5, 0.5}};
  const Ring vertex_on_edge{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}};
  EXPECT_THAT(of(bow_tie), refused(message));
  EXPECT_THAT(of(spike), refused(message));
  EXPECT_THAT(of(eight), refused(message));
  EXPECT_THAT(of(vertex_on_edge), refused(message));
}

TEST(OrientedRings, RefuseVerticesOnOneLine) {
  EXPECT_THROW(of({{0, 0}, {1, 1}, {2, 2}})(), std::invalid_argument);
  EXPECT_THROW(of({{0, 0}, {0.1, 0.1}, {0.3, 0.3}})(), std::invalid_argument);
}

// Decided by exact predicates: three points that are collinear but for the last bit are a triangle.
TEST(OrientedRings, AcceptAnAreaOfOneRounding) {
  EXPECT_NO_THROW(of({{0, 0}, {1, 1}, {2, std::nextafter(2, 3)}})());
  EXPECT_THROW(of({{0, 0}, {1, 1}, {2, 2}})(), std::invalid_argument);
}

TEST(OrientedRings, RefuseHolesThatLeaveOrTouchTheOuterRing) {
  const char* message = "holes[0] leaves or touches the outer ring: a hole must lie inside";
  EXPECT_THAT(of(square, {box(5, 5, 6, 6)}), refused(message));               // outside
  EXPECT_THAT(of(square, {box(3, 1, 5, 2)}), refused(message));               // across
  EXPECT_THAT(of(square, {box(0, 1, 2, 2)}), refused(message));               // along a side
  EXPECT_THAT(of(square, {{{0, 2}, {1, 1}, {1, 3}}}), refused(message));      // by a vertex on a side
  EXPECT_THAT(of(square, {{{0, 0}, {1, 0.5}, {0.5, 1}}}), refused(message));  // by a common vertex
  EXPECT_THAT(of(square, {box(-1, -1, 5, 5)}), refused(message));             // around
  EXPECT_THAT(of(square, {square}), refused(message));
}

TEST(OrientedRings, RefuseHolesThatMeet) {
  const char* message = "holes[1] meets holes[0]: holes must be disjoint";
  EXPECT_THAT(of(square, {box(1, 1, 2, 2), box(1.5, 1.5, 3, 3)}), refused(message));  // overlap
  EXPECT_THAT(of(square, {box(1, 1, 2, 2), box(2, 1, 3, 2)}), refused(message));      // common side
  EXPECT_THAT(of(square, {box(1, 1, 2, 2), box(2, 2, 3, 3)}), refused(message));      // common vertex
  EXPECT_THAT(of(square, {box(1, 1, 3, 3), box(1.5, 1.5, 2, 2)}), refused(message));  // one in the other
  EXPECT_THAT(of(square, {box(1.5, 1.5, 2, 2), box(1, 1, 3, 3)}), refused(message));
  EXPECT_THAT(of(square, {box(0.5, 0.5, 1, 1), box(1.5, 1.5, 2, 2), box(1.6, 1.6, 3, 3)}),
              refused("holes[2] meets holes[1]: holes must be disjoint"));
}

TEST(OrientedRings, RefuseAHoleThatCrossesItself) {
  EXPECT_THAT(of(square, {{{1, 1}, {2, 2}, {2, 1}, {1, 2}}}),
              refused("holes[0] crosses or touches itself: the edges of a ring may meet only at common vertices"));
}

}  // namespace
}  // namespace patchgrip::friction
