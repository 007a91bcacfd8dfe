#include <patchgrip/cli/accuracy/number.h>

#include <gtest/gtest.h>

namespace patchgrip::cli {
namespace {

TEST(AccuracyNumber, KeepsAllDigits) {
  const auto value = parse_exact("0.1234567890123456789012345678901234567890");
  ASSERT_TRUE(value);
  EXPECT_EQ(*value * Exact("1e40"), Exact("1234567890123456789012345678901234567890"));
}

TEST(AccuracyNumber, ReadsDecimalsAndFractions) {
  EXPECT_EQ(*parse_exact("-1.5e-3") * 2000, -3);
  EXPECT_EQ(*parse_exact(".5"), 0.5);
  EXPECT_EQ(*parse_exact("+5."), 5);
  EXPECT_EQ(*parse_exact("5E2"), 500);
  EXPECT_EQ(*parse_exact("17/12") * 12, 17);
  EXPECT_EQ(*parse_exact("0"), 0);
}

TEST(AccuracyNumber, ReadsNothingElse) {
  for (const char* text : {"",   " ",   "+",   ".",   "e5",  "1e", "1e+", "1e12345", "0x10", "1.2.3", "1 ",
                           " 1", "1,5", "nan", "inf", "1/0", "1/", "/2",  "1/2/3",   "--1",  "1f",    "1_000"}) {
    EXPECT_FALSE(parse_exact(text)) << text;
  }
  EXPECT_FALSE(parse_exact(std::string(2000, '1')));
}

}  // namespace
}  // namespace patchgrip::cli
