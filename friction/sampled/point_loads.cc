#include <patchgrip/friction/sampled/point_loads.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace patchgrip::friction::kernels {
namespace {

template <std::size_t N>
const std::array<double, N>& points() noexcept {
  static const std::array<double, N> all = [] {
    std::array<double, N> t;
    for (std::size_t i = 0; i < N; ++i) {
      t[i] = static_cast<double>(
          std::cos(std::numbers::pi_v<long double> * (2 * static_cast<long double>(i) + 1) / (2 * N)));
    }
    return t;
  }();
  return all;
}

template <std::size_t N>
[[gnu::always_inline]] inline double total(const double (&values)[N]) noexcept {
  return std::accumulate(values, values + N, 0.0);
}

// Of every column x_i: a = v_y there.
template <std::size_t N>
struct Columns {
  [[gnu::always_inline]] Columns(const Box& box, const Twist& v) noexcept {
    const std::array<double, N>& t = points<N>();
    for (std::size_t i = 0; i < N; ++i) {
      x[i] = box.x + box.hx * t[i];
      a[i] = v.vy + v.w * x[i];
      aa[i] = a[i] * a[i];
    }
  }
  alignas(64) double x[N], a[N], aa[N];
};

template <std::size_t N>
[[gnu::always_inline]] inline void add_gradient(const double* loads, const Box& box, const Twist& v,
                                                LoadSums& sums) noexcept {
  const Columns<N> column(box, v);
  alignas(64) double K[N]{}, B[N]{}, M[N]{};
  for (std::size_t j = 0; j < N; ++j) {
    const double y = box.y + box.hy * points<N>()[j];
    const double b = v.vx - v.w * y;
    const double bb = b * b, yb = y * b;
    const double* q = loads + j * N;
    for (std::size_t i = 0; i < N; ++i) {
      const double k = q[i] / std::sqrt(column.aa[i] + bb);
      K[i] += k;
      B[i] += k * b;
      M[i] += k * yb;
    }
  }
  for (std::size_t i = 0; i < N; ++i) {
    K[i] *= column.a[i];
    M[i] = K[i] * column.x[i] - M[i];
  }
  sums.gradient.fx += total(B);
  sums.gradient.fy += total(K);
  sums.gradient.m += total(M);
}

template <std::size_t N>
[[gnu::always_inline]] inline void add_hessian(const double* loads, const Box& box, const Twist& v,
                                               LoadSums& sums) noexcept {
  const Columns<N> column(box, v);
  alignas(64) double P0[N]{}, P1[N]{}, P2[N]{}, Q0[N]{}, Q1[N]{}, R[N]{};
  for (std::size_t j = 0; j < N; ++j) {
    const double y = box.y + box.hy * points<N>()[j];
    const double b = v.vx - v.w * y;
    const double bb = b * b, yb = y * b, yy = y * y;
    const double* q = loads + j * N;
    for (std::size_t i = 0; i < N; ++i) {
      const double z = column.aa[i] + bb;
      const double k = q[i] / (z * std::sqrt(z));
      P0[i] += k;
      P1[i] += k * b;
      P2[i] += k * bb;
      Q0[i] += k * y;
      Q1[i] += k * yb;
      R[i] += k * yy;
    }
  }
  Hessian& h = sums.hessian;
  for (std::size_t i = 0; i < N; ++i) {
    const double x = column.x[i], a = column.a[i], aa = column.aa[i];
    h.xx += aa * P0[i];
    h.xy -= a * P1[i];
    h.xw -= a * (a * Q0[i] + x * P1[i]);
    h.yy += P2[i];
    h.yw += a * Q1[i] + x * P2[i];
    h.ww += aa * R[i] + x * (2 * a * Q1[i] + x * P2[i]);
  }
}

template <std::size_t N>
LoadKernels baseline() noexcept {
  return {[](const double* q, const Box& box, const Twist& v, LoadSums& s) noexcept { add_gradient<N>(q, box, v, s); },
          [](const double* q, const Box& box, const Twist& v, LoadSums& s) noexcept { add_hessian<N>(q, box, v, s); }};
}

template <std::size_t N>
PATCHGRIP_FOUR_LANES void gradient_four(const double* q, const Box& box, const Twist& v, LoadSums& s) noexcept {
  add_gradient<N>(q, box, v, s);
}
template <std::size_t N>
PATCHGRIP_FOUR_LANES void hessian_four(const double* q, const Box& box, const Twist& v, LoadSums& s) noexcept {
  add_hessian<N>(q, box, v, s);
}
template <std::size_t N>
PATCHGRIP_EIGHT_LANES void gradient_eight(const double* q, const Box& box, const Twist& v, LoadSums& s) noexcept {
  add_gradient<N>(q, box, v, s);
}
template <std::size_t N>
PATCHGRIP_EIGHT_LANES void hessian_eight(const double* q, const Box& box, const Twist& v, LoadSums& s) noexcept {
  add_hessian<N>(q, box, v, s);
}

template <std::size_t N>
LoadKernels choose(Lanes lanes) noexcept {
  switch (lanes) {
    case Lanes::eight:
      return {gradient_eight<N>, hessian_eight<N>};
    case Lanes::four:
      return {gradient_four<N>, hessian_four<N>};
    case Lanes::two:
      break;
  }
  return baseline<N>();
}

}  // namespace

LoadKernels load_kernels(int order, Lanes lanes) noexcept {
  return order == 8 ? choose<8>(lanes) : order == 16 ? choose<16>(lanes) : choose<24>(lanes);
}

std::span<const double> load_points(int order) noexcept {
  if (order == 8) return points<8>();
  if (order == 16) return points<16>();
  return points<24>();
}

double load_error(int order, double R) noexcept { return 4 * R / 3 * std::pow(R + std::sqrt(R * R - 1), -order); }

double load_reach(int order, double tolerance) noexcept {
  // R + sqrt(R^2 - 1) = rho; each step brings R nearer by a factor of the order.
  double R = 1.5;
  for (int i = 0; i < 20; ++i) {
    const double rho = std::pow(4 * R / (3 * tolerance), 1.0 / order);
    R = std::max(1.5, (rho + 1 / rho) / 2);
  }
  return R;
}

LoadRule load_rule(double tolerance) noexcept {
  constexpr double rounding = 0x1p-54;
  const double kept = std::max(tolerance, rounding);
  // As few points as keep the reach short.
  const int order = kept >= 1e-5 ? 8 : kept >= 1e-10 ? 16 : 24;
  return {order, load_reach(order, kept), kept};
}

void lagrange(int order, double t, std::span<double> values) noexcept {
  const auto nodes = load_points(order);
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (t == nodes[i]) {
      std::ranges::fill(values, 0);
      values[i] = 1;
      return;
    }
    // Barycentric weights of Chebyshev's points of the first kind.
    const double weight = std::sqrt((1 - nodes[i]) * (1 + nodes[i])) * (i % 2 == 0 ? 1 : -1);
    sum += values[i] = weight / (t - nodes[i]);
  }
  for (double& value : values) value /= sum;
}

}  // namespace patchgrip::friction::kernels
