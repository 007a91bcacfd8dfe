#include <patchgrip/contact/creep/history.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::Exact;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;
using patchgrip::testing::units_of_rounding;

using ExactHistory = BasicHistory<Exact>;

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

struct Pair {
  History rounded;
  ExactHistory exact;
};

Pair growing_points(std::mt19937_64& engine) {
  std::vector<HistoryPoint<double>> points;
  double time = 0;
  double value = uniform(engine, 0, 1);
  for (int k = std::uniform_int_distribution<int>(1, 6)(engine); k > 0; --k) {
    points.push_back({time, value});
    if (std::uniform_int_distribution<int>(0, 3)(engine) != 0) time += log_uniform(engine, 1e-6, 1e2);
    value += log_uniform(engine, 1e-6, 1e3);
  }
  std::vector<HistoryPoint<Exact>> exact;
  for (const auto& point : points) exact.push_back({point.time, point.value});
  return {History::points(points), ExactHistory::points(exact)};
}

TEST(History, ClosedFormsOfGrowingPoints) {
  std::mt19937_64 engine(20060411);
  double worst = 0;
  for (int i = 0; i < cases(1000); ++i) {
    const auto [rounded, exact] = growing_points(engine);
    const double T = log_uniform(engine, 1e-6, 1e6);
    // Beyond 1/2 the exponent's own rounding counts: 40 of them are 20 units.
    const double t = std::min(rounded.pieces().back().start + log_uniform(engine, 1e-6, 1e2), 4 * T);
    worst = std::max({worst, units_of_rounding(rounded(t), exact(t)),
                      units_of_rounding(rounded.faded(t, T), exact.faded(t, T)),
                      units_of_rounding(rounded.lagged(t, T), exact.lagged(t, T)),
                      units_of_rounding(rounded.integral(t), exact.integral(t))});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 8);
}

TEST(History, ClosedFormsOfSines) {
  std::mt19937_64 engine(20060412);
  double worst = 0;
  for (int i = 0; i < cases(300); ++i) {
    const double w = log_uniform(engine, 1e-4, 1e3);
    const double swing = uniform(engine, 0, 1);
    const bool is_half = i % 2 == 0;
    const auto rounded = is_half ? History::half_sine(1, w) : History::sine(1, swing, w);
    const auto exact = is_half ? ExactHistory::half_sine(1, w) : ExactHistory::sine(1, swing, w);
    const double T = log_uniform(engine, 1e-6, 1e6);
    const double t = std::min(uniform(engine, 0, 6) / w, 4 * T);
    const Exact steps = is_half ? std::min(1., w * t) : 1 + swing;  // their moduli, summed: within a factor of four
    const auto units = [&](double value, const Exact& right) {
      return static_cast<double>(abs(Exact(value) - right) / steps * 0x1p53);
    };
    worst = std::max({worst, units(rounded(t), exact(t)), units(rounded.faded(t, T), exact.faded(t, T)),
                      units(rounded.lagged(t, T), exact.lagged(t, T))});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 16);
}

// The closed forms against their definition, by quadrature in 50 digits.
TEST(History, FadedAndLaggedAreTheirIntegrals) {
  std::mt19937_64 engine(20060413);
  using Gauss = boost::math::quadrature::gauss<Exact, 30>;
  for (int i = 0; i < cases(30); ++i) {
    const Exact w = uniform(engine, 0.5, 3);
    const auto history = i % 2 == 0 ? ExactHistory::sine(2, uniform(engine, 0, 1), w) : growing_points(engine).exact;
    const Exact T = log_uniform(engine, 0.3, 10);
    const Exact t = history.pieces().back().start + uniform(engine, 0.1, 1);
    Exact faded = 0, lagged = 0, integral = 0;
    const auto& pieces = history.pieces();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Exact a = pieces[k].start;
      const Exact b = k + 1 < pieces.size() ? pieces[k + 1].start : t;
      faded += history.jump(k) * exp(-(t - a) / T);
      lagged += history.jump(k) * (1 - exp(-(t - a) / T));
      const int panels = 1 + static_cast<int>(4 * (b - a) / T);
      for (int panel = 0; panel < panels; ++panel) {
        const Exact lo = a + (b - a) * panel / panels, hi = a + (b - a) * (panel + 1) / panels;
        faded +=
            Gauss::integrate([&](const Exact& s) -> Exact { return exp(-(t - s) / T) * pieces[k].rate_at(s); }, lo, hi);
        lagged += Gauss::integrate(
            [&](const Exact& s) -> Exact { return (1 - exp(-(t - s) / T)) * pieces[k].rate_at(s); }, lo, hi);
        integral += Gauss::integrate([&](const Exact& s) -> Exact { return pieces[k].at(s); }, lo, hi);
      }
    }
    EXPECT_LE(abs(history.faded(t, T) / faded - 1), Exact(1e-25));
    EXPECT_LE(abs(history.lagged(t, T) / lagged - 1), Exact(1e-25));
    EXPECT_LE(abs(history.integral(t) / integral - 1), Exact(1e-25));
  }
}

