// Every number of a committed scene, replaced by far-off values: the scene must be answered or refused at its place.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/cli/unanswered.h>
#include <patchgrip/tests/support/cases.h>

#include "scenes.h"

namespace patchgrip::cli::test {

// Calls `visit` with `text` once for each of its numbers and each far-off value in place of it. Counts stay, as they
// say how long it takes.
inline void for_each_far_off(const std::string& text, const std::function<void(const std::string&)>& visit) {
  static constexpr std::array<std::string_view, 12> values{"0",    "-1",   "0.5", "2",   "1e-60", "1e-30",
                                                           "1e-9", "1e-3", "1e3", "1e9", "1e30",  "1e60"};
  static const std::regex number(R"((#[^\n]*|"[^"\n]*"|count = \d+|\bE_?\d|\bJ_0)|-?\b\d+(?:\.\d+)?(?:e-?\d+)?)");
  for (std::sregex_iterator at(text.begin(), text.end(), number); at != std::sregex_iterator(); ++at) {
    if ((*at)[1].matched) continue;
    const auto begin = static_cast<std::size_t>(at->position());
    const std::size_t end = begin + static_cast<std::size_t>(at->length());
    for (const std::string_view value : values) visit(text.substr(0, begin) + std::string(value) + text.substr(end));
  }
}

// A folder like data/scenes with the files that scenes name, but without scenes.
class FolderOfFiles {
 public:
  FolderOfFiles() : path_(std::filesystem::path(::testing::TempDir()) / fmt::format("far_off_{}", ::getpid())) {
    for (const char* folder : {"limit", "press"}) {
      std::filesystem::create_directories(path_ / folder);
      for (const auto& entry : std::filesystem::directory_iterator(data_folder / "scenes" / folder)) {
        if (entry.path().extension() == ".toml") continue;
        std::filesystem::copy_file(entry.path(), path_ / folder / entry.path().filename(),
                                   std::filesystem::copy_options::overwrite_existing);
      }
    }
  }
  ~FolderOfFiles() { std::filesystem::remove_all(path_); }
  FolderOfFiles(const FolderOfFiles&) = delete;
  FolderOfFiles& operator=(const FolderOfFiles&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// `scene` as "limit/ring"; `run(file, folder)` may write into the folder; `tables` of a scene that may be refused, as
// "contact|load"; one in `stride` of the mutants is tried.
template <class Run>
void expect_far_off_numbers_answered_or_refused(const std::string& scene, const std::string& original, int stride,
                                                const std::string& tables, Run&& run) {
  const FolderOfFiles files;
  const std::filesystem::path file = files.path() / (scene + ".toml");
  const std::regex place("^(" + tables + ")\\b");
  int refused = 0, number = 0;
  for_each_far_off(original, [&](const std::string& text) {
    if (++number % stride != 0) return;
    std::ofstream(file) << text;
    try {
      run(file.string(), file.parent_path());
    } catch (const SceneError& error) {
      ++refused;
      EXPECT_GE(error.line(), 1U) << error.what();
      const std::string message = error.what();
      const std::string told = message.substr(std::min(message.size(), message.find(": ") + 2));
      EXPECT_TRUE(std::regex_search(told, place)) << message;
    } catch (const Unanswered& error) {
      EXPECT_TRUE(std::regex_search(error.what(), std::regex(":[0-9]+: (" + tables + ")\\b"))) << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << '\n' << text;
    }
  });
  if (patchgrip::testing::all_cases()) {
    EXPECT_GT(refused, 0);
  }
}

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace patchgrip::cli::test
