// A scene that is refused, and where and why it has to say so.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli::test {

struct BadScene {
  std::string name;
  std::string text;
  std::size_t line;
  std::string message;  // part of it
};

inline void PrintTo(const BadScene& bad, std::ostream* out) { *out << bad.name; }

// `read(text)` has to throw the SceneError.
template <class Read>
void expect_refused(const BadScene& bad, Read&& read) {
  try {
    read(bad.text);
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_EQ(error.line(), bad.line) << error.what();
    EXPECT_THAT(error.what(), ::testing::HasSubstr(bad.message));
  }
}

}  // namespace patchgrip::cli::test
