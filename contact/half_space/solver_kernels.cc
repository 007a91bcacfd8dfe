#include <patchgrip/contact/half_space/solver_kernels.h>
#include <patchgrip/contact/half_space/vector_clones.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace patchgrip::contact::kernels {

PATCHGRIP_VECTOR_CLONES Tally choose_set(std::size_t n, double add_gap, double approach, double least_gap,
                                         const double* __restrict gap, const double* __restrict p, double* __restrict g,
                                         double* __restrict on, double* __restrict r) noexcept {
  double changes = 0, size = 0, pressed_squares = 0, pressed = 0, squares = 0, heights = 0, height_squares = 0;
  double overlap = 0;
#pragma omp simd reduction(+ : changes, size, pressed_squares, pressed, squares, heights, height_squares) \
    reduction(max : overlap)
  for (std::size_t i = 0; i < n; ++i) {
    g[i] += add_gap * (gap[i] - approach);
    const double is_pressed = p[i] > 0 ? 1 : 0;
    const double is_on = g[i] < 0 ? 1 : is_pressed;
    const double height = is_on * (gap[i] - least_gap);
    changes += is_on != on[i] ? 1 : 0;
    on[i] = is_on;
    r[i] = -is_on * g[i];
    size += is_on;
    pressed += is_pressed;
    pressed_squares += is_pressed * g[i] * g[i];
    squares += r[i] * r[i];
    heights += height;
    height_squares += height * height;
    overlap = std::max(overlap, (is_pressed - 1) * g[i]);
  }
  return {{changes, size, pressed_squares, pressed, squares, heights, height_squares}, overlap};
}

PATCHGRIP_VECTOR_CLONES Tally project(std::size_t n, double shift, const double* __restrict uniform,
                                      const double* __restrict on, const double* __restrict g,
                                      double* __restrict z) noexcept {
  double sum = 0;
  if (shift == 0) {
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < n; ++i) {
      z[i] *= on[i];
      sum -= g[i] * z[i];
    }
  } else {
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < n; ++i) {
      z[i] = on[i] * z[i] - shift * uniform[i];
      sum -= g[i] * z[i];
    }
  }
  return {{sum}};
}

PATCHGRIP_VECTOR_CLONES void turn(std::size_t n, double beta, const double* __restrict z,
                                  double* __restrict d) noexcept {
  if (beta == 0) {
    std::copy_n(z, n, d);
    return;
  }
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) d[i] = z[i] + beta * d[i];
}

PATCHGRIP_VECTOR_CLONES Tally slopes(std::size_t n, const double* __restrict d, const double* __restrict g,
                                     const double* __restrict Kd) noexcept {
  double slope = 0, curvature = 0;
#pragma omp simd reduction(+ : slope, curvature)
  for (std::size_t i = 0; i < n; ++i) {
    slope -= d[i] * g[i];
    curvature += d[i] * Kd[i];
  }
  return {{slope, curvature}};
}

PATCHGRIP_VECTOR_CLONES Tally advance(std::size_t n, double length, double shift, const double* __restrict d,
                                      const double* __restrict on, double* __restrict p, double* __restrict g,
                                      double* __restrict Kd) noexcept {
  double squares = 0;
#pragma omp simd reduction(+ : squares)
  for (std::size_t i = 0; i < n; ++i) {
    p[i] += length * d[i];
    g[i] += length * Kd[i] + shift;
    Kd[i] = -on[i] * g[i];
    squares += Kd[i] * Kd[i];
  }
  return {{squares}};
}

PATCHGRIP_VECTOR_CLONES Tally cut(std::size_t n, double* __restrict p) noexcept {
  double negative = 0, sum = 0;
#pragma omp simd reduction(+ : negative, sum)
  for (std::size_t i = 0; i < n; ++i) {
    negative += p[i] < 0 ? 1 : 0;
    p[i] = p[i] < 0 ? 0 : p[i];
    sum += p[i];
  }
  return {{negative, sum}};
}

PATCHGRIP_VECTOR_CLONES double least(std::size_t n, const double* __restrict x) noexcept {
  constexpr std::size_t lanes = 32;
  std::array<double, lanes> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i + lanes <= n; i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) least[k] = x[i + k] < least[k] ? x[i + k] : least[k];
  }
  for (std::size_t i = n - n % lanes; i < n; ++i) least[0] = std::min(least[0], x[i]);
  return *std::ranges::min_element(least);
}

PATCHGRIP_VECTOR_CLONES bool within(std::size_t n, double most, const double* __restrict x) noexcept {
  double outside = 0;
#pragma omp simd reduction(+ : outside)
  for (std::size_t i = 0; i < n; ++i) outside += std::abs(x[i]) <= most ? 0 : 1;
  return outside == 0;
}

PATCHGRIP_VECTOR_CLONES Tally sum(std::size_t n, const double* __restrict p) noexcept {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) sum += p[i];
  return {{sum}};
}

PATCHGRIP_VECTOR_CLONES Tally masked_sum(std::size_t n, const double* __restrict on,
                                         const double* __restrict z) noexcept {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) sum += on[i] * z[i];
  return {{sum}};
}

PATCHGRIP_VECTOR_CLONES Tally mask(std::size_t n, const double* __restrict on, double* __restrict z) noexcept {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) {
    z[i] *= on[i];
    sum += z[i];
  }
  return {{sum}};
}

PATCHGRIP_VECTOR_CLONES Tally weighted_gap(std::size_t n, const double* __restrict p, const double* __restrict g,
                                           const double* __restrict gap) noexcept {
  double moment = 0, sum = 0;
#pragma omp simd reduction(+ : moment, sum)
  for (std::size_t i = 0; i < n; ++i) {
    moment += p[i] * (g[i] + gap[i]);
    sum += p[i];
  }
  return {{moment, sum}};
}

PATCHGRIP_VECTOR_CLONES void scale(std::size_t n, double factor, double* __restrict p) noexcept {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) p[i] *= factor;
}

}  // namespace patchgrip::contact::kernels
