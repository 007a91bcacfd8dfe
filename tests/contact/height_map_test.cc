#include <patchgrip/contact/half_space/height_map.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace patchgrip::contact {
namespace {

HeightMap read(const std::string& text) {
  std::istringstream in(text);
  return HeightMap::read(in, "map.csv");
}

std::string row(int columns, const std::string& number = "1e-6") {
  std::string text = number;
  for (int i = 1; i < columns; ++i) text += "," + number;
  return text + "\n";
}

std::string rows(int count, int columns) {
  std::string text;
  for (int j = 0; j < count; ++j) text += row(columns);
  return text;
}

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

TEST(HeightMap, IsReadRowByRow) {
  std::string text = "# heights [m]\r\n\n";
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 8; ++i) text.append(i == 0 ? " " : " ,\t").append(std::to_string(10 * j + i)).append("e-6");
    text += j % 2 == 0 ? "\r\n" : "  \n";
  }
  const HeightMap map = read(text);
  EXPECT_EQ(map.nx, 8);
  EXPECT_EQ(map.ny, 9);
  const Grid grid = map.grid(1e-6, 2e-6);
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 8; ++i)
      EXPECT_EQ(map.heights[grid.index(i, j)], std::stod(std::to_string(10 * j + i).append("e-6")));
  }
  const auto gap = map.gap_below_flat();
  EXPECT_EQ(gap[grid.index(7, 8)], 0);
  EXPECT_EQ(gap[0], 87e-6);
}

TEST(HeightMap, LastLineNeedsNoEnd) {
  std::string text = rows(8, 8);
  text.pop_back();
  EXPECT_EQ(read(text).ny, 8);
}

TEST(HeightMap, AByteOrderMarkIsNoNumber) {
  EXPECT_EQ(read("\xEF\xBB\xBF" + rows(8, 8)).heights, read(rows(8, 8)).heights);
  EXPECT_THAT([] { read(row(8) + "\xEF\xBB\xBF" + row(8)); }, refused("map.csv:2: column 1: '\xEF\xBB\xBF"
                                                                      "1e-6' is not a number"));
}

TEST(HeightMap, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT([] { read(""); }, refused("map.csv:0: 0 rows, must be at least 8"));
  EXPECT_THAT([] { read(rows(7, 8)); }, refused("map.csv:7: 7 rows, must be at least 8"));
  EXPECT_THAT([] { read(std::string("\n").append(rows(8, 7))); }, refused("map.csv:2: 7 columns, must be at least 8"));
  EXPECT_THAT([] { read(std::string("#\n").append(rows(3, 8)).append(row(9))); },
              refused("map.csv:5: 9 columns, but line 2 has 8"));
  EXPECT_THAT([] { read(rows(3, 8) + row(7)); }, refused("map.csv:4: 7 columns, but line 1 has 8"));
  EXPECT_THAT([] { read(row(8) + "1,2,x3,4,5,6,7,8\n"); }, refused("map.csv:2: column 3: 'x3' is not a number"));
  EXPECT_THAT([] { read(row(8) + "1,2,3 4,4,5,6,7,8\n"); }, refused("map.csv:2: column 3: '3 4' is not a number"));
  EXPECT_THAT([] { read("1;2;3\n"); }, refused("map.csv:1: column 1: '1;2;3' is not a number"));
  EXPECT_THAT([] { read("1,2,,4,5,6,7,8\n"); }, refused("map.csv:1: column 3 is empty: a comma too many"));
  EXPECT_THAT([] { read("1,2,3,4,5,6,7,8,\n"); }, refused("map.csv:1: column 9 is empty: a comma too many"));
  EXPECT_THAT([] { read(row(8, "nan")); }, refused("map.csv:1: column 1: 'nan' is not a finite double"));
  EXPECT_THAT([] { read(row(8, "-inf")); }, refused("map.csv:1: column 1: '-inf' is not a finite double"));
  EXPECT_THAT([] { read(row(8, "1e400")); }, refused("map.csv:1: column 1: '1e400' is not a finite double"));
  EXPECT_THAT([] { read(std::string(40, 'a').append("\x1b[2J")); },
              refused("map.csv:1: column 1: '" + std::string(30, 'a') + "...' is not a number"));
}

TEST(HeightMap, SizeIsLimited) {
  EXPECT_THAT([] { read(row(8193)); }, refused("map.csv:1: more than 8192 columns"));
  EXPECT_THAT([] { read(rows(8193, 8)); }, refused("map.csv:8193: more than 8192 rows"));
}

}  // namespace
}  // namespace patchgrip::contact
