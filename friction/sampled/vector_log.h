// The natural logarithm without branches, so that a loop over it becomes vector instructions.
//
//     x = 2^k (1 + f),  sqrt(1/2) < 1 + f < sqrt(2),  s = f / (2 + f),   ln x = k ln 2 + 2 artanh s
//
// with the polynomial of FreeBSD's msun (e_log.c) for artanh.
//
// Domain   positive normal numbers.
// Error    < 1.5 units of 2^-53 of |ln x| (sampled_kernels_test.cc).
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace patchgrip::friction::kernels {

namespace detail {

inline constexpr double ln2_high = 0x1.62e42feep-1;  // the product with an exponent is exact
inline constexpr double ln2_low = 0x1.a39ef35793c76p-33;

struct Reduced {
  double k;
  double f;
};

[[gnu::always_inline]] inline Reduced reduced(double x) noexcept {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd;  // sqrt(1/2)
  constexpr std::uint64_t one = 0x3ff0000000000000;
  constexpr std::uint64_t two_52 = 0x4330000000000000;
  constexpr double bias = 0x1p52 + 1023;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) - root_half + one;
  const double k = std::bit_cast<double>(bits >> 52 | two_52) - bias;
  return {k, std::bit_cast<double>((bits & 0xfffffffffffff) + root_half) - 1};
}

// 2 artanh(s) = s (2 + R), |s| < 0.1716.
[[gnu::always_inline]] inline double artanh_rest(double s) noexcept {
  const double z = s * s;
  const double w = z * z;
  const double odd = z * (0.6666666666666735130 +
                          w * (0.2857142874366239149 + w * (0.1818357216161805012 + w * 0.1479819860511658591)));
  const double even = w * (0.3999999999940941908 + w * (0.2222219843214978396 + w * 0.1531383769920937332));
  return odd + even;
}

[[gnu::always_inline]] inline double logarithm(const Reduced& r, double s) noexcept {
  const double half = 0.5 * r.f * r.f;
  return r.k * ln2_high - ((half - (s * (half + artanh_rest(s)) + r.k * ln2_low)) - r.f);
}

}  // namespace detail

[[gnu::always_inline]] inline double vector_log(double x) noexcept {
  const detail::Reduced r = detail::reduced(x);
  return detail::logarithm(r, r.f / (2 + r.f));
}

struct TwoLogs {
  double of_x, of_y;
};

// Two for one division, which vector units are slowest at, and with the fewest operations: < 6 units.
[[gnu::always_inline]] inline TwoLogs vector_logs(double x, double y) noexcept {
  const detail::Reduced r = detail::reduced(x), q = detail::reduced(y);
  const double a = 2 + r.f, b = 2 + q.f;
  const double reciprocal = 1 / (a * b);
  const double s = r.f * (b * reciprocal), t = q.f * (a * reciprocal);
  return {r.k * std::numbers::ln2 + s * (2 + detail::artanh_rest(s)),
          q.k * std::numbers::ln2 + t * (2 + detail::artanh_rest(t))};
}

// ln x for x = (1 + z) / (1 - z): of small z it keeps all digits, where x - 1 has lost them.
[[gnu::always_inline]] inline double vector_log_of_ratio(double x, double z) noexcept {
  const detail::Reduced r = detail::reduced(x);
  const bool small = z < 0.125;
  const double s = small ? z : r.f / (2 + r.f);
  return small ? z * (2 + detail::artanh_rest(s)) : detail::logarithm(r, s);
}

}  // namespace patchgrip::friction::kernels
