#include <patchgrip/friction/kernels/chebyshev.h>

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace patchgrip::friction::kernels {
namespace {

using ::testing::ElementsAre;

double horner(const std::vector<double>& c, double t) {
  double sum = 0;
  for (auto k = c.size(); k-- > 0;) sum = sum * t + c[k];
  return sum;
}

std::vector<double> interpolated(double (*function)(double), std::size_t terms) {
  std::vector<double> values;
  for (const double t : chebyshev_points<double>(terms)) values.push_back(function(t));
  return monomials(chebyshev_series(values));
}

TEST(Monomials, OfSingleChebyshevPolynomials) {
  EXPECT_THAT(monomials<double>({1}), ElementsAre(1));
  EXPECT_THAT(monomials<double>({0, 1}), ElementsAre(0, 1));
  EXPECT_THAT(monomials<double>({0, 0, 1}), ElementsAre(-1, 0, 2));
  EXPECT_THAT(monomials<double>({0, 0, 0, 0, 0, 1}), ElementsAre(0, 5, 0, -20, 0, 16));
}

TEST(ChebyshevPoints, AreTheZerosOfTheNextPolynomial) {
  for (const double t : chebyshev_points<double>(7)) EXPECT_NEAR(std::cos(7 * std::acos(t)), 0, 1e-14);
}

TEST(ChebyshevSeries, ReproducesAPolynomialOfItsDegree) {
  const auto cubic = [](double t) { return 1 - 2 * t + 4 * t * t * t; };
  const auto c = interpolated(cubic, 4);
  for (const double t : {-1.0, -0.3, 0.0, 0.77, 1.0}) EXPECT_NEAR(horner(c, t), cubic(t), 4e-15);
}

TEST(ChebyshevSeries, ConvergesGeometricallyForAnAnalyticFunction) {
  // 1 / (2 - t): the pole at 2 lies on the ellipse of rho = 2 + sqrt 3.
  const auto function = [](double t) { return 1 / (2 - t); };
  for (const std::size_t terms : {4U, 8U, 12U, 16U, 20U}) {
    const auto c = interpolated(function, terms);
    double worst = 0;
    for (int i = -50; i <= 50; ++i) worst = std::max(worst, std::abs(horner(c, i / 50.0) - function(i / 50.0)));
    const double rate = std::pow(2 + std::sqrt(3.0), -static_cast<double>(terms));
    EXPECT_LT(worst, 4 * rate);
    EXPECT_GT(worst, rate / 4);
  }
}

}  // namespace
}  // namespace patchgrip::friction::kernels
