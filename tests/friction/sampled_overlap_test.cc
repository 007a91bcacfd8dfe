#include <patchgrip/friction/sampled/overlap.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/sampled/triangulate.h>
#include <patchgrip/tests/friction/sampled_cases.h>

namespace patchgrip::friction {
namespace {

double signed_area(const std::vector<Point>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    sum += (p.x * q.y - p.y * q.x) / 2;
  }
  return sum;
}

std::vector<Point> corners(const Triangulation& mesh, std::size_t index) {
  std::vector<Point> ring;
  for (const std::size_t i : mesh.triangles[index]) ring.push_back(mesh.points[i]);
  return ring;
}

// What is left of one triangle within the three half-planes of the other.
double common_area(const Triangulation& mesh, std::size_t one, std::size_t other) {
  std::vector<Point> rest = corners(mesh, one), edges = corners(mesh, other);
  const double turn = signed_area(edges) > 0 ? 1 : -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = edges[i], b = edges[(i + 1) % 3];
    const auto side = [&](const Point& p) { return turn * ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)); };
    std::vector<Point> kept;
    for (std::size_t k = 0; k < rest.size(); ++k) {
      const Point p = rest[k], q = rest[(k + 1) % rest.size()];
      const double s = side(p), t = side(q);
      if (s >= 0) kept.push_back(p);
      if ((s > 0 && t < 0) || (s < 0 && t > 0)) {
        kept.push_back({p.x + s / (s - t) * (q.x - p.x), p.y + s / (s - t) * (q.y - p.y)});
      }
    }
    rest = kept;
  }
  return std::fabs(signed_area(rest));
}

void add(Triangulation& mesh, const Triangulation& other, double x, double y, double size = 1) {
  const std::size_t before = mesh.points.size();
  for (const Point& p : other.points) mesh.points.push_back({x + size * p.x, y + size * p.y});
  for (const auto& t : other.triangles) mesh.triangles.push_back({before + t[0], before + t[1], before + t[2]});
}

Triangulation square(std::size_t n) {
  std::mt19937_64 engine(1);
  return shaken_mesh(n, n, 1, 0, engine);
}

// A ribbon around the origin, through `angle`.
Triangulation staircase(double angle, std::size_t steps) {
  Triangulation mesh;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double a = angle * static_cast<double>(i) / static_cast<double>(steps);
    mesh.points.push_back({std::cos(a), std::sin(a)});
    mesh.points.push_back({2 * std::cos(a), 2 * std::sin(a)});
    if (i > 0) {
      mesh.triangles.push_back({2 * i - 2, 2 * i - 1, 2 * i});
      mesh.triangles.push_back({2 * i - 1, 2 * i + 1, 2 * i});
    }
  }
  return mesh;
}

void expect_overlap(const Triangulation& mesh) {
  const auto found = overlapping_triangles(mesh);
  ASSERT_TRUE(found);
  EXPECT_LT(found->first, found->second);
  EXPECT_GT(common_area(mesh, found->first, found->second), 0);
}

// With its border held, a mesh covers its zone once exactly where no triangle is turned over.
TEST(Overlap, IsWhereAShakenMeshIsFolded) {
  std::mt19937_64 engine(11);
  int folded = 0, flat = 0;
  const int draws = testing::cases(2000);
  for (int draw = 0; draw < draws; ++draw) {
    const std::size_t nx = 2 + engine() % 9, ny = 2 + engine() % 9;
    Triangulation mesh = shaken_mesh(nx, ny, 1, 0, engine);
    const double shake = uniform(engine, 0, 1), size = log_uniform(engine, 1e-12, 1e12);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      Point& p = mesh.points[i];
      if (i % (nx + 1) != 0 && (i + 1) % (nx + 1) != 0 && i > nx && i + nx + 1 < mesh.points.size()) {
        p.x += uniform(engine, -shake, shake) / static_cast<double>(nx);
        p.y += uniform(engine, -shake, shake) / static_cast<double>(ny);
      }
      p = {size * p.x, size * p.y};
    }
    bool turned = false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      turned = turned || (i % 2 == 0 ? 1 : -1) * signed_area(corners(mesh, i)) < 0;  // every other one clockwise
    }
    const auto found = overlapping_triangles(mesh);
    ASSERT_EQ(found.has_value(), turned) << draw;
    if (found) {
      EXPECT_GT(common_area(mesh, found->first, found->second), 0);
    }
    ++(turned ? folded : flat);
  }
  EXPECT_GT(folded, draws / 5);
  EXPECT_GT(flat, draws / 5);
}

