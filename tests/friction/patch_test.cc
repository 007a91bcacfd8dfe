#include <patchgrip/friction/patch.h>

#include <gtest/gtest.h>

#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/seed_hertz_disc.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>

namespace patchgrip::friction {
namespace {

template <class P>
class EveryPatch : public ::testing::Test {};

using Types = ::testing::Types<HertzDisc, FlatPunchDisc, UniformDisc, Ring, PowerDisc, XydasKaoDisc, SeedHertzDisc,
                               Polygon, Rectangle, Placed<HertzDisc>, Placed<Ring>, Placed<Polygon>,
                               Placed<Placed<Rectangle>>, AnyPatch, Placed<AnyPatch>, Several, Placed<Several>>;
TYPED_TEST_SUITE(EveryPatch, Types);

TYPED_TEST(EveryPatch, ModelsTheConceptAndIsAValue) {
  EXPECT_TRUE(Patch<TypeParam>);
  EXPECT_TRUE(std::is_copy_constructible_v<TypeParam>);
  EXPECT_TRUE(std::is_copy_assignable_v<TypeParam>);
  EXPECT_TRUE(std::is_nothrow_move_constructible_v<TypeParam>);
}

TYPED_TEST(EveryPatch, IsMadeByItsFactoryAlone) { EXPECT_FALSE(std::is_default_constructible_v<TypeParam>); }

struct WithoutHessian {
  double dissipation(const Twist&) const noexcept { return 0; }
  Wrench gradient(const Twist&) const noexcept { return {}; }
  BoundedWrench bounded_gradient(const Twist&) const noexcept { return {}; }
  PressureMoments moments() const noexcept { return {}; }
  double area_radius() const noexcept { return 1; }
};

struct ThatMayThrow : WithoutHessian {
  Wrench gradient(const Twist&) const { return {}; }
  Hessian hessian(const Twist&) const { return {}; }
};

struct Whole : WithoutHessian {
  Hessian hessian(const Twist&) const { return {}; }
};

TEST(Patch, AsksForAllOfDAndItsDerivativesWithoutExceptions) {
  EXPECT_TRUE(Patch<Whole>);
  EXPECT_FALSE(Patch<WithoutHessian>);
  EXPECT_FALSE(Patch<ThatMayThrow>);
}

}  // namespace
}  // namespace patchgrip::friction
