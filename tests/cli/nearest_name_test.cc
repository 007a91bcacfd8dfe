#include <patchgrip/cli/scene/nearest_name.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>

namespace patchgrip::cli {
namespace {

constexpr std::array<std::string_view, 4> known{"radius", "normal_force", "mu", "mu_static"};

TEST(NearestName, OneSwapIsOneEdit) {
  EXPECT_EQ(edit_distance("radius", "raduis"), 1U);
  EXPECT_EQ(edit_distance("radius", "rdius"), 1U);
  EXPECT_EQ(edit_distance("radius", ""), 6U);
}

TEST(NearestName, FindsMisspeltNames) {
  EXPECT_EQ(nearest_name("raduis", known), "radius");
  EXPECT_EQ(nearest_name("normalforce", known), "normal_force");
  EXPECT_EQ(nearest_name("normal_forece", known), "normal_force");
  EXPECT_EQ(nearest_name("um", known), "mu");
}

TEST(NearestName, DoesNotGuessWildly) {
  EXPECT_EQ(nearest_name("temperature", known), std::nullopt);
  EXPECT_EQ(nearest_name("", known), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'x'), known), std::nullopt);
}

TEST(NearestName, ListsWhatIsKnownWhenNothingIsNear) {
  EXPECT_EQ(suggestion("temperature", known), "; known are 'radius', 'normal_force', 'mu', 'mu_static'");
  EXPECT_EQ(suggestion("raduis", known), "; did you mean 'radius'?");
  EXPECT_EQ(suggestion("raduis", {}), "");
}

RC_GTEST_PROP(NearestName, EditDistanceIsSymmetricAndBounded, (const std::string& a, const std::string& b)) {
  const std::size_t distance = edit_distance(a, b);
  RC_ASSERT(distance == edit_distance(b, a));
  RC_ASSERT(distance <= std::max(a.size(), b.size()));
  RC_ASSERT((distance == 0) == (a == b));
}

}  // namespace
}  // namespace patchgrip::cli
