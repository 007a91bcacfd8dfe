#include <patchgrip/friction/sampled/corner_sums.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <patchgrip/friction/sampled/vector_log.h>

namespace patchgrip::friction::kernels {
namespace {

constexpr std::size_t chunk = 64;    // columns or rows whose logarithms are kept
constexpr double least = 0x1p-1000;  // added where a logarithm of 0 has the factor 0

// Coordinates about the pole, their signs, their sizes and the logarithms of these.
struct Lines {
  alignas(64) double at[chunk];
  alignas(64) double sign[chunk];
  alignas(64) double size[chunk];
  alignas(64) double log[chunk];
};

[[gnu::always_inline]] inline void fill(Lines& lines, const double* coordinates, std::size_t n, double pole) noexcept {
  for (std::size_t i = 0; i < n; ++i) {
    lines.at[i] = coordinates[i] - pole;
    lines.sign[i] = std::copysign(1.0, lines.at[i]);
    lines.size[i] = std::fabs(lines.at[i]) + least;
    lines.log[i] = vector_log(lines.size[i]);
  }
}

// sum c (b d + A), sum c (a d + B) and the latter times b: S is homogeneous, 3 S = -a S_x - b S_y.
struct Accumulated {
  alignas(64) double gx[chunk]{}, gy[chunk]{}, b_gy[chunk]{};
};

struct AccumulatedHessian {
  alignas(64) double xx[chunk]{}, xy[chunk]{}, yy[chunk]{};
};

[[gnu::always_inline]] inline double total(const double* values, std::size_t n) noexcept {
  return std::accumulate(values, values + n, 0.0);
}

template <Derivatives derivatives>
[[gnu::always_inline]] inline void sum(const CornerBlock& block, double X, double Y, DistanceSums& sums) noexcept {
  Lines columns, rows;
  for (std::size_t left = 0; left < block.columns; left += chunk) {
    const std::size_t width = std::min(chunk, block.columns - left);
    fill(columns, block.x + left, width, X);
    Accumulated sum;
    AccumulatedHessian second;
    for (std::size_t low = 0; low < block.rows; low += chunk) {
      const std::size_t height = std::min(chunk, block.rows - low);
      fill(rows, block.y + low, height, Y);
      for (std::size_t j = 0; j < height; ++j) {
        const CornerSpan span = block.spans[low + j];
        const std::size_t begin = std::max(span.begin, left) - left;
        const std::size_t end = std::clamp(span.end, left, left + width) - left;
        const double b = rows.at[j], bb = b * b, sign_b = rows.sign[j], size_b = rows.size[j], log_b = rows.log[j];
        const double* c = block.c + (low + j) * block.columns + left;
        for (std::size_t i = begin; i < end; ++i) {
          const double a = columns.at[i];
          const double aa = a * a;
          const double d = std::sqrt(aa + bb);
          const TwoLogs logs = vector_logs(size_b + d, columns.size[i] + d);
          const double along = sign_b * (logs.of_x - columns.log[i]);
          const double across = columns.sign[i] * (logs.of_y - log_b);
          const double x_term = c[i] * (b * d + aa * along);
          const double y_term = c[i] * (a * d + bb * across);
          sum.gx[i] += x_term;
          sum.gy[i] += y_term;
          sum.b_gy[i] += b * y_term;
          if constexpr (derivatives == Derivatives::second) {
            second.xx[i] += c[i] * a * along;
            second.xy[i] += c[i] * d;
            second.yy[i] += c[i] * b * across;
          }
        }
      }
    }
    sums.S += (std::inner_product(sum.gx, sum.gx + width, columns.at, 0.0) + total(sum.b_gy, width)) / 6;
    sums.gx -= total(sum.gx, width) / 2;
    sums.gy -= total(sum.gy, width) / 2;
    if constexpr (derivatives == Derivatives::second) {
      sums.xx += total(second.xx, width);
      sums.xy += total(second.xy, width);
      sums.yy += total(second.yy, width);
    }
  }
}

template <Derivatives derivatives>
void two(const CornerBlock& block, double X, double Y, DistanceSums& sums) noexcept {
  sum<derivatives>(block, X, Y, sums);
}

template <Derivatives derivatives>
PATCHGRIP_FOUR_LANES void four(const CornerBlock& block, double X, double Y, DistanceSums& sums) noexcept {
  sum<derivatives>(block, X, Y, sums);
}

template <Derivatives derivatives>
PATCHGRIP_EIGHT_LANES void eight(const CornerBlock& block, double X, double Y, DistanceSums& sums) noexcept {
  sum<derivatives>(block, X, Y, sums);
}

template <Derivatives derivatives>
CornerKernel choose(Lanes lanes) noexcept {
  return lanes == Lanes::eight ? eight<derivatives> : lanes == Lanes::four ? four<derivatives> : two<derivatives>;
}

}  // namespace

CornerKernel corner_kernel(Derivatives derivatives, Lanes lanes) noexcept {
  return derivatives == Derivatives::first ? choose<Derivatives::first>(lanes) : choose<Derivatives::second>(lanes);
}

}  // namespace patchgrip::friction::kernels
