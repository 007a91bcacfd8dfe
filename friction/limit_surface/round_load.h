// A load as a round limit surface of radius a sees it: F^2 and |M| / a about its centre, in a range where squares can
// be formed.
//
// Domain   every load; one that is not finite has a gauge that is not a number.
// Units    load [N], [N], [N m] about the centre; radius [m]; F^2 [N^2], |M| / a [N]; gauge [N].
// Error    2 units of 2^-53 in F^2, one in |M| / a; scaling adds none (scaled_load.h).
// Throws   nothing.
#pragma once

#include <algorithm>
#include <cmath>

#include <patchgrip/friction/kernels/hertz_gauge.h>
#include <patchgrip/friction/limit_surface/gauge.h>
#include <patchgrip/friction/limit_surface/scaled_load.h>

namespace patchgrip::friction {

struct GaugeAndTwist {
  double value = 0;
  Twist twist;
};

inline kernels::HertzLoad round_load(const Wrench& t, double radius) noexcept {
  return {t.fx * t.fx + t.fy * t.fy, std::fabs(t.m) / radius};
}

// Neither squares nor what is divided by them over- or underflows.
inline bool in_range(const kernels::HertzLoad& t) noexcept {
  const double size = std::max(t.F2, t.M * t.M);
  return size > 0x1p-900 && size < 0x1p900;
}

// `gauge` of a load out of range, by scaling it.
template <class Function>
[[gnu::noinline]] double of_rescaled_load(const Wrench& load, double radius, const Function& gauge) noexcept {
  if (const auto known = trivial_gauge(load)) return known->value;
  const ScaledLoad scaled(load, radius);
  return scaled.back(gauge(round_load(scaled.load, radius)));
}

template <class Function>
double of_round_load(const Wrench& load, double radius, const Function& gauge) noexcept {
  const kernels::HertzLoad t = round_load(load, radius);
  if (!in_range(t)) [[unlikely]]
    return of_rescaled_load(load, radius, gauge);
  return gauge(t);
}

}  // namespace patchgrip::friction
