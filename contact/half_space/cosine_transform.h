// The Fourier transform of a field that is even about its first and last row and column (FFTW's REDFT00).
//
//     y(k) = x(0) + (-1)^k x(n - 1) + 2 sum over 0 < j < n - 1 of x(j) cos(pi j k / (n - 1))     in both directions
//
// It does not depend on the number of threads.
//
// Domain   columns, rows >= 2.
// Throws   std::bad_alloc, std::runtime_error when FFTW makes no plan.
#pragma once

#include <patchgrip/contact/half_space/resources.h>

namespace patchgrip::contact {

// In place, of `rows` rows of `columns` numbers, times `factor`.
void cosine_transform(int columns, int rows, double factor, double* table, Resources resources);

}  // namespace patchgrip::contact
