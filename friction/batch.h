// grad D over many poles at once: contiguous arrays in, contiguous arrays out.
//
// For every i, with v_i the rotation about (pole_x[i], pole_y[i]) in the sense of `spin` (its sign alone matters: grad
// D does not depend on the speed),
//
//     (force_x[i], force_y[i], moment[i]) = grad D(v_i)
//
// Discs whose wrench is a polynomial on either side of the rim (Hertz, flat punch) run in vector registers, compiled
// for AVX-512, AVX2 and SSE2 and chosen when the program starts; every other patch runs pole by pole.
//
// Units    pole [m]; force [1], moment [m], per mu F_N.
// Error    as gradient(v) of the patch; values may differ from it by a few units of rounding (fused multiply-add).
// Throws   std::invalid_argument unless the spans are equally long and spin != 0.
#pragma once

#include <cmath>
#include <span>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

struct PoleBatch {
  std::span<const double> pole_x, pole_y;
  std::span<double> force_x, force_y, moment;

  void check(double spin) const;
};

template <Patch P>
void gradient(const P& patch, double spin, const PoleBatch& batch) {
  batch.check(spin);
  const double sense = std::copysign(1.0, spin);
  for (std::size_t i = 0; i < batch.pole_x.size(); ++i) {
    const Wrench g = patch.gradient(twist_about({batch.pole_x[i], batch.pole_y[i]}, sense));
    batch.force_x[i] = g.fx;
    batch.force_y[i] = g.fy;
    batch.moment[i] = g.m;
  }
}

void gradient(const HertzDisc& patch, double spin, const PoleBatch& batch);
void gradient(const FlatPunchDisc& patch, double spin, const PoleBatch& batch);

}  // namespace patchgrip::friction
