#include <patchgrip/friction/kernels/far_field.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss.hpp>

#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/polygon_reference.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::friction::kernels {
namespace {

using patchgrip::testing::units_of_rounding;
using Rings = std::vector<std::vector<Vertex>>;

// Rings about c = 0, which need not be the centroid.
struct Shape {
  const char* name;
  Rings rings;
};

const std::vector<Shape> shapes = {
    {"square", {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}},
    {"l_shape", {{{-0.75, -0.75}, {1.25, -0.75}, {1.25, -0.25}, {-0.25, -0.25}, {-0.25, 1.25}, {-0.75, 1.25}}}},
    {"slender", {{{-3, -1.0625}, {3, 0.9375}, {3, 1.0625}, {-3, -0.9375}}}},
    {"frame",
     {{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}, {{-0.75, -0.25}, {-0.75, 0.375}, {0.75, 0.375}, {0.75, -0.25}}}},
};

std::vector<BoundarySample> samples(const Rings& rings, long double area) {
  using Gauss = boost::math::quadrature::gauss<long double, 12>;
  std::vector<BoundarySample> result;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const long double px = ring[i].x, py = ring[i].y;
      const long double ex = ring[(i + 1) % ring.size()].x - px, ey = ring[(i + 1) % ring.size()].y - py;
      for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
        for (const int side : {-1, 1}) {
          const long double t = (1 + side * Gauss::abscissa()[k]) / 2;
          result.push_back({px + t * ex, py + t * ey, (px * ey - py * ex) * Gauss::weights()[k] / 2 / area});
        }
      }
    }
  }
  return result;
}

struct Far {
  explicit Far(const Shape& shape) : exact(shape.rings) {
    for (const Vertex& p : shape.rings[0]) rho = std::max(rho, std::hypot(p.x, p.y));
    const auto m = exact.moments();
    field = FarField(samples(shape.rings, static_cast<long double>(exact.area())), rho, static_cast<long double>(m[0]),
                     static_cast<long double>(m[1]));
  }

  // The twist with A = rho w / V towards the angle phi.
  Twist twist(double A, double phi) const { return {std::cos(phi), std::sin(phi), A / rho}; }

  double rho = 0;
  PolygonReference exact;
  FarField field;
};

const std::vector<double> inverse_distances{1 / 6.0, -1 / 6.0, 0.1, -0.03, 1e-3, 1e-6, -1e-8, 0};
const std::vector<double> angles{0, 0.32175, 1.1, 2.5, -1.5707963};

TEST(FarField, ForceIsGoodToItsBoundAndMomentToThatOfItsTerms) {
  for (const Shape& shape : shapes) {
    const Far far(shape);
    for (const double A : inverse_distances) {
      for (const double phi : angles) {
        const Twist v = far.twist(A, phi);
        const BoundedWrench g = far.field.bounded_gradient(v);
        const Wrench50 exact = far.exact.gradient(v);
        const Real50 dx = g.value.fx - exact.fx, dy = g.value.fy - exact.fy;
        EXPECT_LE(sqrt(dx * dx + dy * dy), g.force_error) << shape.name << ' ' << A << ' ' << phi;
        EXPECT_LE(abs(g.value.m - exact.m), g.moment_error) << shape.name << ' ' << A << ' ' << phi;
        EXPECT_LE(g.force_error, 16 * 0x1p-53);
        const Wrench same = far.field.gradient(v);
        EXPECT_TRUE(same.fx == g.value.fx && same.fy == g.value.fy && same.m == g.value.m);
      }
    }
  }
}

// The price of a bound on the terms is small: the moment is relatively exact about the centroid, also of a slender
// patch.
TEST(FarField, MomentAboutTheCentroidIsRelativelyExact) {
  for (const Shape& shape : {shapes[0], shapes[2]}) {
    const Far far(shape);
    for (const double A : inverse_distances) {
      if (A == 0) continue;
      for (const double phi : angles) {
        const Twist v = far.twist(A, phi);
        const Wrench50 exact = far.exact.gradient(v);
        // Along a slender patch the moment is (b/a)^2 of what it is across.
        EXPECT_LE(units_of_rounding(far.field.gradient(v).m, exact.m), 200) << shape.name << ' ' << A << ' ' << phi;
      }
    }
  }
}

