#include <patchgrip/friction/any_patch.h>

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/tests/friction/any_patch.h>

namespace patchgrip::friction {
namespace {

const std::vector<Twist> motions{{0, 0, 1}, {0.01, 0.02, 1}, {0.6, 0.8, -1}, {30, 20, 1}, {1, 2, 0}, {0, 0, 0}};

void expect_same(const Wrench& a, const Wrench& b) { EXPECT_TRUE(a.fx == b.fx && a.fy == b.fy && a.m == b.m); }

void expect_same(const Hessian& a, const Hessian& b) {
  EXPECT_TRUE(a.xx == b.xx && a.xy == b.xy && a.xw == b.xw && a.yy == b.yy && a.yw == b.yw && a.ww == b.ww);
}

TEST(AnyPatch, AnswersAsThePatchItHolds) {
  for (const NamedPatch& p : every_patch()) {
    const AnyPatch any = std::visit([](const auto& patch) { return AnyPatch(patch); }, p.patch);
    for (const Twist& v : motions) {
      EXPECT_EQ(any.dissipation(v), p.dissipation(v));
      expect_same(any.gradient(v), p.gradient(v));
      const BoundedWrench g = any.bounded_gradient(v), h = p.bounded_gradient(v);
      expect_same(g.value, h.value);
      EXPECT_EQ(g.force_error, h.force_error);
      EXPECT_EQ(g.moment_error, h.moment_error);
    }
    expect_same(any.hessian({0.013, 0.02, 1}), p.hessian({0.013, 0.02, 1}));
    const PressureMoments s = any.moments(), t = p.moments();
    EXPECT_TRUE(s.x == t.x && s.y == t.y && s.polar == t.polar);
    EXPECT_EQ(any.area_radius(), p.area_radius());
  }
}

TEST(AnyPatch, RefusesWhatThePatchItHoldsRefuses) {
  EXPECT_THROW(AnyPatch(Ring::of_radius(1)).hessian({}), std::domain_error);
  EXPECT_THROW(AnyPatch(Ring::of_radius(1)).hessian({1, 0, 1}), std::domain_error);
}

TEST(AnyPatch, IsAValue) {
  AnyPatch any = Ring::of_radius(1);
  const AnyPatch copy = any;
  any = HertzDisc::of_radius(2);
  EXPECT_EQ(copy.area_radius(), 1);
  EXPECT_EQ(any.area_radius(), 2);
}

TEST(AnyPatch, ListsUnlikePatches) {
  const std::vector<AnyPatch> patches{HertzDisc::of_radius(1), Rectangle::of_sides(2, 1), l_shape.patch()};
  for (const AnyPatch& patch : patches) EXPECT_GT(patch.dissipation({0, 0, 1}), 0);
}

TEST(AnyPatch, IsPlacedAsAnyOther) {
  const PlanarFrame frame{3, -1, 0.5};
  const Twist v{0.3, -0.2, 0.7};
  expect_same(Placed(AnyPatch(l_shape.patch()), frame).gradient(v), Placed(l_shape.patch(), frame).gradient(v));
}

}  // namespace
}  // namespace patchgrip::friction
