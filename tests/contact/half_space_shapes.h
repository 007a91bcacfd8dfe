// Gaps with a known solution, and random ones, on E* = 1 Pa.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::contact {

using GapFunction = std::function<double(double, double)>;

// R = 1, at (x0, y0): a = 1 under F = 4/3 or delta = 1.
inline GapFunction paraboloid(double x0 = 0, double y0 = 0, double radius = 1) {
  return [=](double x, double y) { return ((x - x0) * (x - x0) + (y - y0) * (y - y0)) / (2 * radius); };
}

struct HertzEllipse {
  GapFunction gap;
  double approach, force, area;
};

// Semi-axes 1 and `ratio`, turned by `angle`, p_0 = 1: gap and approach from the potential of an ellipsoid (Johnson
// 3.65).
inline HertzEllipse hertz_ellipse(double ratio, double angle) {
  const double square = ratio * ratio;
  const double along = ratio / 3 * boost::math::ellint_rd(0., square, 1.);
  const double across = ratio / 3 * boost::math::ellint_rd(0., 1., square);
  const auto gap = [=](double x, double y) {
    const double u = std::cos(angle) * x + std::sin(angle) * y, v = std::cos(angle) * y - std::sin(angle) * x;
    return along * u * u + across * v * v;
  };
  return {gap, ratio * boost::math::ellint_rf(0., square, 1.), 2. / 3. * std::numbers::pi * ratio,
          std::numbers::pi * ratio};
}

// A self-affine surface, Hurst exponent 0.8, of random phases, periodic on a square of side 1.
inline std::vector<double> rough_surface(const Grid& grid, unsigned seed, double rms_slope) {
  std::mt19937_64 engine(seed);
  std::vector<double> heights(grid.size());
  double slopes = 0;
  for (int n = 0; n <= 8; ++n) {
    for (int m = -8; m <= 8; ++m) {
      const double q = std::hypot(m, n);
      if (q < 2 || q > 8 || (n == 0 && m < 0)) continue;
      const double amplitude = std::pow(q, -1.8), phase = patchgrip::testing::uniform(engine, 0, 2 * std::numbers::pi);
      slopes += std::pow(2 * std::numbers::pi * q * amplitude, 2) / 2;
      for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
          heights[grid.index(i, j)] +=
              amplitude * std::cos(2 * std::numbers::pi * (m * grid.x(i) + n * grid.y(j)) + phase);
        }
      }
    }
  }
  for (double& height : heights) height *= rms_slope / std::sqrt(slopes);
  return heights;
}

// The lower envelope of up to six paraboloids or quartics of very different widths, somewhere in |x|, |y| < 1.
inline GapFunction random_shape(std::mt19937_64& engine) {
  struct Blob {
    double x, y, along, across, height, angle;
    bool is_quartic;
  };
  std::vector<Blob> blobs;
  const auto draw = [&](double lo, double hi) { return patchgrip::testing::uniform(engine, lo, hi); };
  const int count = 1 + static_cast<int>(draw(0, 6));
  for (int k = 0; k < count; ++k) {
    blobs.push_back({draw(-1, 1), draw(-1, 1), std::pow(10, draw(-1.5, 1.5)), std::pow(10, draw(-1.5, 1.5)),
                     draw(0, 0.1), draw(0, std::numbers::pi), draw(0, 1) < 0.3});
  }
  return [blobs](double x, double y) {
    double least = 1e9;
    for (const Blob& b : blobs) {
      const double u = std::cos(b.angle) * (x - b.x) + std::sin(b.angle) * (y - b.y);
      const double v = std::cos(b.angle) * (y - b.y) - std::sin(b.angle) * (x - b.x);
      const double w = u * u * b.along + v * v * b.across;
      least = std::min(least, b.height + (b.is_quartic ? w * w : w));
    }
    return least;
  };
}

}  // namespace patchgrip::contact