TEST(FarField, DissipationIsThePowerOfItsWrench) {
  for (const Shape& shape : shapes) {
    const Far far(shape);
    for (const double A : inverse_distances) {
      const Twist v = far.twist(A, 1.1);
      EXPECT_NEAR(far.field.dissipation(v), power(far.field.gradient(v), v), 8 * 0x1p-53);
    }
  }
}

TEST(FarField, ATranslationFeelsTheCentroidAlone) {
  for (const Shape& shape : shapes) {
    const Far far(shape);
    const auto m = far.exact.moments();
    const Wrench g = far.field.gradient({3, 4, 0});
    EXPECT_NEAR(g.fx, 0.6, 4 * 0x1p-53);
    EXPECT_NEAR(g.fy, 0.8, 4 * 0x1p-53);
    EXPECT_NEAR(g.m, static_cast<double>(m[0] * 0.8 - m[1] * 0.6), 4 * 0x1p-53 * far.rho) << shape.name;
  }
}

// D = V + w <x e_y - y e_x> + w^2 <(e . P)^2> / (2 V) + ..., e = v / V: about the centre of a 2 x 2 square <x^2> = 1/3.
TEST(FarField, SpinCurvatureOfATranslationIsTheSecondMomentAlongIt) {
  const Far far(shapes[0]);
  for (const double phi : angles) {
    const Hessian h = far.field.hessian({2 * std::cos(phi), 2 * std::sin(phi), 0});
    EXPECT_NEAR(h.ww, 1.0 / 6, 4 * 0x1p-53);
    EXPECT_NEAR(h.xx + h.yy, 0.5, 4 * 0x1p-53);
  }
}

TEST(FarField, HessianEqualsDifferencesOfTheExactGradient) {
  for (const Shape& shape : shapes) {
    const Far far(shape);
    const auto gradient = [&](const Real50& vx, const Real50& vy, const Real50& w) {
      return far.exact.gradient(vx, vy, w);
    };
    for (const double A : {1 / 6.0, -0.05, 1e-4, 0.0}) {
      for (const double phi : {0.32175, 2.5}) {
        const Twist v = far.twist(A, phi);
        const Hessian exact = hessian_by_differences(gradient, v, far.rho, 1e-8);
        EXPECT_LE(scaled_difference(far.field.hessian(v), exact, v, far.rho), 64 * 0x1p-53) << shape.name << ' ' << A;
        EXPECT_LE(along_itself(far.field.hessian(v), v, far.rho), 16 * 0x1p-53);
      }
    }
  }
}

TEST(FarField, ReachesFromSixRadiiToInfinity) {
  const Far far(shapes[0]);
  EXPECT_TRUE(far.field.reaches(6 * far.rho, 1));
  EXPECT_TRUE(far.field.reaches(6 * far.rho, -1));
  EXPECT_FALSE(far.field.reaches(std::nextafter(6 * far.rho, 0), 1));
  EXPECT_TRUE(far.field.reaches(1e-300, 0));
}

TEST(FarField, DoesNotDependOnTheSpeed) {
  const Far far(shapes[1]);
  const Twist v = far.twist(0.1, 0.7);
  const Wrench g = far.field.gradient(v);
  for (const double k : {0x1p-800, 0x1p800}) {
    const Wrench scaled = far.field.gradient({k * v.vx, k * v.vy, k * v.w});
    EXPECT_TRUE(scaled.fx == g.fx && scaled.fy == g.fy && scaled.m == g.m);
    EXPECT_EQ(far.field.dissipation({k * v.vx, k * v.vy, k * v.w}), k * far.field.dissipation(v));
  }
}

}  // namespace
}  // namespace patchgrip::friction::kernels
