// The gauge of any patch against the reference table, 50 digits and the laws of a convex body.
#include <patchgrip/friction/limit_surface/limit_surface.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/friction/limit_surface/loads.h>
#include <patchgrip/tests/friction/limit_surface/point_loads.h>

namespace patchgrip::friction {
namespace {

using ::patchgrip::testing::cases;

struct Row {
  Wrench load;
  double gauge;
  Pole pole;
};

template <class P>
void expect_rows(const P& patch, const std::vector<Row>& rows) {
  const LimitSurface surface(patch);
  for (const Row& row : rows) {
    const Gauge g = surface.gauge(row.load);
    EXPECT_EQ(g.status, GaugeStatus::converged);
    EXPECT_NEAR(g.value / row.gauge, 1, 4e-15);
    EXPECT_LE(g.lower, row.gauge * (1 + 0x1p-53));
    EXPECT_GE(g.upper, row.gauge * (1 - 0x1p-53));
    EXPECT_LE(g.upper - g.lower, 1.5e-12 * g.value);
    EXPECT_NEAR(-g.twist.vy / g.twist.w, row.pole.x, 1e-9 * patch.area_radius());
    EXPECT_NEAR(g.twist.vx / g.twist.w, row.pole.y, 1e-9 * patch.area_radius());
    EXPECT_NEAR(power(row.load, g.twist), g.value, 4e-15 * g.value);
    EXPECT_NEAR(patch.dissipation(g.twist), 1, 4e-15);
  }
}

// data/reference/friction.json, section gauge
TEST(LimitSurface, GaugeAgreesWithTheReferenceTable) {
  expect_rows(HertzDisc::of_radius(1),
              {{{0.49, 0, 0.05}, 0.50233123249985620134, {0, 2.045872184478627}},
               {{0.3, 0.4, 0.2}, 0.64118525286497914271, {-0.6248215797866896, 0.4686161848400172}},
               {{0.1, -0.05, 0.58}, 0.99371227669126280810, {0.04280792385990075, 0.08561584771980151}},
               {{0.9, 0.1, -0.05}, 0.91237039916352847336, {0.4051968938171593, -3.646772044354434}},
               {{0.2, 0.2, 0.9}, 1.5648320755696354606, {-0.1091378271801271, 0.1091378271801271}}});
  expect_rows(UniformDisc::of_radius(1),
              {{{0.5, 0.2, 0.3}, 0.75113854073936562680, {-0.2906857427253255, 0.7267143568133138}},
               {{0.05, 0, 0.66}, 0.99189062984858712385, {0, 0.05042481523964919}}});
  expect_rows(Rectangle::of_sides(0.04, 0.02),
              {{{0.5, 0.2, 0.006}, 0.75837805841733590641, {-0.006090736579555841, 0.01063607909332255}},
               {{0, 0.7, 0.004}, 0.85106912787372509452, {-0.01801872553630391, 0}},
               {{0.3, 0.3, -0.01}, 0.97903666054176063568, {0.006512315191444329, -0.004433853212602119}}});
  expect_rows(Rectangle::of_sides(0.1, 0.01),
              {{{0.5, 0.2, 0.009}, 0.6363891926757469533787, {-0.0197941000577737002, 0.0363783050439615364}},
               {{0.1, 0.8, 0.006}, 0.9260217505108992153476, {-0.0436263041332756758, 0.00233186100428234547}}});
  expect_rows(Polygon::uniform({{0, 0}, {0.03, 0}, {0.03, 0.01}, {0.01, 0.01}, {0.01, 0.02}, {0, 0.02}}),
              {{{0.3, 0.2, 0.004}, 0.58642742170184083202, {0.005723694444985123, 0.01469657747073322}},
               {{0.3, 0.2, -0.004}, 0.61247400435988808533, {0.01822925961423323, 0.001364196141493990}}});
  expect_rows(Polygon::uniform({{0, 0}, {0.04, 0}, {0.04, 0.03}, {0, 0.03}},
                               {{{0.01, 0.01}, {0.025, 0.01}, {0.025, 0.018}, {0.01, 0.018}}}),
              {{{0.5, 0.2, 0.006}, 0.9030282014169626169945, {0.0148206673169714297, 0.0265462904325910595}},
               {{0.5, 0.2, -0.006}, 0.5782655665694054792635, {0.0327571070376950587, -0.0137494041093928758}},
               {{0, 0, 0.01}, 0.6947687324256472522758, {0.0209256208310138200, 0.0154606767336199936}}});
  expect_rows(Polygon::uniform({{0, 0}, {0.03, 0.004}, {0.011, 0.021}}),
              {{{0.3, 0.5, 0.002}, 0.7143571138742161388702, {0.0233187308466867318, 0.00373564784626306499}},
               {{0, 0, -1}, 142.2282602134139543739, {0.0135743471255628357, 0.00850744938730119333}},
               {{-0.6, 0.2, 0.01}, 0.7273778590544917889409, {0.00905128058124025736, -0.00272142252878045843}}});
}

TEST(LimitSurface, NoLoadNeedsNoFriction) {
  const Gauge g = LimitSurface(HertzDisc::of_radius(1)).gauge({});
  EXPECT_EQ(g.value, 0);
  EXPECT_EQ(g.lower, 0);
  EXPECT_EQ(g.upper, 0);
  EXPECT_EQ(g.status, GaugeStatus::converged);
}

TEST(LimitSurface, LoadThatIsNotFiniteHasNoGauge) {
  const LimitSurface surface(HertzDisc::of_radius(1));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const Wrench& t : {Wrench{bad, 0, 0}, Wrench{0, bad, 1}, Wrench{1, 0, bad}}) {
      const Gauge g = surface.gauge(t);
      EXPECT_TRUE(std::isnan(g.value) && std::isnan(g.lower) && std::isnan(g.upper) && std::isnan(g.twist.w));
      EXPECT_EQ(g.status, GaugeStatus::not_finite);
    }
  }
}

