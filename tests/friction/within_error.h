// Stribeck's excess within the error that it carries.
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include <patchgrip/tests/friction/local_reference.h>

namespace patchgrip::friction {

// |found - exact| within the error that is stated, and that error of use. The exact one is good to `reference`.
inline void expect_within_error(const BoundedWrench& found, const LocalExcess& exact, double length, double of_use,
                                double reference = 1e-17) {
  EXPECT_LE(std::hypot(found.value.fx - exact.fx, found.value.fy - exact.fy), found.force_error + reference);
  EXPECT_LE(std::fabs(found.value.m - exact.m), found.moment_error + reference * length);
  EXPECT_LE(found.force_error, of_use);
  EXPECT_LE(found.moment_error, of_use * length);
}

}  // namespace patchgrip::friction
