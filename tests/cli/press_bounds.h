// Whether the errors that press states hold against fifty digits.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <boost/math/constants/constants.hpp>

#include <patchgrip/tests/support/exact.h>

#include "press_scenes.h"

namespace patchgrip::cli::test {

using testing::Exact;

inline const Exact pi = boost::math::constants::pi<Exact>();

inline void expect_within(double value, double error, const Exact& exact, const std::string& what) {
  EXPECT_TRUE(std::isfinite(value) && std::isfinite(error)) << what;
  EXPECT_LE(static_cast<double>(abs(Exact(value) - exact)), error) << what << " = " << value << " for " << exact;
}

inline void expect_within(const LawAnswer& law, std::string_view name, const Exact& exact, const std::string& what) {
  const Result& r = result(law, name);
  expect_within(r.value, r.error, exact, std::string(name) + ", " + what);
}

}  // namespace patchgrip::cli::test
