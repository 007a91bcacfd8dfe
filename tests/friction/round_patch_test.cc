#include <patchgrip/friction/round_patch.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/differentiation/autodiff.hpp>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/round_reference.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::friction {
namespace {

using kernels::PowerFamily;
using patchgrip::testing::units_of_rounding;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A round patch of unit normal force as its functions.
struct Disc {
  std::function<double(const Twist&)> dissipation;
  std::function<Wrench(const Twist&)> gradient;
  std::function<BoundedWrench(const Twist&)> bounded_gradient;
  std::function<Hessian(const Twist&)> hessian;
  std::function<CurvePoint(double x)> curve_inside;
  std::function<CurvePoint(double u)> curve_outside;
};

template <class P>
Disc functions(P patch) {
  return {[patch](const Twist& v) { return patch.dissipation(v); },
          [patch](const Twist& v) { return patch.gradient(v); },
          [patch](const Twist& v) { return patch.bounded_gradient(v); },
          [patch](const Twist& v) { return patch.hessian(v); },
          [patch](double x) { return patch.kernel().inside(x); },
          [patch](double u) { return patch.kernel().outside(u); }};
}

struct Kind {
  const char* name;
  double n;  // p ~ (1 - r^2)^(n - 1/2)
  std::function<Disc(double radius)> of_radius;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

template <class P>
Kind named(const char* name, double n) {
  return {name, n, [](double radius) { return functions(P::of_radius(radius)); }};
}

Kind power_disc(const char* name, double n) {
  return {name, n, [n](double radius) { return functions(PowerDisc::of_radius(radius, n)); }};
}

const std::vector<Kind> kinds = {
    named<HertzDisc>("HertzDisc", 1),
    named<FlatPunchDisc>("FlatPunchDisc", 0),
    named<UniformDisc>("UniformDisc", 0.5),
    named<Ring>("Ring", -0.5),
    power_disc("PowerMinus049", -0.49),
    power_disc("PowerMinus03", -0.3),
    power_disc("Power025", 0.25),
    power_disc("Power2", 2),
    power_disc("Power3", 3),
    power_disc("Power73", 7.3),
    power_disc("Power20", 20),
};

const std::vector<double> radii{1, 0.0037, 1e-6, 1e3};

// r_M / a of interest: centre, rim from both sides in steps of rounding, where rows and rules change, far away.
std::vector<double> pole_distances() {
  std::vector<double> x{0, 1e-300, 1e-150, 1e-12, 1e-5, 0.1, 0.25, 0.5,   0.7,   0.99,
                        1, 1.01,   1.5,    2,     10,   1e3, 1e8,  1e150, 1e300, infinity};
  for (const double away : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.0078, 0.0079}) {
    x.push_back(1 - away);
    x.push_back(1 + away);
  }
  double below = 1, above = 1;
  for (int k = 0; k < 3; ++k) {
    below = std::nextafter(below, 0);
    above = std::nextafter(above, 2);
    x.push_back(below);
    x.push_back(above);
  }
  return x;
}

// The pole at x radii in three directions; x = infinity is a translation.
std::vector<Twist> twists(double radius, double x) {
  std::vector<Twist> result;
  for (const double angle : {0.0, 2.2}) {
    for (const double spin : {1.0, -0.3}) {
      const double c = std::cos(angle), s = std::sin(angle);
      result.push_back(x == infinity ? Twist{s, -c, std::copysign(0.0, spin)}
                                     : twist_about({radius * x * c, radius * x * s}, spin));
    }
  }
  return result;
}

double force_units(const Wrench& g, const Wrench50& exact) {
  const Real50 dx = g.fx - exact.fx;
  const Real50 dy = g.fy - exact.fy;
  const Real50 size = sqrt(exact.fx * exact.fx + exact.fy * exact.fy);
  if (size == 0) return g.fx == 0 && g.fy == 0 ? 0 : infinity;
  return static_cast<double>(sqrt(dx * dx + dy * dy) / size) * 0x1p53;
}

// Below 1e-290 of its scale a result is subnormal or close to it.
bool too_small(const Real50& value, double scale) { return abs(value) < 1e-290 * std::max(scale, 1.0); }

class RoundPatchOf : public ::testing::TestWithParam<Kind> {
 protected:
  static const PowerFamily<Real50>& exact() {  // a quarter of a second to make
    static std::map<double, PowerFamily<Real50>> families;
    return families.try_emplace(GetParam().n, GetParam().n).first->second;
  }
};

INSTANTIATE_TEST_SUITE_P(, RoundPatchOf, ::testing::ValuesIn(kinds),
                         [](const auto& instance) { return instance.param.name; });

TEST_P(RoundPatchOf, ForceAndMomentAreGoodToEightUnitsAtEveryPole) {
  double worst_force = 0, worst_moment = 0;
  for (const double radius : radii) {
    const Disc disc = GetParam().of_radius(radius);
    for (const double x : pole_distances()) {
      for (const Twist& v : twists(radius, x)) {
        const Wrench g = disc.gradient(v);
        const Wrench50 reference = round_wrench(exact(), radius, v);
        if (!too_small(hypot(reference.fx, reference.fy), 1)) {
          const double units = force_units(g, reference);
          EXPECT_LE(units, 8) << "force at " << x << " radii of " << radius;
          worst_force = std::max(worst_force, units);
        }
        if (!too_small(reference.m, radius)) {
          const double units = units_of_rounding(g.m, reference.m);
          EXPECT_LE(units, 8) << "moment at " << x << " radii of " << radius;
          worst_moment = std::max(worst_moment, units);
        }
      }
    }
  }
  RecordProperty("worst_units_of_force", std::to_string(worst_force));
  RecordProperty("worst_units_of_moment", std::to_string(worst_moment));
}

TEST_P(RoundPatchOf, ForceAndMomentAreGoodToEightUnitsAtRandomPoles) {
  std::mt19937_64 engine(20060103);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto log_uniform = [&](double lo, double hi) { return lo * std::pow(hi / lo, unit(engine)); };
  double worst = 0;
  for (int i = 0; i < 4; ++i) {
    const double radius = log_uniform(1e-6, 1e3);
    const Disc disc = GetParam().of_radius(radius);
    for (int j = 0; j < 100; ++j) {
      const double away = log_uniform(1e-16, 1);
      const double x = j % 4 == 0 ? 1 - away : j % 4 == 1 ? 1 + away : log_uniform(1e-3, 1e3);
      const double angle = 2 * std::numbers::pi * unit(engine);
      const Twist v = twist_about({radius * x * std::cos(angle), radius * x * std::sin(angle)}, log_uniform(1e-3, 1e3));
      const Wrench g = disc.gradient(v);
      const Wrench50 reference = round_wrench(exact(), radius, v);
      worst = std::max({worst, force_units(g, reference), units_of_rounding(g.m, reference.m)});
    }
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 8);
}

// x inside and u beyond the rim; 1 - y is exact from 1/2 on.
const std::vector<double> curve_places{0,    1e-300, 1e-9,     0.01,      0.3,         0.5,
                                       0.77, 0.99,   1 - 1e-6, 1 - 1e-12, 1 - 0x1p-53, 1};

TEST_P(RoundPatchOf, TheLimitCurveIsGoodToEightUnits) {
  const Disc disc = GetParam().of_radius(1);
  for (const double y : curve_places) {
    SCOPED_TRACE(y);
    const CurvePoint in = disc.curve_inside(y), out = disc.curve_outside(y);
    const kernels::RoundValues<Real50> i = exact().inside(1 - Real50(y)), o = exact().outside(1 - Real50(y));
    EXPECT_LE(units_of_rounding(in.f, i.force * y), y == 1e-300 ? infinity : 8);
    EXPECT_LE(units_of_rounding(in.m, i.moment), 8);
    EXPECT_LE(units_of_rounding(out.f, o.force), 8);
    EXPECT_LE(units_of_rounding(out.m, o.moment * y), 8);
    if (y == 1) continue;  // the limit of a power or a logarithm, which the reference does not take
    EXPECT_LE(units_of_rounding(in.slope, i.slope), 16);
    EXPECT_LE(units_of_rounding(out.slope, o.slope), 16);
  }
}

// By central differences in 50 digits, inside of it also where x = 1.
TEST_P(RoundPatchOf, TheBendOfTheLimitCurveIsTheDerivativeOfItsSlope) {
  const Disc disc = GetParam().of_radius(1);
  const Real50 h = 1e-14;
  for (const double y : {1e-9, 0.01, 0.3, 0.77, 0.99, 0.999999}) {
    const double in = disc.curve_inside(y).bend, out = disc.curve_outside(y).bend;
    const auto bend = [&](const auto& slope) { return static_cast<double>((slope(y + h) - slope(y - h)) / (2 * h)); };
    if (!std::isnan(in)) {
      const double d = bend([&](const Real50& x) { return exact().inside(1 - x).slope; });
      EXPECT_NEAR(in, d, 1e-9 * std::fabs(d) + 1e-15) << y;
    }
    if (!std::isnan(out)) {
      const double d = bend([&](const Real50& u) { return exact().outside(1 - u).slope; });
      EXPECT_NEAR(out, d, 1e-9 * std::fabs(d) + 1e-15) << y;
    }
  }
}

TEST_P(RoundPatchOf, CarriesTheBoundOfItsHeader) {
  const Disc disc = GetParam().of_radius(0.02);
  for (const double x : {0.3, 1.0, 40.0}) {
    const BoundedWrench g = disc.bounded_gradient(twist_about({0.02 * x, 0}, 1));
    EXPECT_DOUBLE_EQ(g.force_error, 8 * 0x1p-53 * std::hypot(g.value.fx, g.value.fy));
    EXPECT_DOUBLE_EQ(g.moment_error, 8 * 0x1p-53 * std::fabs(g.value.m));
  }
}

TEST_P(RoundPatchOf, DissipationIsThePowerOfItsWrench) {
  const double radius = 0.0037;
  const Disc disc = GetParam().of_radius(radius);
  for (const double x : pole_distances()) {
    for (const Twist& v : twists(radius, x)) {
      const double D = power(disc.gradient(v), v);
      EXPECT_NEAR(disc.dissipation(v), D, 4 * 0x1p-53 * D) << x;
    }
  }
}

TEST_P(RoundPatchOf, SpeedScalesTheDissipationAndNothingElse) {
  const double radius = 0.0037;
  const Disc disc = GetParam().of_radius(radius);
  for (const double x : {1e-5, 0.7, 1.0, 1 + 1e-15, 3.0, 1e8, infinity}) {
    for (const Twist& v : twists(radius, x)) {
      const Wrench g = disc.gradient(v);
      const double D = disc.dissipation(v);
      const Hessian h = GetParam().n == -0.5 && x == 1 ? Hessian{} : disc.hessian(v);
      // Powers of two between 1e-200 and 1e200: to the last bit.
      for (const int e : {-664, -500, -100, 3, 450, 460, 664}) {
        const double k = std::ldexp(1.0, e);
        const Twist scaled{k * v.vx, k * v.vy, k * v.w};
        const Wrench s = disc.gradient(scaled);
        EXPECT_TRUE(s.fx == g.fx && s.fy == g.fy && s.m == g.m) << x << " scaled by 2^" << e;
        EXPECT_EQ(disc.dissipation(scaled), k * D) << x << " scaled by 2^" << e;
        if (h.xx == 0 && h.yy == 0) continue;
        EXPECT_LE(scaled_difference(disc.hessian(scaled), {h.xx / k, h.xy / k, h.xw / k, h.yy / k, h.yw / k, h.ww / k},
                                    scaled, radius),
                  0);
      }
      // Other factors round the twist: the wrench turns and the pole moves by that.
      for (const double k : {1e-200, 1e200}) {
        const Wrench s = disc.gradient({k * v.vx, k * v.vy, k * v.w});
        EXPECT_LE(std::hypot(s.fx - g.fx, s.fy - g.fy), 1e-14) << x << " scaled by " << k;
        EXPECT_LE(std::fabs(s.m - g.m), 1e-14 * radius) << x << " scaled by " << k;
      }
    }
  }
}

TEST_P(RoundPatchOf, AtRestItAnswersTheLeastSubgradientAndHasNoHessian) {
  const Disc disc = GetParam().of_radius(2);
  for (const Twist& rest : {Twist{}, Twist{-0.0, 0, -0.0}}) {
    const BoundedWrench g = disc.bounded_gradient(rest);
    EXPECT_TRUE(g.value.fx == 0 && g.value.fy == 0 && g.value.m == 0);
    EXPECT_EQ(g.force_error, 0);
    EXPECT_EQ(disc.dissipation(rest), 0);
    EXPECT_THROW(disc.hessian(rest), std::domain_error);
  }
}

TEST_P(RoundPatchOf, TheSmallestTwistsAreStillTwists) {
  const Disc disc = GetParam().of_radius(1);
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  const Wrench translation = disc.gradient({0, tiny, 0});
  EXPECT_EQ(translation.fx, 0);
  EXPECT_NEAR(translation.fy, 1, 8 * 0x1p-53);
  EXPECT_EQ(disc.gradient({0, 0, tiny}).m, disc.gradient({0, 0, 1}).m);
}

TEST_P(RoundPatchOf, NotANumberComesOutWhereItGoesIn) {
  const Disc disc = GetParam().of_radius(1);
  for (const Twist& v : {Twist{nan, 1, 1}, Twist{1, nan, 1}, Twist{1, 1, nan}, Twist{nan, nan, nan}, Twist{nan, 0, 0},
                         Twist{infinity, 1, 1}, Twist{1, 1, infinity}}) {
    const Wrench g = disc.gradient(v);
    EXPECT_TRUE(std::isnan(g.fx) && std::isnan(g.fy) && std::isnan(g.m)) << v.vx << ' ' << v.vy << ' ' << v.w;
    EXPECT_TRUE(std::isnan(disc.dissipation(v)));
    try {
      disc.hessian(v);
      ADD_FAILURE() << "a Hessian at " << v.vx << ' ' << v.vy << ' ' << v.w;
    } catch (const std::domain_error& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("twist is not finite"), std::string::npos);
    }
  }
}

