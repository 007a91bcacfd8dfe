// Laws of a point against the table, and what holds of them.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <patchgrip/dynamics/point_bristle.h>
#include <patchgrip/tests/dynamics/dynamics_table.h>

namespace patchgrip::dynamics {
namespace {

TEST(PointLaw, AgreesWithTheTable) {
  const auto& laws = table()["point_laws"];
  const auto& p = laws["parameters"];
  const Law law = Law::stribeck(number(p["muH"]), number(p["muG"]), number(p["vS"])).with_viscous(number(p["muV"]));
  const double F = number(p["FN"]);
  const PointBristle bristle{number(p["c0"]), number(p["c1"]), 0, number(p["k1f"]), number(p["nu0"])};
  for (const auto& row : laws["rows"]) {
    const double v = number(row["v"]), kappa = number(row["kappa"]);
    const auto expect = [&](const char* key, double found, double scale) {
      EXPECT_NEAR(found, number(row[key]), 4e-15 * scale) << key << " at " << v;
    };
    expect("coulomb", coulomb_force(law, F, v), F);
    expect("stribeck", stribeck_force(law, F, v), F);
    expect("viscous", viscous_force(law, F, v), F);
    expect("tanh_stribeck", tanh_force(law, F, number(p["a"]), v), F);
    expect("slope_SV", friction_slope(law, F, v), F / law.stribeck_velocity);
    const double nu = half_freedom_gain(bristle, law, F, v);
    // c_1 and the slope cancel.
    expect("nu_4_36", nu, std::fabs(nu) * (1 + 2 * bristle.c1 * std::fabs(v * nu) / F));
    expect("kdot_half_dof_linearised_alpha1", half_freedom_rate(bristle, law, F, 1, kappa, v),
           std::fabs(nu * v) * (1 + 2 * bristle.c1 * std::fabs(v * nu) / F));
    expect("beta", plastic_share(bristle, stribeck_force(law, F, v), kappa, v), 1);
    const double elastoplastic = elastoplastic_rate(bristle, law, F, kappa, v);
    expect("kdot_elastoplastic", elastoplastic, std::fabs(v));
    expect("R_F_elastoplastic", bristle_force(bristle, law, F, kappa, elastoplastic, v), F);
    const double extended = extended_rate(bristle, law, F, kappa, v);
    expect("kdot_nu0", extended, bristle.nu0 * std::fabs(v));
    expect("R_F_nu0", bristle_force(bristle, law, F, kappa, extended, v), F);
    expect("kdot_dahl_lugre_beta1", dahl_rate(bristle, law, F, kappa, v), std::fabs(v));
  }
}

TEST(PointLaw, OpposesTheVelocityAndIsOdd) {
  const Law law = Law::stribeck(0.9, 0.4, 0.02).with_viscous(0.05);
  for (double v = 1e-9; v < 1e3; v *= 3) {
    for (const double f : {coulomb_force(law, 20, v), stribeck_force(law, 20, v), viscous_force(law, 20, v),
                           tanh_force(law, 20, 60, v), karnopp_force(law, 20, 0, 0, v)}) {
      EXPECT_LT(f, 0);
    }
    EXPECT_EQ(stribeck_force(law, 20, -v), -stribeck_force(law, 20, v));
    EXPECT_EQ(tanh_force(law, 20, 60, -v), -tanh_force(law, 20, 60, v));
  }
  EXPECT_EQ(stribeck_force(law, 20, 0), 0);
}

TEST(PointLaw, SlopeIsTheDerivative) {
  const Law law = Law::stribeck(0.9, 0.4, 0.02).with_viscous(0.05);
  for (const double v : {0.001, 0.01, 0.03, 0.1, -0.02}) {
    const auto f = [&](double x) { return stribeck_force(law, 20, x) + viscous_force(law, 20, x); };
    const double h = 1e-5 * std::fabs(v);
    EXPECT_NEAR(friction_slope(law, 20, v), (f(v + h) - f(v - h)) / (2 * h), 1e-6 * 20 / 0.02);
  }
}

TEST(PointLaw, KarnoppHoldsWhatIsBelowTheLimit) {
  const Law law = Law::stribeck(0.8, 0.3, 1);
  EXPECT_EQ(karnopp_force(law, 10, 0.002, 1.1, 0.001), -1.1);
  EXPECT_EQ(karnopp_force(law, 10, 0.002, 9, 0.001), -3);
  EXPECT_EQ(karnopp_force(law, 10, 0.002, 1.1, -0.003), 3);
}

// Sliding steadily the bristle carries Stribeck's force, whatever nu_0 is.
TEST(PointBristle, TendsToTheStribeckForce) {
  const Law law = Law::stribeck(0.9, 0.4, 0.02);
  const PointBristle bristle{3e4, 40, 0, 0.8, 2.5};
  for (const double v : {0.05, -0.01}) {
    for (const auto rate : {dahl_rate, elastoplastic_rate, extended_rate}) {
      double kappa = 0;
      for (int i = 0; i < 20000; ++i) kappa += 1e-4 * rate(bristle, law, 20, kappa, v);
      EXPECT_NEAR(bristle.c0 * kappa, stribeck_force(law, 20, v), 1e-6 * 20);
    }
  }
}

TEST(PointBristle, SticksElasticallyBelowItsElasticShare) {
  const Law law = Law::coulomb(0.5);
  const PointBristle bristle{1e4, 0, 0, 0.9};
  const double end = 5 / bristle.c0;
  EXPECT_EQ(elastoplastic_rate(bristle, law, 10, -0.89 * end, 0.3), -0.3);
  EXPECT_EQ(elastoplastic_rate(bristle, law, 10, -end, 0.3), 0);
  EXPECT_EQ(elastoplastic_rate(bristle, law, 10, end, 0.3), -0.3);
  EXPECT_NEAR(plastic_share(bristle, -5, -0.95 * end, 0.3), 0.5, 1e-14);
}

// Whatever it was bent to: the limit of a bristle that yields as nothing presses any more, not an ideal spring.
TEST(PointBristle, CarriesNothingWhereNothingPresses) {
  const PointBristle bristle{1e4, 10, 1, 0.9, 1.5};
  for (const auto& [law, force] :
       {std::pair{Law::stribeck(0.9, 0.4, 0.02).with_viscous(0.1), 0.}, {Law::coulomb(0), 20.}}) {
    for (const auto rate : {dahl_rate, elastoplastic_rate, extended_rate}) {
      for (const double kappa : {-1e-3, 0., 1e-3}) {
        for (const double v : {-0.3, 0., 2.}) {
          EXPECT_EQ(rate(bristle, law, force, kappa, v), 0) << kappa << v;
          EXPECT_EQ(bristle_force(bristle, law, force, kappa, rate(bristle, law, force, kappa, v), v), 0);
        }
      }
    }
  }
}

// The viscous part of friction needs no dry one.
TEST(PointBristle, ViscousFrictionActsAlone) {
  const Law law = Law::coulomb(0).with_viscous(0.1);
  const double F = 20, kappa = 2e-4;
  const PointBristle bristle{1e4, 10, 0.5, 0.9, 1.5}, half{1e4, 10};
  for (const double v : {-0.3, 0., 2.}) {
    for (const auto rate : {dahl_rate, elastoplastic_rate, extended_rate})
      EXPECT_EQ(bristle_force(bristle, law, F, kappa, rate(bristle, law, F, kappa, v), v), -0.5 * 0.1 * F * v);
    const double zone = v + half_freedom_exact_rate(half, law, F, kappa, v);
    EXPECT_NEAR(bristle_pull(half, kappa, zone - v), -0.1 * F * zone, 1e-13);
    EXPECT_NEAR(zone, (half.c1 * v - half.c0 * kappa) / (half.c1 + 0.1 * F), 1e-14);
  }
}

// Half a degree of freedom: the root solves the balance of the zone, and the zone sticks exactly below mu_s F_N.
TEST(PointBristle, TheZoneOfHalfADegreeOfFreedomIsInBalance) {
  const Law law = Law::stribeck(0.9, 0.4, 0.02).with_viscous(0.05);
  const PointBristle bristle{3e4, 500};
  for (const double kappa : {-1e-3, -4e-4, 0., 3e-4}) {
    for (const double v : {-0.3, -0.01, 0., 0.002, 0.05, 2.}) {
      const double rate = half_freedom_exact_rate(bristle, law, 20, kappa, v), u = v + rate;
      const double force = bristle_pull(bristle, kappa, rate);
      if (std::fabs(bristle.c0 * kappa - bristle.c1 * v) <= 18) {
        EXPECT_EQ(rate, -v);
        EXPECT_LE(std::fabs(force), 18);
      } else {
        EXPECT_NEAR(force, stribeck_force(law, 20, u) + viscous_force(law, 20, u), 1e-12 * 500);
        EXPECT_LE(force * u, 0);
      }
    }
  }
}

// It sticks where the exact law does, and beyond 1.01 of that errs with the square of how much slower the zone slides.
TEST(PointBristle, TheLinearisedHalfFreedomIsTheExactOneToFirstOrder) {
  const Law law = Law::stribeck(0.9, 0.4, 0.2).with_viscous(0.05);
  const PointBristle bristle{3e4, 500};
  EXPECT_EQ(half_freedom_linearised_rate(bristle, law, 20, 3e-4, 0.002), -0.002);
  EXPECT_EQ(half_freedom_linearised_rate(bristle, law, 20, 0, 0), 0);
  for (const double v : {-0.3, 0.1, 2.}) {
    const double steady = (stribeck_force(law, 20, v) + viscous_force(law, 20, v)) / bristle.c0;
    EXPECT_NEAR(half_freedom_linearised_rate(bristle, law, 20, steady, v), 0, 1e-14);
    const auto error = [&](double off) {
      const double exact = half_freedom_exact_rate(bristle, law, 20, steady * (1 + off), v);
      EXPECT_GT(std::fabs(exact), 1e-7);
      return std::fabs(half_freedom_linearised_rate(bristle, law, 20, steady * (1 + off), v) - exact);
    };
    EXPECT_LE(error(1e-3), 3e-2 * error(1e-2) + 1e-15) << v;
  }
}

// Smoothed friction of a boundary layer: that of the law beyond a few 1 / a.
TEST(PointBristle, ABoundaryLayerRubsByTheLaw) {
  const Law law = Law::stribeck(0.9, 0.4, 0.02).with_viscous(0.05);
  const BoundaryLayer zone{1e-3, 1e4};
  for (const double u : {-0.5, 0.01})
    EXPECT_NEAR(boundary_layer_force(zone, law, 20, u), stribeck_force(law, 20, u) + viscous_force(law, 20, u), 1e-12);
  EXPECT_EQ(boundary_layer_force(zone, law, 20, 0), 0);
}

TEST(PointBristle, TheSwitchRampsWithinAPercent) {
  EXPECT_EQ(switch_ramp(0.3), 0);
  EXPECT_EQ(switch_ramp(1), 0);
  EXPECT_NEAR(switch_ramp(1.005), 0.5, 1e-12);
  EXPECT_EQ(switch_ramp(1.02), 1);
}

TEST(PointBristle, BadInputIsRefused) {
  EXPECT_THROW(PointBristle{0}.check(), std::invalid_argument);
  EXPECT_THROW((PointBristle{1, -1}.check()), std::invalid_argument);
  EXPECT_THROW((PointBristle{1, 0, 2}.check()), std::invalid_argument);
  EXPECT_THROW((PointBristle{1, 0, 0, 1}.check()), std::invalid_argument);
  EXPECT_THROW((PointBristle{1, 0, 0, 0.9, 0}.check()), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::dynamics
