// What refinement says about the error of finite elements, on numbers that are known.
#include <patchgrip/verification/study.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace patchgrip::verification {
namespace {

using Meshes = std::vector<double>;

void no_progress(const Run&) {}

// A quantity that is `truth` and that meshes of n elements miss by n^-order.
Comparison found(const Meshes& meshes, double order, double truth = 1) {
  std::vector<Setting> settings;
  for (const double n : meshes) settings.push_back({n, 0});
  const auto solve = [&](const Setting& s) {
    Solved solved;
    solved.values = {{truth + std::pow(s.elements, -order)}};
    return solved;
  };
  return study({number("x", "1", 1, 0.5, "")}, settings, solve, no_progress).comparisons.front();
}

TEST(Study, ObservesTheOrderOfAnyMeshes) {
  for (const Meshes& meshes : {Meshes{10, 20, 40}, {4, 6, 8}, {3, 4, 6}, {2, 3, 5}, {5, 6, 60}}) {
    for (const double order : {0.7, 1., 2., 3.5}) {
      EXPECT_NEAR(found(meshes, order).order, order, 1e-6) << meshes[0] << " " << meshes[1] << " " << meshes[2];
    }
  }
}

TEST(Study, BoundsTheErrorOfOrdersItTrusts) {
  for (const Meshes& meshes : {Meshes{10, 20, 40}, {4, 6, 8}, {3, 4, 6}, {2, 3, 5}}) {
    for (const double order : {0.5, 1., 1.5, 2., 3.}) {
      EXPECT_GE(found(meshes, order).fe_error[0], (1 - 1e-9) * std::pow(meshes[2], -order)) << order;
    }
    EXPECT_NEAR(found(meshes, 2).fe_error[0], std::pow(meshes[2], -2), 1e-9);
  }
}

TEST(Study, ADifferenceThatIsSmallByChanceIsNotTrusted) {
  const std::vector<double> values{1.4, 1.1, 1.1 + 1e-12};
  std::size_t k = 0;
  const auto solve = [&](const Setting&) {
    Solved solved;
    solved.values = {{values[k++]}};
    return solved;
  };
  const Study result = study({number("x", "1", 1, 0.5, "")}, {{10, 0}, {20, 0}, {40, 0}}, solve, no_progress);
  EXPECT_GT(result.comparisons[0].fe_error[0], 0.3 / 4);
}

TEST(Study, RefusesWhatIsNotANumberOrNotThere) {
  const auto with = [](std::vector<std::vector<double>> values) {
    const auto solve = [&](const Setting&) {
      Solved solved;
      solved.values = values;
      return solved;
    };
    study({number("x", "1", 1, 0.5, "")}, {{1, 0}, {2, 0}}, solve, no_progress);
  };
  EXPECT_NO_THROW(with({{1}}));
  EXPECT_THROW(with({{std::nan("")}}), std::runtime_error);
  EXPECT_THROW(with({{std::numeric_limits<double>::infinity()}}), std::runtime_error);
  EXPECT_THROW(with({{}}), std::runtime_error);
  EXPECT_THROW(with({{1, 1}}), std::runtime_error);
  EXPECT_THROW(with({}), std::logic_error);
}

}  // namespace
}  // namespace patchgrip::verification
