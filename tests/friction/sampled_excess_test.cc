// Stribeck's excess of sampled pressures against other ways to the same number.
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/local_stribeck.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/tests/friction/sampled_cases.h>
#include <patchgrip/tests/friction/within_error.h>

namespace patchgrip::friction {
namespace {

using patchgrip::testing::cases;

double bump(double x, double y) { return 1 + std::sin(3 * x + 1) * std::cos(2 * y) + 0.3 * x; }

// Speeds of the patch from a thousandth of v_S to thirty of it.
template <class P>
Twist random_excess_twist(const P& patch, std::mt19937_64& engine) {
  const Twist v = random_motion(patch, engine);
  const PressureMoments s = patch.moments();
  const double size = std::hypot(v.vx - v.w * s.y, v.vy + v.w * s.x) + std::fabs(v.w) * patch.area_radius();
  const double k = log_uniform(engine, 1e-3, 30) / size;
  return {k * v.vx, k * v.vy, k * v.w};
}

// Triangles between the pole and the edges of each piece by points, in 64 bits: the area's own integral where the pole
// is a corner of every triangle, so that 1 / |u_P| is no trouble.
LocalExcess triangle_excess(const Long (&x)[3], const Long (&y)[3], const Long (&p)[3], const Twist& u) {
  const Long ax = x[1] - x[0], ay = y[1] - y[0], bx = x[2] - x[0], by = y[2] - y[0], area = ax * by - ay * bx;
  const Long gx = ((p[1] - p[0]) * by - (p[2] - p[0]) * ay) / area,
             gy = ((p[2] - p[0]) * ax - (p[1] - p[0]) * bx) / area;
  const Long X = u.w != 0 ? -u.vy / Long(u.w) : x[0], Y = u.w != 0 ? u.vx / Long(u.w) : y[0];
  const Long reach = std::hypot(ax, ay) + std::hypot(bx, by);
  const bool far = std::hypot(X - x[0], Y - y[0]) > 3 * reach;
  const Long ox = far ? x[0] : X, oy = far ? y[0] : Y;
  LocalExcess sum;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Long px = x[i] - ox, py = y[i] - oy, ex = x[j] - x[i], ey = y[j] - y[i], cross = px * ey - py * ex;
    if (cross == 0) continue;
    const Long foot = std::clamp(-(px * ex + py * ey) / (ex * ex + ey * ey), 0.0L, 1.0L);
    const auto on = [&](Long t) {
      return integral_of(
          [&](Long l, Long) {
            const Long dx = l * (px + t * ex), dy = l * (py + t * ey);
            const Long pressure = p[0] + gx * (ox + dx - x[0]) + gy * (oy + dy - y[0]);
            LocalExcess e;
            if (far) {
              e = excess_at(u, ox + dx, oy + dy);
            } else {
              const Long d = std::hypot(dx, dy), k = std::exp(-u.w * u.w * d * d) / d * (u.w < 0 ? -1 : 1);
              e = {-k * dy, k * dx, 0};
              e.m = (ox + dx) * e.fy - (oy + dy) * e.fx;
            }
            return cross * l * pressure * e;
          },
          0, 1);
    };
    sum = sum + integral_of([&](Long, Long to_foot) { return on(foot - to_foot); }, 0, foot) +
          integral_of([&](Long from_foot, Long) { return on(foot + from_foot); }, foot, 1);
  }
  return sum;
}

TEST(SampledExcess, OfAMeshIsWithinItsError) {
  std::mt19937_64 engine(20060311);
  for (int i = cases(1); i > 0; --i) {
    const Triangulation mesh = shaken_mesh(2, 1, 0.5, 0.2, engine);
    const std::vector<double> p = nodal(mesh, bump);
    const PressureMesh patch = PressureMesh::linear(mesh, p);
    const Twist u = random_excess_twist(patch, engine);
    LocalExcess sum;
    Long force = 0;
    for (const auto& t : mesh.triangles) {
      const Long x[] = {mesh.points[t[0]].x, mesh.points[t[1]].x, mesh.points[t[2]].x};
      const Long y[] = {mesh.points[t[0]].y, mesh.points[t[1]].y, mesh.points[t[2]].y};
      const Long q[] = {p[t[0]], p[t[1]], p[t[2]]};
      const Long area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]), sign = area < 0 ? -1 : 1;
      sum = sum + sign * triangle_excess(x, y, q, u);
      force += sign * area / 2 * (q[0] + q[1] + q[2]) / 3;
    }
    expect_within_error(stribeck_excess(patch, u), 1 / force * sum, 1, 1e-12, 1e-16);
  }
}

