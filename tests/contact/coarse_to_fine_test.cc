#include <patchgrip/contact/half_space/coarse_to_fine.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/contact/half_space_shapes.h>

namespace patchgrip::contact {
namespace {

GapFunction hertz(double x0, double y0) {
  return [=](double x, double y) { return std::sqrt(std::max(0., 1 - std::pow(x - x0, 2) - std::pow(y - y0, 2))); };
}

double rms_difference(std::span<const double> one, std::span<const double> other) {
  double squares = 0;
  for (std::size_t k = 0; k < one.size(); ++k) squares += std::pow(one[k] - other[k], 2);
  return std::sqrt(squares / static_cast<double>(one.size()));
}

// Far better than with p itself, which has no slope at the edge.
TEST(CoarseToFine, HertzPressureIsRefined) {
  Workers workers(2);
  for (const int cells : {32, 64}) {
    const Grid coarse = Grid::square(cells, 2.5), fine = Grid::square(2 * cells, 2.5);
    const auto refined = refine_pressure(coarse, Surface::free, sample(coarse, hertz(0.01, 0.02)), {workers});
    EXPECT_LE(rms_difference(refined, sample(fine, hertz(0.01, 0.02))), 0.5 / cells);
    const auto [wrong_on, wrong_off] = [&] {
      int on = 0, off = 0;
      const auto exact = sample(fine, hertz(0.01, 0.02));
      for (std::size_t k = 0; k < exact.size(); ++k) {
        on += refined[k] > 0 && exact[k] == 0;
        off += refined[k] == 0 && exact[k] > 0;
      }
      return std::pair{on, off};
    }();
    EXPECT_LE(wrong_on + wrong_off, cells);  // of about 5 times as many cells along the edge
  }
}

TEST(CoarseToFine, PeriodicFieldsWrap) {
  Workers workers(2);
  const Grid coarse = Grid::of_cells(32, 16, 0.1, 0.2), fine = Grid::of_cells(64, 32, 0.05, 0.1);
  const auto p = [](double x, double y) {
    return std::sqrt(2 + std::cos(2 * std::numbers::pi * (x / 3.2 + 0.1)) *
                             std::cos(2 * std::numbers::pi * (y / 3.2 + 0.2)));
  };
  EXPECT_LE(rms_difference(refine_pressure(coarse, Surface::periodic, sample(coarse, p), {workers}), sample(fine, p)),
            4e-3);
}

TEST(CoarseToFine, CoarsePressureKeepsTheForce) {
  Workers workers(2);
  const Grid fine = Grid::of_cells(32, 48, 0.1, 0.07);
  const auto p = sample(fine, hertz(0.2, -0.3));
  const auto coarse = coarsen_pressure(fine, p, {workers});
  EXPECT_NEAR(std::accumulate(coarse.begin(), coarse.end(), 0.) * 4, std::accumulate(p.begin(), p.end(), 0.), 1e-11);
}

TEST(CoarseToFine, CubicGapIsExactWhereItIsMonotone) {
  Workers workers(2);
  const Grid fine = Grid::square(32, 2);
  const auto gap = [](double x, double y) { return (x + 3) * (x + 3) * (x + 3) + 2 * (y + 3) * (y + 3); };
  const auto coarse = coarsen_gap(fine, Surface::free, sample(fine, gap), {workers});
  const Grid grid = coarser(fine);
  for (int j = 1; j < 15; ++j) {
    for (int i = 1; i < 15; ++i) EXPECT_NEAR(coarse[grid.index(i, j)], gap(grid.x(i), grid.y(j)), 1e-12);
  }
}

TEST(CoarseToFine, StepInTheGapDoesNotOvershoot) {
  Workers workers(2);
  const Grid fine = Grid::square(32, 2);
  const auto coarse = coarsen_gap(
      fine, Surface::free, sample(fine, [](double x, double y) { return x + 0.5 * y > 0.31 ? 1e3 : 0; }), {workers});
  EXPECT_GE(*std::ranges::min_element(coarse), 0);
  EXPECT_LE(*std::ranges::max_element(coarse), 1e3);
}

}  // namespace
}  // namespace patchgrip::contact
