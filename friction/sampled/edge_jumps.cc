#include <patchgrip/friction/sampled/edge_jumps.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <patchgrip/friction/sampled/vector_log.h>

namespace patchgrip::friction::kernels {
namespace {

constexpr std::size_t chunk = 64;
constexpr double least = 0x1p-1000;  // instead of 0 in a logarithm whose factor is 0

struct Terms {
  alignas(64) double S[chunk], gx[chunk], gy[chunk];
};

struct SecondTerms {
  alignas(64) double xx[chunk], xy[chunk], yy[chunk];
};

[[gnu::always_inline]] inline double total(const double* values, std::size_t n) noexcept {
  return std::accumulate(values, values + n, 0.0);
}

template <Derivatives derivatives>
[[gnu::always_inline]] inline void terms(const EdgeJumps& edges, std::size_t first, std::size_t n, double X, double Y,
                                         Terms& sum, SecondTerms& second) noexcept {
  const double* x = edges.x.data() + first;
  const double* y = edges.y.data() + first;
  const double* nx = edges.nx.data() + first;
  const double* ny = edges.ny.data() + first;
  const double* length = edges.length.data() + first;
  const double* jump = edges.jump.data() + first;
  const double* gn = edges.gn.data() + first;
  const double* gt = edges.gt.data() + first;
  for (std::size_t i = 0; i < n; ++i) {
    const double px = x[i] - X, py = y[i] - Y, l = length[i];
    const double h = nx[i] * px + ny[i] * py;
    const double t0 = nx[i] * py - ny[i] * px;
    const double t1 = t0 + l;
    const double h2 = h * h;
    const double d0 = std::sqrt(h2 + t0 * t0);
    const double d1 = std::sqrt(h2 + t1 * t1);
    const double both = d0 + d1;
    const double inverse = 1 / both;
    const double step = l * (t0 + t1) * inverse;  // d1 - d0
    // ln (d + |t|) of the ends: their difference on one side of the foot, their sum on both.
    const double u0 = std::max(std::fabs(t0) + d0, least);
    const double u1 = std::max(std::fabs(t1) + d1, least);
    const bool astride = t0 * t1 < 0;
    const bool rising = t0 + t1 > 0;
    const double over = astride ? u0 * u1 : rising ? u1 : u0;
    const double under = astride ? std::max(h2, least) : rising ? u0 : u1;
    const double L = vector_log_of_ratio(over / under, l * inverse);
    const double h2L = h2 * L;
    const double tt = (t0 + t1) * step;
    const double J1 = (l * both + tt + 2 * h2L) / 4;
    const double cubes = step * (d0 * d0 + d0 * d1 + d1 * d1);  // d1^3 - d0^3
    const double J3 = (l * (d0 * d0 * d0 + d1 * d1 * d1) + (t0 + t1) * cubes) / 8 + 0.75 * h2 * J1;
    const double K1 = cubes / 3;
    const double f = jump[i] - gt[i] * t0;
    const double pM = f - h * gn[i];
    const double hJ = h * J1 / 3;
    const double normal = gn[i] * hJ - (f * J1 + gt[i] * K1);
    const double tangential = gt[i] * hJ;
    sum.S[i] = (pM * h * J1 + gn[i] * J3) / 3;
    sum.gx[i] = normal * nx[i] - tangential * ny[i];
    sum.gy[i] = normal * ny[i] + tangential * nx[i];
    if constexpr (derivatives == Derivatives::second) {
      const double M2 = (l * both + tt - 2 * h2L) / 4;
      // In normal and tangent: q n^T - n J1 g^T, its antisymmetric part vanishes in the sum.
      const double nn = f * h * L + gt[i] * h * step - J1 * gn[i];
      const double nt = (f * step + gt[i] * M2 - J1 * gt[i]) / 2;
      const double cc = nx[i] * nx[i], ss = ny[i] * ny[i], cs = nx[i] * ny[i];
      second.xx[i] = nn * cc - 2 * nt * cs;
      second.xy[i] = nn * cs + nt * (cc - ss);
      second.yy[i] = nn * ss + 2 * nt * cs;
    }
  }
}

template <Derivatives derivatives>
[[gnu::always_inline]] inline void sum(const EdgeJumps& edges, std::size_t first, std::size_t last, double X, double Y,
                                       DistanceSums& sums) noexcept {
  Terms sum;
  SecondTerms second;
  for (; first < last; first += chunk) {
    const std::size_t n = std::min(chunk, last - first);
    terms<derivatives>(edges, first, n, X, Y, sum, second);
    sums.S += total(sum.S, n);
    sums.gx += total(sum.gx, n);
    sums.gy += total(sum.gy, n);
    if constexpr (derivatives == Derivatives::second) {
      sums.xx += total(second.xx, n);
      sums.xy += total(second.xy, n);
      sums.yy += total(second.yy, n);
    }
  }
}

template <Derivatives derivatives>
void two(const EdgeJumps& edges, std::size_t first, std::size_t last, double X, double Y, DistanceSums& sums) noexcept {
  sum<derivatives>(edges, first, last, X, Y, sums);
}

template <Derivatives derivatives>
PATCHGRIP_FOUR_LANES void four(const EdgeJumps& edges, std::size_t first, std::size_t last, double X, double Y,
                               DistanceSums& sums) noexcept {
  sum<derivatives>(edges, first, last, X, Y, sums);
}

template <Derivatives derivatives>
PATCHGRIP_EIGHT_LANES void eight(const EdgeJumps& edges, std::size_t first, std::size_t last, double X, double Y,
                                 DistanceSums& sums) noexcept {
  sum<derivatives>(edges, first, last, X, Y, sums);
}

template <Derivatives derivatives>
EdgeKernel choose(Lanes lanes) noexcept {
  return lanes == Lanes::eight ? eight<derivatives> : lanes == Lanes::four ? four<derivatives> : two<derivatives>;
}

}  // namespace

void EdgeJumps::add(double x0, double y0, double x1, double y1, double jump_at_start, double normal_slope,
                    double tangential_slope) {
  const double ex = x1 - x0, ey = y1 - y0;
  const double l = std::hypot(ex, ey);
  x.push_back(x0);
  y.push_back(y0);
  nx.push_back(ey / l);
  ny.push_back(-ex / l);
  length.push_back(l);
  jump.push_back(jump_at_start);
  gn.push_back(normal_slope);
  gt.push_back(tangential_slope);
}

void EdgeJumps::pad() {
  const double x0 = x.empty() ? 0 : x.back();
  const double y0 = y.empty() ? 0 : y.back();
  while (size() % 8 != 0) add(x0, y0, x0 + 1, y0, 0, 0, 0);
}

EdgeKernel edge_kernel(Derivatives derivatives, Lanes lanes) noexcept {
  return derivatives == Derivatives::first ? choose<Derivatives::first>(lanes) : choose<Derivatives::second>(lanes);
}

}  // namespace patchgrip::friction::kernels
