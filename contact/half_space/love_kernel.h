// Love's kernel: surface displacement of a half-space under a uniform pressure on a rectangle.
//
//     u_z(x, y) = p / (pi E*) [T(x+a, y+b) - T(x-a, y+b) - T(x+a, y-b) + T(x-a, y-b)]
//     T(X, Y)   = X asinh(Y / |X|) + Y asinh(X / |Y|),  either term 0 where its factor is
//
// (A. E. H. Love, Phil. Trans. R. Soc. A 228, 1929, 377; Johnson, Contact Mechanics, 3.25) for |x| < a, |y| < b pressed
// with p; u_z is positive into the body. In plain floating point the difference of four T loses (r / a)(r / b) units:
// the textbook form below is for scalars with digits to spare. love_displacement and fill_love_table lose none.
//
// Domain   a, b, p, E* > 0 and finite, x, y finite; love_displacement throws std::invalid_argument outside, and where
//          u_z would overflow or underflow.
// Units    a, b, x, y, u_z [m]; p, E* [Pa].
// Error    love_displacement: <= love_error_units of 2^-53, relative, for every aspect ratio and distance.
//          fill_love_table: <= love_table_error relative. tests/contact/love_kernel_test.cc.
#pragma once

#include <cmath>

#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/workers.h>

namespace patchgrip::contact {

inline constexpr double love_error_units = 1.1;
inline constexpr double love_table_error = 2e-12;

// pi E* u_z / p [m], the textbook form.
template <class Scalar>
Scalar love_integral(const Scalar& a, const Scalar& b, const Scalar& x, const Scalar& y) {
  using std::abs;
  using std::asinh;
  const auto corner = [](const Scalar& X, const Scalar& Y) -> Scalar {
    Scalar sum = 0;
    if (X != 0) sum += X * asinh(Scalar(Y / abs(X)));
    if (Y != 0) sum += Y * asinh(Scalar(X / abs(Y)));
    return sum;
  };
  return corner(x + a, y + b) - corner(x - a, y + b) - corner(x + a, y - b) + corner(x - a, y - b);
}

// u_z [m] at (x, y) under `pressure` on |x| < half_x, |y| < half_y.
double love_displacement(double pressure, double contact_modulus, double half_x, double half_y, double x, double y);

// E* u_z / p [m] of a cell of `grid` at the centre of the cell i columns and j rows away, at index j `columns` + i, for
// 0 <= i < columns, 0 <= j < rows.
void fill_love_table(const Grid& grid, int columns, int rows, double* table, Workers& workers);

}  // namespace patchgrip::contact
