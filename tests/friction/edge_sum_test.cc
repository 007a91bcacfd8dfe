#include <patchgrip/friction/kernels/edge_sum.h>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction::kernels {
namespace {

using Rings = std::vector<std::vector<Vertex>>;

const Rings triangle{{{0, 0}, {0.75, 0.125}, {0.25, 0.5}}};
const Rings l_shape{{{0, 0}, {2, 0}, {2, 0.5}, {0.5, 0.5}, {0.5, 2}, {0, 2}}};
const Rings square_with_hole{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
                             {{-0.25, -0.25}, {-0.25, 0.5}, {0.25, 0.5}, {0.25, -0.25}}};

double area_of(const Rings& rings) {
  double twice = 0;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex &p = ring[i], &q = ring[(i + 1) % ring.size()];
      twice += p.x * q.y - q.x * p.y;
    }
  }
  return twice / 2;
}

struct Integrals {
  long double S = 0, gx = 0, gy = 0, xx = 0, xy = 0, yy = 0;
};

// Polar coordinates about the pole, edge by edge: int |P - M| = sum int R(phi)^3 / 3 dphi with R the distance to the
// edge, its gradient -int R^2 / 2 (cos, sin), its Hessian int R (sin^2, -sin cos, cos^2). One-dimensional quadrature
// does the rest.
Integrals polar_quadrature(const Rings& rings, double X, double Y) {
  Integrals sum;
  boost::math::quadrature::tanh_sinh<long double> quadrature;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vertex &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const long double px = p.x - static_cast<long double>(X), py = p.y - static_cast<long double>(Y);
      const long double qx = q.x - static_cast<long double>(X), qy = q.y - static_cast<long double>(Y);
      const long double cross = px * qy - py * qx;
      if (cross == 0) continue;  // in line with the pole: no area
      const long double from = std::atan2(py, px);
      const long double angle = std::atan2(cross, px * qx + py * qy);
      const long double ex = qx - px, ey = qy - py;
      const auto integral = [&](const auto& f) {
        return angle * quadrature.integrate(
                           [&](long double t) {
                             const long double phi = from + t * angle;
                             const long double c = std::cos(phi), s = std::sin(phi);
                             const long double R = cross / (c * ey - s * ex);
                             return f(R, c, s);
                           },
                           0.0L, 1.0L);
      };
      sum.S += integral([](long double R, long double, long double) { return R * R * R / 3; });
      sum.gx -= integral([](long double R, long double c, long double) { return R * R / 2 * c; });
      sum.gy -= integral([](long double R, long double, long double s) { return R * R / 2 * s; });
      sum.xx += integral([](long double R, long double, long double s) { return R * s * s; });
      sum.xy -= integral([](long double R, long double c, long double s) { return R * c * s; });
      sum.yy += integral([](long double R, long double c, long double) { return R * c * c; });
    }
  }
  return sum;
}

template <class Real>
void expect_equal(const Rings& rings, double X, double Y, double tolerance) {
  const auto computed = edge_sum<Want::hessian>(make_boundary<Real>(rings), Real(X), Real(Y));
  const Integrals exact = polar_quadrature(rings, X, Y);
  const auto near = [&](const Real& value, long double expected) {
    EXPECT_NEAR(static_cast<double>(value), static_cast<double>(expected), tolerance)
        << "pole (" << X << ", " << Y << ')';
  };
  near(computed.S, exact.S);
  near(computed.gx, exact.gx);
  near(computed.gy, exact.gy);
  near(computed.xx, exact.xx);
  near(computed.xy, exact.xy);
  near(computed.yy, exact.yy);
}

TEST(EdgeSum, EqualsQuadratureAboutThePole) {
  for (const Rings& rings : {triangle, l_shape, square_with_hole}) {
    for (const Vertex& pole : {Vertex{0.3, 0.2}, {0.1, 0.4}, {-0.7, 0.3}, {1.2, 1.1}, {0.9, 0.03}}) {
      expect_equal<double>(rings, pole.x, pole.y, 3e-15);
    }
  }
}

TEST(EdgeSum, HoldsOnEdgesOnVerticesAndInLineWithEdges) {
  for (const Vertex& pole : {Vertex{2, 0}, {0.5, 0.5}, {1, 0}, {0.5, 1.25}, {0, 3}, {-1, 0.5}})
    expect_equal<double>(l_shape, pole.x, pole.y, 4e-15);
}

TEST(EdgeSum, HoldsAHairsBreadthOffAnEdge) {
  for (const double off : {1e-6, 1e-13, 1e-16, 1e-300}) {
    expect_equal<double>(square_with_hole, 0.3, -1 + off, 3e-15);
    expect_equal<double>(square_with_hole, 0.3, -1 - off, 3e-15);
    expect_equal<double>(l_shape, 1, off, 4e-15);
  }
}