// Cells are rectangles: the grid is several of them.
TEST(SampledExcess, OfAGridIsTheSumOfItsCells) {
  std::mt19937_64 engine(20060312);
  for (int i = cases(10); i > 0; --i) {
    const PressureCells cells = sampled_cells(4, 3, 0.1, 0.2, -0.3, 0.4, bump);
    const PressureGrid patch = PressureGrid::exact(cells);
    const Twist u = random_excess_twist(patch, engine);
    BoundedWrench sum;
    double force = 0;
    for (const double p : cells.pressures) force += p;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double x = -0.3 + 0.1 * (static_cast<double>(k) + 0.5), y = 0.4 + 0.2 * (static_cast<double>(j) + 0.5);
        const auto [g, force_error, moment_error] = stribeck_excess(Placed(Rectangle::of_sides(0.1, 0.2), x, y), u);
        const double share = cells.pressures[4 * j + k] / force;
        sum.value = {sum.value.fx + share * g.fx, sum.value.fy + share * g.fy, sum.value.m + share * g.m};
        sum.force_error += share * force_error;
        sum.moment_error += share * moment_error;
      }
    }
    const BoundedWrench found = stribeck_excess(patch, u);
    EXPECT_LE(std::hypot(found.value.fx - sum.value.fx, found.value.fy - sum.value.fy),
              found.force_error + sum.force_error);
    EXPECT_LE(std::fabs(found.value.m - sum.value.m), found.moment_error + sum.moment_error);
    EXPECT_LE(found.force_error, 1e-12);
    EXPECT_LE(found.moment_error, 1e-12);
  }
}

// A uniform pressure on many cells in boxes of boxes is the rectangle; on triangles likewise.
TEST(SampledExcess, OfManyPiecesIsThatOfTheWhole) {
  std::mt19937_64 engine(20060313);
  const auto even = [](double, double) { return 2.0; };
  const Placed whole(Rectangle::of_sides(1, 0.5), 0.5, 0.25);
  const PressureGrid fine = PressureGrid::within(1e-12, sampled_cells(64, 40, 1. / 64, 0.5 / 40, 0, 0, even));
  const PressureGrid rough = PressureGrid::within(1e-4, sampled_cells(64, 40, 1. / 64, 0.5 / 40, 0, 0, even));
  const Triangulation mesh = shaken_mesh(16, 10, 0.5, 0, engine);
  const PressureMesh triangles = PressureMesh::constant_within(1e-12, mesh, std::vector<double>(320, 3.0));
  for (int i = cases(10); i > 0; --i) {
    const Twist u = random_excess_twist(fine, engine);
    const BoundedWrench exact = stribeck_excess(whole, u);
    const auto compare = [&](const auto& patch, double of_use) {
      const BoundedWrench found = stribeck_excess(patch, u);
      EXPECT_LE(std::hypot(found.value.fx - exact.value.fx, found.value.fy - exact.value.fy),
                found.force_error + exact.force_error);
      EXPECT_LE(std::fabs(found.value.m - exact.value.m), found.moment_error + exact.moment_error);
      EXPECT_LE(found.force_error, of_use);
      EXPECT_LE(found.moment_error, of_use);
    };
    compare(fine, 1e-10);
    compare(rough, 1e-2);
    compare(triangles, 1e-10);
  }
}

TEST(SampledExcess, OfASlowPatchIsTheGradient) {
  std::mt19937_64 engine(20060314);
  const PressureGrid patch = PressureGrid::within(1e-12, sampled_cells(40, 40, 0.025, 0.025, 3, 4, bump));
  for (int i = cases(10); i > 0; --i) {
    Twist u = random_excess_twist(patch, engine);
    u = {1e-11 * u.vx, 1e-11 * u.vy, 1e-11 * u.w};
    const BoundedWrench found = stribeck_excess(patch, u), exact = patch.bounded_gradient(u);
    EXPECT_LE(std::hypot(found.value.fx - exact.value.fx, found.value.fy - exact.value.fy),
              found.force_error + exact.force_error + 1e-18);
    EXPECT_LE(std::fabs(found.value.m - exact.value.m), found.moment_error + exact.moment_error + 1e-17);
  }
  const Wrench rest = stribeck_excess(patch, {}).value;
  EXPECT_TRUE(rest.fx == 0 && rest.fy == 0 && rest.m == 0);
}

}  // namespace
}  // namespace patchgrip::friction