TEST(Overlap, IsInASecondSheet) {
  for (const Point& shift : std::vector<Point>{{0, 0}, {0.25, 0}, {0.5, 0.25}, {0.3, 0.7}, {0.999, 0.999}}) {
    Triangulation mesh = square(4);
    add(mesh, square(4), shift.x, shift.y);
    expect_overlap(mesh);
  }
  Triangulation island = square(1);
  add(island, square(3), 0.6, 0.6, 0.1);
  expect_overlap(island);
}

TEST(Overlap, IsInAStairThatTurnsTwice) {
  expect_overlap(staircase(2.1 * std::numbers::pi, 40));
  EXPECT_FALSE(overlapping_triangles(staircase(1.99 * std::numbers::pi, 40)));
}

TEST(Overlap, IsNotInPiecesThatTouch) {
  Triangulation mesh = square(4);
  add(mesh, square(3), 1, 0);
  add(mesh, square(4), -1, 1);
  add(mesh, square(2), 1, 1);
  EXPECT_FALSE(overlapping_triangles(mesh));
  EXPECT_FALSE(overlapping_triangles(triangulate({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{{1, 1}, {2, 1}, {2, 2}}}, 0.1)));
  EXPECT_FALSE(overlapping_triangles({}));
}

// The middle of an edge, in single precision and on the wrong side of it.
TEST(Overlap, ForgivesANodeThatIsRounded) {
  const Triangulation rounded{{{0, 0}, {1, 1. / 3}, {0, 1}, {1, 0}, {0.5, 1. / 6 + 3e-8}},
                              {{0, 1, 2}, {0, 3, 4}, {3, 1, 4}}};
  EXPECT_FALSE(overlapping_triangles(rounded));
  Triangulation wrong = rounded;
  wrong.points[4].y += 0.01;
  expect_overlap(wrong);
}

// A sliver on the x axis, 1 long, whose upper corner is `above` the axis, over a triangle below that reaches `up`.
Triangulation sliver(double above, double up) {
  return {{{0, 0}, {1, 0}, {0.5, above}, {0.5, -1}, {0, up}, {1, up}}, {{0, 1, 2}, {3, 5, 4}}};
}

// 1e-6 of the longest edge, sqrt(5) / 2, and 1e-3 of the least height.
TEST(Overlap, ForgivesADepthThatIsRounding) {
  const double edge = 1e-6 * std::sqrt(1.25);
  EXPECT_FALSE(overlapping_triangles(sliver(1e-4, 0.99 * edge)));
  expect_overlap(sliver(1e-4, 1.01 * edge));
  EXPECT_FALSE(overlapping_triangles(sliver(0.5, 0.99 * 0.5e-3)));
  expect_overlap(sliver(0.5, 1.01 * 0.5e-3));
}

// The square's lower half is a sliver below its diagonal and two triangles: the node of all three, rounded across.
TEST(Overlap, ForgivesASliverThatRoundingTurnsOver) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    const auto with = [&](double y) {
      Triangulation mesh{{{0, 0}, {1, 0}, {0.5, y}, {0.5, 0.5}, {0.5, -0.5}},
                         {{0, 1, 3}, {0, 2, 1}, {0, 4, 2}, {2, 4, 1}}};
      for (Point& p : mesh.points) p = {size * p.x, size * p.y};
      return mesh;
    };
    for (const double y : {-2e-8, 2e-8, 0.9e-6}) EXPECT_FALSE(overlapping_triangles(with(y))) << size << ' ' << y;
    for (const double y : {1.1e-6, 1e-3}) expect_overlap(with(y));
  }
}

TEST(Overlap, IsNotInAFanOfSlivers) {
  Triangulation fan{{{0, 0}}, {}};
  constexpr std::size_t count = 2000;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / count;
    fan.points.push_back({std::cos(angle), std::sin(angle)});
    fan.triangles.push_back({0, i + 1, 1 + (i + 1) % count});
  }
  EXPECT_FALSE(overlapping_triangles(fan));
  fan.points[7] = {-1, 0.5};
  expect_overlap(fan);
}

TEST(Overlap, LeavesOutTrianglesWithoutArea) {
  Triangulation mesh = square(2);
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({0, 4, 8});
  EXPECT_FALSE(overlapping_triangles(mesh));
}

}  // namespace
}  // namespace patchgrip::friction