TEST_P(RoundPatchOf, HessianEqualsDifferencesOfTheExactGradient) {
  for (const double radius : {1.0, 0.0037}) {
    const Disc disc = GetParam().of_radius(radius);
    const auto gradient = [&](const Real50& vx, const Real50& vy, const Real50& w) {
      return round_wrench(exact(), radius, vx, vy, w);
    };
    for (const double x : {0.0, 1e-12, 0.1, 0.5, 0.99, 1.01, 1.5, 20.0, 1e3, 1e8, infinity}) {
      for (const Twist& v : twists(radius, x)) {
        const Hessian h = hessian_by_differences(gradient, v, radius);
        EXPECT_LE(scaled_difference(disc.hessian(v), h, v, radius), 64 * 0x1p-53 * scaled_size(h, v, radius)) << x;
      }
    }
  }
}

// Too near to the rim for differences: f' of the family itself, at the pole that the twist really has.
TEST_P(RoundPatchOf, HessianHoldsUpToTheRim) {
  const double radius = 0.0037;
  const Disc disc = GetParam().of_radius(radius);
  for (const double away : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    for (const double x : {1 - away, 1 + away}) {
      const Twist v = twist_about({0, radius * x}, 1);  // vx = radius x
      const Real50 V = v.vx;
      const Real50 W = radius;
      const Real50 slope =
          V <= W ? exact().inside((W - V) / W).slope : exact().outside((V - W) / V).slope * W * W * W / (V * V * V);
      // In the direction of v the second derivative is f' / W.
      EXPECT_LE(units_of_rounding(disc.hessian(v).xx, slope / W), 16) << x;
    }
  }
}

