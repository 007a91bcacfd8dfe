#include <patchgrip/contact/falling_root.h>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::Exact;

TEST(FallingRoot, IsFoundToTheLastDigits) {
  for (const double root : {1e-30, 0.3, 1., 7e20}) {
    const auto f = [&](double x) { return 1 - std::pow(x / root, 3); };
    EXPECT_NEAR(falling_root(f, root / 100, root * 37) / root, 1, 4 * 0x1p-52) << root;
  }
}

TEST(FallingRoot, IsFoundInFiftyDigits) {
  const Exact root = falling_root<Exact>([](const Exact& x) -> Exact { return 2 - x * x; }, 1, 2);
  EXPECT_LE(static_cast<double>(abs(Exact(root * root - 2))), 1e-48);
}

TEST(FallingRoot, OfASignThatDoesNotChangeIsAnEnd) {
  EXPECT_EQ(falling_root([](double) { return -1.; }, 1., 2.), 1);
  EXPECT_EQ(falling_root([](double) { return 1.; }, 1., 2.), 2);
  EXPECT_EQ(falling_root([](double x) { return 1 - x; }, 1., 2.), 1);
}

TEST(FallingRoot, JumpsAreFoundToo) {
  EXPECT_NEAR(falling_root([](double x) { return x < 0.7 ? 1. : -2.; }, 0., 1.), 0.7, 4 * 0x1p-53);
}

}  // namespace
}  // namespace patchgrip::contact
