// A fingertip that is fitted to points that scatter: what tabulate and limit say holds at every radius it may have.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/cli/friction_row.h>
#include <patchgrip/cli/limit/limit.h>
#include <patchgrip/tests/support/cases.h>

#include "limit_scenes.h"
#include "press_scenes.h"

namespace patchgrip::cli {
namespace {

using friction::XydasKaoDisc;
using testing::cases;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::log_uniform;
using testing::uniform;

// A factor from next to 1 to some units, under a force within the measured ones.
std::string scattered_contact(std::mt19937_64& engine) {
  const double c = log_uniform(engine, 1e-4, 1), gamma = uniform(engine, 0.15, 0.3);
  const double scatter = log_uniform(engine, 1e-3, 0.5);
  std::string points;
  for (int i = 0; i < 5; ++i) {
    const double F = std::pow(10, i - 2);
    points += fmt::format("[{}, {}], ", F, c * std::pow(F, gamma) * std::exp(uniform(engine, -scatter, scatter)));
  }
  const bool centred = uniform(engine, 0, 1) < 0.3;
  const auto offset = [&] { return centred ? 0 : c * log_uniform(engine, 1e-3, 10) * (uniform(engine, 0, 1) - 0.5); };
  return fmt::format(
      "[contact]\nfingertip = {{ measured = [{}], alpha = {}, confidence = {} }}\nnormal_force = {}\ncentre = [{}, "
      "{}]\n",
      points, uniform(engine, 1.5, 6), uniform(engine, 0, 1) < 0.5 ? 0.95 : 0.99, log_uniform(engine, 0.03, 30),
      offset(), offset());
}

// The contact as if its radius were known: either end of what the scatter allows, and somewhere between.
std::vector<Contact> of_known_radii(const Contact& contact, std::mt19937_64& engine) {
  const auto& own = std::get<XydasKaoDisc>(contact.patch);
  const double factor = contact.scatter->wide.area_radius() / own.radius();
  std::vector<Contact> known(3, contact);
  for (Contact& one : known) one.scatter.reset();
  known[0].patch = contact.scatter->narrow;
  known[1].patch = contact.scatter->wide;
  known[2].patch = XydasKaoDisc::of_radius(own.radius() * std::pow(factor, uniform(engine, -1, 1)), own.alpha());
  return known;
}

friction::Law any_law(std::mt19937_64& engine, double speed) {
  const double mu = uniform(engine, 0.1, 1);
  const auto law = uniform(engine, 0, 1) < 0.3
                       ? friction::Law::coulomb(mu)
                       : friction::Law::stribeck(mu, uniform(engine, 0, 1), speed * log_uniform(engine, 0.1, 10));
  return uniform(engine, 0, 1) < 0.7 ? law : law.with_viscous(log_uniform(engine, 1e-2, 1e2) / speed);
}

friction::BoundedWrench row_of(const Contact& contact, const friction::Law& law, const Motion& motion) {
  return visit_patch(contact.patch, contact.frame,
                     [&](const auto& patch) { return friction_row(contact, law, patch, motion); });
}

TEST(FingertipScatter, BoundsTheRowsOfTabulate) {
  std::mt19937_64 engine(20261127);
  double force_share = 0, moment_share = 0;  // of what is stated that it is off by
  for (int i = 0; i < cases(8); ++i) {
    const Contact contact = test::limit_scene(scattered_contact(engine)).contact;
    const std::vector<Contact> known_radii = of_known_radii(contact, engine);
    const double a = std::get<XydasKaoDisc>(contact.patch).radius();
    for (int k = 0; k < 60; ++k) {
      const double angle = uniform(engine, -4, 4), distance = k % 9 == 0 ? 0 : a * log_uniform(engine, 1e-3, 1e3);
      const friction::Pole pole{contact.frame.x + distance * std::cos(angle),
                                contact.frame.y + distance * std::sin(angle)};
      const int spin = k % 2 == 0 ? 1 : -1;
      const Motion motion{pole, spin, 1, friction::twist_about(pole, spin)};
      const friction::Law law = any_law(engine, a);
      const friction::BoundedWrench stated = row_of(contact, law, motion);
      for (const Contact& one : known_radii) {
        const friction::BoundedWrench known = row_of(one, law, motion);
        const double force = std::hypot(known.value.fx - stated.value.fx, known.value.fy - stated.value.fy);
        const double moment = std::fabs(known.value.m - stated.value.m);
        EXPECT_LE(force, stated.force_error + known.force_error);
        EXPECT_LE(moment, stated.moment_error + known.moment_error);
        force_share = std::max(force_share, force / (stated.force_error + known.force_error));
        moment_share = std::max(moment_share, moment / (stated.moment_error + known.moment_error));
      }
    }
  }
  EXPECT_GT(force_share, 0.9);
  EXPECT_GT(moment_share, 0.9);
}

std::string any_loads(std::mt19937_64& engine) {
  std::string text = "[friction]\nmu = 0.5\n";
  for (int i = 0; i < 15; ++i) {
    const double angle = uniform(engine, -4, 4), force = i % 7 == 3 ? 0 : 1;
    const double moment = i % 5 == 4 ? 0 : log_uniform(engine, 1e-5, 10) * (i % 2 == 0 ? 1 : -1);
    text += fmt::format("[[loads]]\nforce = [{}, {}]\nmoment = {}\n", force * std::cos(angle), force * std::sin(angle),
                        moment);
  }
  return text;
}

double share(double apart, double bound) { return apart > 0 ? apart / bound : 0; }

void expect_near(const Estimate& stated, const Estimate& known, double& worst) {
  const double apart = std::fabs(stated.value - known.value), bound = stated.error + known.error;
  EXPECT_LE(apart, bound);
  worst = std::max(worst, share(apart, bound));
}

TEST(FingertipScatter, BoundsTheAnswersOfLimit) {
  std::mt19937_64 engine(20261129);
  double of_all = 0, gauge = 0, margin = 0, stick = 0, speed = 0, spin = 0, pole = 0;  // shares, as above
  for (int i = 0; i < cases(8); ++i) {
    const LimitScene scene = test::limit_scene(scattered_contact(engine) + any_loads(engine));
    const LimitAnswer stated = answer_limit(scene);
    for (const Contact& one : of_known_radii(scene.contact, engine)) {
      LimitScene known_scene = scene;
      known_scene.contact = one;
      const LimitAnswer known = answer_limit(known_scene);
      ASSERT_EQ(known.contact.size(), stated.contact.size());
      for (std::size_t k = 0; k < stated.contact.size(); ++k) {
        const Result &a = stated.contact[k], &b = known.contact[k];
        expect_near({a.value, a.error}, {b.value, b.error}, of_all);
      }
      ASSERT_EQ(known.loads.size(), stated.loads.size());
      for (std::size_t k = 0; k < stated.loads.size(); ++k) {
        const LoadAnswer &a = stated.loads[k], &b = known.loads[k];
        SCOPED_TRACE(fmt::format("contact {}, load ({}, {}, {})", i, a.load.fx, a.load.fy, a.load.m));
        expect_near({a.gauge.value, a.gauge_error}, {b.gauge.value, b.gauge_error}, gauge);
        expect_near(a.margin, b.margin, margin);
        expect_near(a.stick_radius, b.stick_radius, stick);
        if (a.verdict != Verdict::undecided && b.verdict != Verdict::undecided) {
          EXPECT_EQ(a.verdict, b.verdict);
        }
        const Slip &u = a.slip, &v = b.slip;
        if (a.starts_one_slip() && b.starts_one_slip()) {
          expect_near({std::hypot(u.twist.vx - v.twist.vx, u.twist.vy - v.twist.vy), u.speed_error}, {0, v.speed_error},
                      speed);
          expect_near({u.twist.w, u.spin_error}, {v.twist.w, v.spin_error}, spin);
        }
        if (a.turns() && b.turns()) {
          expect_near({std::hypot(u.pole.x - v.pole.x, u.pole.y - v.pole.y), u.pole_error}, {0, v.pole_error}, pole);
        }
      }
    }
  }
  for (const double worst : {of_all, gauge, margin, speed, spin, pole}) EXPECT_GT(worst, 0.5);
  EXPECT_GT(stick, 0.05);
}

// What one scene says of warnings in each of the three.
std::vector<std::string> warnings_of(const std::string& keys, double force) {
  const std::string text =
      fmt::format("[contact]\nfingertip = {{ {} }}\nnormal_force = {}\ncentre = [1e-3, 0]\n", keys, force);
  const std::vector<std::string> warnings = press(test::press_scene(text)).answer.warnings;
  EXPECT_EQ(answer_limit(test::limit_scene(text + "[friction]\nmu = 1\n[[loads]]\nmoment = 1\n")).warnings, warnings);
  EXPECT_EQ(test::scene_of(text + "[friction]\nmu = 1\n[poles]\nlist = [[0, 0]]\n").contact.warnings, warnings);
  return warnings;
}

TEST(FingertipScatter, WarnsInEveryQuestion) {
  const std::string measured = "measured = [[0.2, 3.1e-3], [0.5, 4e-3], [1, 4.9e-3], [2, 6.1e-3], [8, 9e-3]]";
  EXPECT_THAT(warnings_of(measured, 3), IsEmpty());
  EXPECT_THAT(warnings_of(measured, 200), ElementsAre(HasSubstr("outside of the measured 0.2 .. 8 N")));
  EXPECT_THAT(warnings_of("measured = [[1, 4e-3], [2, 5e-3]]", 1), ElementsAre(HasSubstr("no confidence limits")));
  EXPECT_THAT(warnings_of("coefficient = 4e-3, exponent = 0.4", 1), ElementsAre(HasSubstr("exponent above 1/3")));
  EXPECT_THAT(warnings_of("measured = [[1, 4], [2, 4.6], [4, 5.3]]", 2), ElementsAre(HasSubstr("radii are in m")));
  EXPECT_THAT(warnings_of("measured = [[1, 4e-3], [2, 4.9e-3], [4, 5.3e-3]]", 8),
              ElementsAre(HasSubstr("a factor of 2.68 either way")));
}

TEST(FingertipScatter, BeyondAFactorOfTenIsRefusedByName) {
  const std::string text =
      "[contact]\nfingertip = { measured = [[1, 4e-3], [2, 6e-3], [4, 5.3e-3]] }\nnormal_force = 4\n";
  for (const auto& read : {+[](const std::string& scene) { (void)press(test::press_scene(scene)); },
                           +[](const std::string& scene) { (void)test::limit_scene(scene); }}) {
    try {
      read(text);
      FAIL();
    } catch (const SceneError& error) {
      EXPECT_THAT(error.what(),
                  HasSubstr(": the points scatter too much for a radius at F = 4 N: a factor of 12.3 at 95 %"));
    }
  }
}

}  // namespace
}  // namespace patchgrip::cli