TEST_P(RoundPatchOf, HessianIsFlatAlongTheTwistAndNowhereConcave) {
  const double radius = 0.0037;
  const Disc disc = GetParam().of_radius(radius);
  for (const double x : pole_distances()) {
    for (const Twist& v : twists(radius, x)) {
      if (GetParam().n == -0.5 && std::fabs(x - 1) < 1e-14) continue;
      const Hessian h = disc.hessian(v);
      const double size = scaled_size(h, v, radius);
      EXPECT_LE(along_itself(h, v, radius), 8 * 0x1p-53 * size) << x;
      EXPECT_GE(least_curvature(h, v, radius), -16 * 0x1p-53 * size) << x;
    }
  }
}

// D of a Hertz disc of radius 1, from the closed forms of its header.
template <class X, class Y, class W>
auto hertz_dissipation(const X& vx, const Y& vy, const W& w, bool inside) {
  const auto x2 = (vx * vx + vy * vy) / (w * w);
  const auto x = sqrt(x2);
  const double pi = std::numbers::pi;
  if (inside) return w * (3 * pi / 16) * (1 + x2 - x2 * x2 / 8);
  return w * (3.0 / 64) * ((8 + 8 * x2 - x2 * x2) * asin(1 / x) + (14 + x2) * sqrt(x2 - 1));
}

