// The passes of the solver over its fields (solver.h), for the vectors that the machine has.
//
// All take arrays of n cells, none of which overlap.
#pragma once

#include <cstddef>

#include <patchgrip/contact/half_space/pieces.h>

namespace patchgrip::contact::kernels {

// g += add_gap (gap - approach);  on = p > 0 or g < 0;  r = -on g. Sums: cells whose `on` changed; of on; of g^2 where
// p > 0; of 1 where p > 0; of r^2; of on (gap - least_gap) and of its square. Largest: -g where p = 0.
Tally choose_set(std::size_t n, double add_gap, double approach, double least_gap, const double* gap, const double* p,
                 double* g, double* on, double* r) noexcept;

// z = on z - shift uniform. Sum: -g z.
Tally project(std::size_t n, double shift, const double* uniform, const double* on, const double* g,
              double* z) noexcept;

// d = z + beta d
void turn(std::size_t n, double beta, const double* z, double* d) noexcept;

// Sums: -d g, d Kd.
Tally slopes(std::size_t n, const double* d, const double* g, const double* Kd) noexcept;

// p += length d;  g += length Kd + shift;  Kd becomes r = -on g. Sum: r^2.
Tally advance(std::size_t n, double length, double shift, const double* d, const double* on, double* p, double* g,
              double* Kd) noexcept;

// p = max(p, 0). Sums: cells with p < 0; of p afterwards.
Tally cut(std::size_t n, double* p) noexcept;

// The least of x, infinity if there is none.
double least(std::size_t n, const double* x) noexcept;

// Whether all |x| <= most.
bool within(std::size_t n, double most, const double* x) noexcept;

// Sum: p.
Tally sum(std::size_t n, const double* p) noexcept;

// Sum: on z.
Tally masked_sum(std::size_t n, const double* on, const double* z) noexcept;

// z = on z. Sum: z.
Tally mask(std::size_t n, const double* on, double* z) noexcept;

// Sums: p (g + gap), p.
Tally weighted_gap(std::size_t n, const double* p, const double* g, const double* gap) noexcept;

// p = factor p
void scale(std::size_t n, double factor, double* p) noexcept;

}  // namespace patchgrip::contact::kernels
