#include <patchgrip/contact/half_space/love_kernel.h>
#include <patchgrip/contact/half_space/vector_clones.h>
#include <patchgrip/contact/require.h>

#include <algorithm>
#include <numbers>

namespace patchgrip::contact {
namespace {

using Long = long double;

// In cells: where double loses as much to the four corners as the multipoles lose to truncation, and where four orders
// do.
constexpr int near_cells = 24, far_cells = 100;

// Integral of 1/|P - Q| over the rectangle's points Q as a series of multipoles, up to the order 4 or 6, from the
// derivatives of 1/r, which is harmonic in space but not in the plane. The next order is (c / r)^6 or (c / r)^8,
// c = hypot(a, b).
template <int order, class Scalar>
[[gnu::always_inline]] inline Scalar far_integral(Scalar a, Scalar b, Scalar x, Scalar y) {
  const Scalar r2 = x * x + y * y, reciprocal = 1 / r2;
  const Scalar c2 = x * x * reciprocal, s2 = y * y * reciprocal;  // squared cosine and sine of the direction
  const Scalar A = a * a * reciprocal, B = b * b * reciprocal;
  // Mean of r / |P - Q| = sum over m, n of A^m B^n d^(2m+2n)(1/r) / ((2m+1)! (2n+1)!) in x^(2m) y^(2n), r = 1.
  const Scalar second = (A * (3 * c2 - 1) + B * (3 * s2 - 1)) / 6;
  const Scalar xxxx = (105 * c2 - 90) * c2 + 9, yyyy = (105 * s2 - 90) * s2 + 9, xxyy = 105 * c2 * s2 - 12;
  const Scalar fourth = (A * A * xxxx + B * B * yyyy) / 120 + A * B * xxyy / 36;
  Scalar sum = second + fourth;
  if constexpr (order == 6) {
    const Scalar x6 = ((10395 * c2 - 14175) * c2 + 4725) * c2 - 225, y6 = ((10395 * s2 - 14175) * s2 + 4725) * s2 - 225;
    const Scalar x4y2 = (10395 * c2 * c2 - 5670 * c2 + 315) * s2 - (945 * c2 * c2 - 630 * c2 + 45);
    const Scalar x2y4 = (10395 * s2 * s2 - 5670 * s2 + 315) * c2 - (945 * s2 * s2 - 630 * s2 + 45);
    sum += (A * A * A * x6 + B * B * B * y6) / 5040 + A * B * (A * x4y2 + B * x2y4) / 720;
  }
  return 4 * a * b / std::sqrt(r2) * (1 + sum);
}

// asinh(right / h) - asinh(left / h), right > left, h >= 0: the potential of a line at the distance h. No difference of
// nearly equal numbers.
Long span(Long left, Long right, Long h) {
  if (left < 0) return right < 0 ? span(-right, -left, h) : std::asinh(right / h) + std::asinh(-left / h);
  const Long near = std::hypot(left, h), far = std::hypot(right, h);
  return std::log1p((right - left) * (1 + (right + left) / (near + far)) / (left + near));
}

// [asinh(X / low) - asinh(X / high)] for 0 < low < high and X >= 0.
Long fall(Long X, Long low, Long high) {
  const Long near = std::hypot(X, low), far = std::hypot(X, high);
  // (X + near) / low over (X + far) / high
  return std::log1p((high - low) / low) - std::log1p((high - low) * (high + low) / ((near + far) * (X + near)));
}

// Closed form for a >= b, x, y >= 0, arranged so that rounding grows as r / a only, however thin the rectangle.
Long near_integral(Long a, Long b, Long x, Long y) {
  const auto times_span = [](Long factor, Long left, Long right) {
    return factor == 0 ? 0 : factor * span(left, right, std::abs(factor));
  };
  const Long columns = times_span(x + a, y - b, y + b) - times_span(x - a, y - b, y + b);
  if (y <= 2 * b) return columns + times_span(y + b, x - a, x + a) - times_span(y - b, x - a, x + a);
  // y >> b: the two spans are nearly equal. (y+b) M(y+b) - (y-b) M(y-b) = b [M(y+b) + M(y-b)] - y [M(y-b) - M(y+b)].
  const Long far_end = fall(x + a, y - b, y + b);
  const Long near_end = x >= a ? fall(x - a, y - b, y + b) : -fall(a - x, y - b, y + b);
  return columns + b * (span(x - a, x + a, y + b) + span(x - a, x + a, y - b)) - y * (far_end - near_end);
}

Long integral(Long a, Long b, Long x, Long y) {
  if (a < b) return integral(b, a, y, x);
  return std::hypot(x, y) > 100 * a ? far_integral<6>(a, b, x, y) : near_integral(a, b, x, y);
}

// Cells begin ... end - 1 of a row of the table.
template <int order>
[[gnu::always_inline]] inline void fill_far(const Grid& grid, double y, int begin, int end, double* row) {
  const double a = grid.dx / 2, b = grid.dy / 2, dx = grid.dx;
  for (int i = begin; i < end; ++i) row[i] = far_integral<order>(a, b, i * dx, y) * (1 / std::numbers::pi);
}

PATCHGRIP_VECTOR_CLONES void fill_far_row(const Grid& grid, double y, int begin, int middle, int end, double* row) {
  fill_far<6>(grid, y, begin, middle, row);
  fill_far<4>(grid, y, middle, end, row);
}

// Cells 0 ... end - 1 of row j. Neighbours share corners, none on an axis; T is odd in X and in Y.
void fill_near_row(const Grid& grid, int j, int end, double* row) {
  const auto rise = [&](double X) {  // T(X, y + b) - T(X, y - b)
    const double low = std::abs(j - 0.5) * grid.dy, high = (j + 0.5) * grid.dy;
    const double lower = X * std::asinh(low / X) + low * std::asinh(X / low);
    return X * std::asinh(high / X) + high * std::asinh(X / high) + (j == 0 ? lower : -lower);
  };
  double left = -rise(0.5 * grid.dx);
  for (int i = 0; i < end; ++i) {
    const double right = rise((i + 0.5) * grid.dx);
    row[i] = (right - left) / std::numbers::pi;
    left = right;
  }
}

}  // namespace

double love_displacement(double pressure, double contact_modulus, double half_x, double half_y, double x, double y) {
  require_positive("pressure", pressure);
  require_positive("contact_modulus", contact_modulus);
  const Long a = require_positive("half_x", half_x), b = require_positive("half_y", half_y);
  const Long across = std::abs(require_finite("x", x)), along = std::abs(require_finite("y", y));
  const Long u = pressure / (std::numbers::pi_v<Long> * contact_modulus) * integral(a, b, across, along);
  return require_representable("displacement", static_cast<double>(u));
}

void fill_love_table(const Grid& grid, int columns, int rows, double* table, Workers& workers) {
  const double cell = std::max(grid.dx, grid.dy);
  const auto within = [&](int distance, double step, int most) {
    return std::min(most, static_cast<int>(distance * cell / step));
  };
  const int near_columns = within(near_cells, grid.dx, columns), near_rows = within(near_cells, grid.dy, rows);
  const int far_columns = within(far_cells, grid.dx, columns), far_rows = within(far_cells, grid.dy, rows);
  workers.each_row(rows, [&](int j, int) {
    double* row = table + static_cast<std::ptrdiff_t>(j) * columns;
    const int begin = j < near_rows ? near_columns : 0;
    const int middle = j < far_rows ? std::max(begin, far_columns) : begin;
    fill_near_row(grid, j, begin, row);
    fill_far_row(grid, j * grid.dy, begin, middle, columns, row);
  });
}

}  // namespace patchgrip::contact
