// The wrench of a Hertz or flat-punch disc over many poles, in vector registers.
//
// One step handles as many poles as a register holds, without branches; AVX-512 has its own code, since its reciprocal
// root estimate saves the slowest instructions, AVX2 and SSE2 are left to the compiler. Poles (x, y) are about the
// centre, sense = +-1 is the sign of the spin.
//
// Domain   2^-900 < a^2 < 2^900; returns false where x^2 + y^2 leaves it for any pole, and the results are then void.
// Error    <= 8 units of 2^-53 as the scalar code (batch_test.cc).
#pragma once

#include <cstddef>

#include <patchgrip/friction/kernels/moebius_kernel.h>

namespace patchgrip::friction::kernels {

using MoebiusBatch = bool (*)(std::size_t n, const double* x, const double* y, double radius, double sense, double* fx,
                              double* fy, double* m) noexcept;

// The best that this processor can do.
template <class Coefficients>
MoebiusBatch moebius_batch() noexcept;

extern template MoebiusBatch moebius_batch<HertzCoefficients>() noexcept;
extern template MoebiusBatch moebius_batch<FlatPunchCoefficients>() noexcept;

}  // namespace patchgrip::friction::kernels