// Far enough from the pole |P - M| is smooth over the patch, and a plain product rule over triangles integrates it.
TEST(EdgeSum, EqualsAnAreaQuadratureOfTheDefinitionOutsideThePatch) {
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  const Vertex pole{1.75, -1};
  double S = 0;
  for (std::size_t i = 0; i < l_shape[0].size(); ++i) {  // a fan of signed triangles about the origin
    const Vertex &p = l_shape[0][i], &q = l_shape[0][(i + 1) % l_shape[0].size()];
    const double cross = p.x * q.y - q.x * p.y;
    S += cross * Gauss::integrate(
                     [&](double s) {
                       return s * Gauss::integrate(
                                      [&](double t) {
                                        const double x = s * (p.x + t * (q.x - p.x));
                                        const double y = s * (p.y + t * (q.y - p.y));
                                        return std::hypot(x - pole.x, y - pole.y);
                                      },
                                      0.0, 1.0);
                     },
                     0.0, 1.0);
  }
  EXPECT_NEAR((edge_sum<Want::gradient>(make_boundary<double>(l_shape), pole.x, pole.y).S), S, 1e-13);
}

TEST(EdgeSum, OfAUnitSquareAboutItsCentreIsElementary) {
  const Rings square{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
  const auto sum = edge_sum<Want::hessian>(make_boundary<double>(square), 0.0, 0.0);
  const double L = std::asinh(1.0);
  EXPECT_NEAR(sum.S, (std::sqrt(2.0) + L) / 6, 4 * 0x1p-53);
  EXPECT_NEAR(sum.gx, 0, 0x1p-53);
  EXPECT_NEAR(sum.xx, 2 * L, 8 * 0x1p-53);
  EXPECT_NEAR(sum.xy, 0, 0x1p-53);
  EXPECT_NEAR(sum.yy, 2 * L, 8 * 0x1p-53);
}

TEST(EdgeSum, FarAwayTendsToAreaTimesDistance) {
  const auto sum = edge_sum<Want::gradient>(make_boundary<Real50>(l_shape), Real50(0), Real50(1e8));
  const double area = area_of(l_shape);
  EXPECT_NEAR(static_cast<double>(sum.gy) / area, 1, 1e-14);
  // S = r - y_c + ..., with the centroid of the L at (1 + 3/8) / (1 + 3/4) / 2.
  EXPECT_NEAR(static_cast<double>(sum.S / area - Real50(1e8)), -1.1875 / 1.75, 1e-7);
}

TEST(EdgeSum, TermsBoundTheirSums) {
  for (const Vertex& pole : {Vertex{0.3, 0.2}, {0.5, 0.5}, {40, -30}}) {
    const auto sum = edge_sum<Want::bound>(make_boundary<double>(l_shape), pole.x, pole.y);
    EXPECT_GE(sum.gradient_terms, std::hypot(sum.gx, sum.gy));
    EXPECT_GE(sum.S_terms, 3 * std::fabs(sum.S));
  }
}

// In 50 digits the plain difference of asinh is good enough to judge the single logarithm.
TEST(EdgeLogarithm, EqualsADifferenceOfInverseHyperbolicSines) {
  for (const double t0 : {-1e8, -3.0, -1e-9, 0.0, 1e-3, 2.0}) {
    for (const double length : {1e-7, 0.5, 1e3}) {
      for (const double h : {1e-12, 0.2, 50.0}) {
        const double t1 = t0 + length;
        const Real50 exact = asinh(Real50(t1) / h) - asinh(Real50(t0) / h);
        const double d0 = std::hypot(t0, h), d1 = std::hypot(t1, h);
        const double L = edge_logarithm(t0, d0, t1, d1, h * h);
        // The argument is good to a few units; where it is close to 1 its logarithm is good to as much absolutely.
        EXPECT_NEAR(L, static_cast<double>(exact), 8 * 0x1p-53 * std::max(1.0, std::fabs(L)))
            << t0 << ' ' << length << ' ' << h;
      }
    }
  }
}

TEST(Boundary, HasUnitNormalsThatPointOut) {
  const auto boundary = make_boundary<double>(square_with_hole);
  ASSERT_EQ(boundary.vertices.size(), 8U);
  ASSERT_EQ(boundary.ring_ends, (std::vector<std::size_t>{4, 8}));
  EXPECT_EQ(boundary.ny[0], -1);  // lower side of the square
  EXPECT_EQ(boundary.nx[1], 1);
  EXPECT_EQ(boundary.nx[4], 1);  // left side of the hole: out of the patch is into the hole
}

}  // namespace
}  // namespace patchgrip::friction::kernels