// A power of two times a load has that times the gauge and its bracket, and the same slip.
template <class P>
void expect_every_size(const P& patch) {
  const LimitSurface surface(patch);
  std::mt19937_64 engine(17);
  for (int i = 0; i < cases(50); ++i) {
    const Wrench t = draw_load(engine, patch.moments());
    const Gauge g = surface.gauge(t);
    for (const int e : {-950, -700, -283, -100, 100, 283, 700, 900}) {
      const Wrench s{std::scalbn(t.fx, e), std::scalbn(t.fy, e), std::scalbn(t.m, e)};
      const Gauge at = surface.gauge(s);
      EXPECT_EQ(std::scalbn(at.value, -e), g.value) << e;
      EXPECT_EQ(std::scalbn(at.lower, -e), g.lower) << e;
      EXPECT_EQ(std::scalbn(at.upper, -e), g.upper) << e;
      EXPECT_EQ(at.twist.vx, g.twist.vx) << e;
      EXPECT_EQ(at.twist.vy, g.twist.vy) << e;
      EXPECT_EQ(at.twist.w, g.twist.w) << e;
      EXPECT_EQ(at.status, g.status) << e;
    }
  }
}

TEST(LimitSurface, GaugesOfEverySizeAreThatSizeTimesOne) {
  expect_every_size(Rectangle::of_sides(0.04, 0.02));
  expect_every_size(HertzDisc::of_radius(3));
  expect_every_size(point_scenes()[5].patch());
}

// The gauge of a force through the centroid is its size: in units of the least double, and beyond the largest.
TEST(LimitSurface, BracketsHoldOfGaugesThatAreSubnormalOrOverflow) {
  using Limits = std::numeric_limits<double>;
  const double unit = Limits::denorm_min();
  const LimitSurface surface(Rectangle::of_sides(0.04, 0.02));
  for (int x = 0; x < 12; ++x) {
    for (int y = x == 0 ? 1 : 0; y < 12; ++y) {
      const Gauge g = surface.gauge({x * unit, -y * unit, 0});
      EXPECT_LE(g.lower / unit, std::hypot(x, y)) << x << ' ' << y;
      EXPECT_GE(g.upper / unit, std::hypot(x, y)) << x << ' ' << y;
      EXPECT_LE((g.upper - g.lower) / unit, 3) << x << ' ' << y;
    }
  }
  const Gauge large = surface.gauge({1.5e308, 1.5e308, 0});
  EXPECT_EQ(large.lower, Limits::max());
  EXPECT_EQ(large.upper, Limits::infinity());
}

TEST(LimitSurface, SettingsOutOfRangeAreRefused) {
  const HertzDisc disc = HertzDisc::of_radius(1);
  EXPECT_THROW(LimitSurface(disc, {.relative_gap = 0}), std::invalid_argument);
  EXPECT_THROW(LimitSurface(disc, {.relative_gap = 1}), std::invalid_argument);
  EXPECT_THROW(LimitSurface(disc, {.max_evaluations = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