TEST(HertzDisc, DerivativesAreThoseOfTheClosedFormInDualNumbers) {
  using boost::math::differentiation::make_ftuple;
  const HertzDisc disc = HertzDisc::of_radius(1);
  for (const Twist& v : {Twist{0.3, -0.2, 1.1}, Twist{0.01, 0.5, 0.6}, Twist{1.4, 0.9, 0.8}, Twist{-2, 0.3, 0.7}}) {
    const bool inside = std::hypot(v.vx, v.vy) < v.w;
    const auto variables = make_ftuple<double, 2, 2, 2>(v.vx, v.vy, v.w);
    const auto D = hertz_dissipation(std::get<0>(variables), std::get<1>(variables), std::get<2>(variables), inside);
    const auto derivative = [&D](int x, int y, int w) {
      return D.derivative(static_cast<std::size_t>(x), static_cast<std::size_t>(y), static_cast<std::size_t>(w));
    };
    EXPECT_NEAR(disc.dissipation(v), derivative(0, 0, 0), 1e-14);
    const Wrench g = disc.gradient(v);
    EXPECT_NEAR(g.fx, derivative(1, 0, 0), 1e-14);
    EXPECT_NEAR(g.fy, derivative(0, 1, 0), 1e-14);
    EXPECT_NEAR(g.m, derivative(0, 0, 1), 1e-14);
    const Hessian h = disc.hessian(v);
    EXPECT_NEAR(h.xx, derivative(2, 0, 0), 2e-14);
    EXPECT_NEAR(h.xy, derivative(1, 1, 0), 2e-14);
    EXPECT_NEAR(h.xw, derivative(1, 0, 1), 2e-14);
    EXPECT_NEAR(h.yy, derivative(0, 2, 0), 2e-14);
    EXPECT_NEAR(h.yw, derivative(0, 1, 1), 2e-14);
    EXPECT_NEAR(h.ww, derivative(0, 0, 2), 2e-14);
  }
}