RC_GTEST_PROP(History, FadedSplitsAtAnyTime, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  const auto history = growing_points(engine).rounded;
  const double t = uniform(engine, 0.1, 20);
  const double between = uniform(engine, 0, 1) * t;
  const double T = log_uniform(engine, 1e-2, 1e3);
  const double whole = history.faded(t, T);
  const double split = history.faded(between, T) * std::exp(-(t - between) / T) + history.faded_since(between, t, T);
  RC_ASSERT(std::abs(whole - split) <= 1e-12 * history(t));
}

TEST(History, AJumpCountsFromItsTimeOn) {
  const auto history = History::points({{0, 1}, {2, 3}, {2, 7}, {3, 7}});
  EXPECT_EQ(history(-1e-9), 0);
  EXPECT_EQ(history(0), 1);
  EXPECT_EQ(history(1), 2);
  EXPECT_EQ(history(2), 7);
  EXPECT_EQ(history.jump(0), 1);
  EXPECT_EQ(history.jump(1), 4);
  EXPECT_EQ(history.jump(2), 0);
  EXPECT_EQ(history(100), 7);
  EXPECT_DOUBLE_EQ(history.faded(2, 1e300), 7);
  EXPECT_DOUBLE_EQ(history.faded_since(2, 2.5, 1e300), 0);
  EXPECT_DOUBLE_EQ(History::step(3).faded(2, 4), 3 * std::exp(-0.5));
  EXPECT_EQ(History::half_sine(2, 1)(4), 0);
  EXPECT_NEAR(History::half_sine(2, 1).faded(3.1415, 1e300), 2 * std::sin(3.1415), 1e-14);
}

TEST(History, ARiseThatHardlyLastsIsAJump) {
  for (const double duration : {1e-290, 1e-200, 1e-100}) {
    const auto rise = History::points({{0, 0}, {duration, 3}});
    for (const double T : {1e-3, 1., 1e40}) {
      EXPECT_DOUBLE_EQ(rise.faded(0.5, T), History::step(3).faded(0.5, T)) << duration << ' ' << T;
      EXPECT_DOUBLE_EQ(rise.lagged(0.5, T), History::step(3).lagged(0.5, T)) << duration << ' ' << T;
    }
  }
}

TEST(History, BadInputIsRefused) {
  EXPECT_THAT([] { History::points({}); }, refused("points = 0 is not allowed: must be at least one"));
  EXPECT_THAT(
      [] {
        History::points({{0, 1}, {-1, 2}});
      },
      refused("t_1 = -1 is not allowed: must not be less than the time before it"));
  EXPECT_THAT(
      [] {
        History::points({{0, 1}, {NAN, 2}});
      },
      refused("t_1 = nan is not allowed: must not be less than the time before it"));
  const auto starts = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(::testing::StartsWith(message));
  };
  EXPECT_THAT([] { History::points({{0, 1}, {1e-310, 2}}); }, starts("t_1 - t_0 = 1e-310 is not allowed"));
  EXPECT_THAT([] { History::points({{0, 0}, {1e-300, 1e10}}); }, starts("rate_0 = inf is not allowed"));
  EXPECT_THAT([] { History::sine(1e200, 1, 1e200); }, starts("mean * swing * frequency = inf is not allowed"));
  EXPECT_THAT([] { History::half_sine(1e200, 1e200); }, starts("height * frequency = inf is not allowed"));
  EXPECT_THAT([] { History::half_sine(1, 1e-310); }, starts("pi / frequency = inf is not allowed"));
  EXPECT_THAT([] { History::step(INFINITY); }, refused("value_0 = inf is not allowed: must be finite"));
  EXPECT_THAT([] { History::half_sine(1, 0); }, refused("frequency = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { History::triangle(1, -1); }, refused("peak_time = -1 is not allowed: must be positive and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
