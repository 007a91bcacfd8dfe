#include <patchgrip/contact/half_space/cosine_transform.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/support/cases.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::uniform;

// Weight and cosine of x(j) in y(k).
double term(int j, int k, int n) {
  return (j == 0 || j == n - 1 ? 1 : 2) * std::cos(std::numbers::pi * j * k / (n - 1));
}

TEST(CosineTransform, IsTheSum) {
  std::mt19937_64 engine(20061207);
  Workers workers(2);
  for (const auto& [columns, rows] :
       {std::pair{2, 2}, {2, 9}, {9, 2}, {3, 5}, {17, 12}, {12, 17}, {33, 33}, {40, 31}}) {
    std::vector<double> x(static_cast<std::size_t>(columns * rows));
    for (double& value : x) value = uniform(engine, -1, 1);
    std::vector<double> y = x;
    cosine_transform(columns, rows, 0.5, y.data(), {workers});
    double worst = 0, size = 0;
    for (const double value : x) size += 4 * std::abs(value);
    for (int l = 0; l < rows; ++l) {
      for (int k = 0; k < columns; ++k) {
        double sum = 0;
        for (int j = 0; j < rows; ++j) {
          for (int i = 0; i < columns; ++i) {
            sum += x[static_cast<std::size_t>(j * columns + i)] * term(i, k, columns) * term(j, l, rows);
          }
        }
        worst = std::max(worst, std::abs(y[static_cast<std::size_t>(l * columns + k)] - sum / 2));
      }
    }
    EXPECT_LE(worst, 4 * 0x1p-53 * size) << columns << " x " << rows;
  }
}

}  // namespace
}  // namespace patchgrip::contact