TEST(HertzDisc, KnowsTheBendOfItsLimitCurveUpToTheRim) {
  const kernels::MoebiusKernel<kernels::HertzCoefficients> kernel;
  for (const double y : curve_places) {
    EXPECT_NEAR(kernel.inside(y).bend, -9 * std::numbers::pi / 16 * y, 1e-15);
    EXPECT_GE(kernel.outside(y).bend, 0);
  }
  // (3 u / 35) 2F1(3/2, 5/2; 9/2; u^2), at u = 1 by Gauss: Gamma(9/2) Gamma(1/2) / (Gamma(3) Gamma(2)) = 105 pi / 32.
  EXPECT_NEAR(kernel.outside(1).bend, 9 * std::numbers::pi / 32, 1e-11);
}

TEST(RimExcess, IsTheDifferenceOfSquaresWithoutTheirRounding) {
  std::mt19937_64 engine(20060103);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double radius = std::exp(4 * unit(engine) - 2);
    const double w = 2 * unit(engine) - 1;
    const double angle = 2 * std::numbers::pi * unit(engine);
    const double V = radius * std::fabs(w) * (1 + std::pow(10, -16 * unit(engine)) * (unit(engine) - 0.5) / 64);
    const double vx = V * std::cos(angle), vy = V * std::sin(angle);
    const Real50 W = Real50(radius) * w;
    const Real50 exact = Real50(vx) * vx + Real50(vy) * vy - W * W;
    // The tails, each 2^-53 of V^2, are rounded themselves.
    const Real50 allowed = abs(exact) * 0x1p-52 + Real50(V) * V * 0x1p-103;
    worst = std::max(worst, static_cast<double>(abs(rim_excess(vx, vy, w, radius) - exact) / allowed));
  }
  EXPECT_LE(worst, 1);
}

}  // namespace
}  // namespace patchgrip::friction
