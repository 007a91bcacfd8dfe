// A round pressure as a table: any of them at the same speed, to rounding, at every pole.
//
// The functions of round_functions.h are smooth but for a weak singularity at the rim (d = 0; powers and logarithms of
// d) and, for some pressures, at the centre. On a quarter of an octave, d in 2^-(k+1) [1 + q/4, 1 + (q+1)/4], that
// singularity lies at t <= -9 of the interval's own variable t in [-1, 1], so Chebyshev interpolation converges at
// least like (9 + sqrt 80)^-degree whatever its kind; exponent and two leading bits of d pick the row. Close enough to
// the rim that the singular part is below rounding one last row covers what is left. The same towards the centre, in x.
//
// Built once per pressure from `Source`, which has inside(d), outside(d) and rim_slope() in the scalar type Work.
// Error   truncation < 1e-17 of the value; with the evaluation <= 4 units of rounding of double (round_patch_test.cc).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include <patchgrip/friction/kernels/chebyshev.h>
#include <patchgrip/friction/kernels/pair_polynomial.h>
#include <patchgrip/friction/kernels/round_functions.h>

namespace patchgrip::friction::kernels {

// `yes` or `no` without a branch: with poles all over the plane it would be guessed wrong half of the time.
inline double select(bool condition, double yes, double no) noexcept {
  const std::uint64_t mask = 0 - static_cast<std::uint64_t>(condition);
  const auto bits = std::bit_cast<std::uint64_t>(no);
  return std::bit_cast<double>(bits ^ ((bits ^ std::bit_cast<std::uint64_t>(yes)) & mask));
}

struct RoundLevels {
  int rim;     // the last row towards the rim covers d in [0, 2^-rim]
  int centre;  // the last row towards the centre covers x in [0, 2^-centre]
};

class RoundTable {
 public:
  static constexpr std::size_t terms = 14;

  template <class Work, class Source>
  static RoundTable build(const Source& source, const RoundLevels& levels) {
    RoundTable table(levels);
    const auto fill = [&](Zone zone, const auto& function) {
      for (int j = 0; j <= table.last_[zone]; ++j)
        table.rows_[index(table.first_[zone] + j)] = make_row<Work>(j, j == table.last_[zone], function);
    };
    table.rim_slope_ = static_cast<double>(source.rim_slope());
    fill(inner, [&](const Work& d) { return source.inside(d); });
    fill(outer, [&](const Work& d) { return source.outside(d); });
    fill(central, [&](const Work& x) { return source.inside(1 - x); });
    return table;
  }

  // {f / x, m} at d = 1 - x with the pole inside, where x itself is used below 1/2; {f, m / u} at d = 1 - u outside.
  Pair gradient(bool inside, double d, double x) const noexcept {
    const auto [row, t] = find(inside, d, x);
    return polynomial(row.gradient, t);
  }

  // f' inside, f' / u^3 outside.
  double slope(bool inside, double d, double x) const noexcept {
    if (d == 0) return rim_slope_;
    const auto [row, t] = find(inside, d, x);
    return polynomial(row.slope, t);
  }

 private:
  struct alignas(64) Row {
    double scale;  // t = scale * d - shift
    double shift;
    std::array<Pair, terms> gradient;
    std::array<double, terms> slope;
  };

  struct Place {
    const Row& row;
    double t;
  };

  enum Zone : unsigned { inner, outer, central };

  explicit RoundTable(const RoundLevels& levels)
      : last_{4 * levels.rim, 4 * levels.rim, 4 * levels.centre},
        first_{0, last_[inner] + 1, last_[inner] + last_[outer] + 2},
        rows_(index(first_[central] + last_[central] + 1)) {}

  static std::size_t index(int k) noexcept { return static_cast<std::size_t>(k); }

  // Row j = 4 k + 3 - q of a zone holds the quarter q of the octave [2^-(k+1), 2^-k), its last one all that is below; d
  // = 1 belongs to row 0.
  Place find(bool inside, double d, double x) const noexcept {
    const bool near_centre = inside & (x < 0.5);
    const unsigned zone = static_cast<unsigned>(!inside) + 2 * static_cast<unsigned>(near_centre);
    const double key = select(near_centre, x, d);
    const int j = std::clamp(4 * 1023 - 1 - static_cast<int>(std::bit_cast<std::uint64_t>(key) >> 50), 0, last_[zone]);
    const Row& row = rows_[index(first_[zone] + j)];
    return {row, row.scale * key - row.shift};
  }

  template <class Work, class Function>
  static Row make_row(int j, bool last, const Function& function) {
    Row row;
    // t = 8 (2^(k+1) d - 1 - q/4) - 1
    row.scale = std::ldexp(last ? 2.0 : 16.0, j / 4);
    row.shift = last ? 1 : 15 - 2 * (j % 4);
    const std::vector<Work> points = chebyshev_points<Work>(terms);
    std::vector<RoundValues<Work>> values(terms);
    std::ranges::transform(points, values.begin(),
                           [&](const Work& t) { return function((t + row.shift) / row.scale); });
    const auto coefficients = [&](auto member) {
      std::vector<Work> samples(terms);
      std::ranges::transform(values, samples.begin(), member);
      return monomials(chebyshev_series(samples));
    };
    const auto force = coefficients(&RoundValues<Work>::force);
    const auto moment = coefficients(&RoundValues<Work>::moment);
    const auto slope = coefficients(&RoundValues<Work>::slope);
    for (std::size_t i = 0; i < terms; ++i) {
      row.gradient[i] = Pair{static_cast<double>(force[i]), static_cast<double>(moment[i])};
      row.slope[i] = static_cast<double>(slope[i]);
    }
    return row;
  }

  std::array<int, 3> last_;
  std::array<int, 3> first_;
  double rim_slope_ = 0;  // f' may have a root or a logarithm of d: no row reaches its limit
  std::vector<Row> rows_;
};

}  // namespace patchgrip::friction::kernels
