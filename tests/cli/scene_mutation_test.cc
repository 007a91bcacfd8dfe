// Every line of every scene and of a material, mutated in many ways: a mutant is accepted, or refused with file and
// line. Nothing else.
#include <patchgrip/cli/scene/scene.h>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/cli/simulate/simulate_scene.h>

#include "scenes.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

Lines lines_of(const fs::path& file) {
  std::ifstream in(file);
  Lines lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// What stands in place of a value: every wrong type, and numbers at and past every edge.
constexpr std::array<std::string_view, 34> values{"nan",
                                                  "-nan",
                                                  "inf",
                                                  "-inf",
                                                  "-1",
                                                  "0",
                                                  "-0.0",
                                                  "1",
                                                  "1e999",
                                                  "-1e999",
                                                  "1e-999",
                                                  "1e308",
                                                  "1e-308",
                                                  "4.9e-324",
                                                  "9223372036854775807",
                                                  "9223372036854775808",
                                                  "\"text\"",
                                                  "\"\"",
                                                  "''",
                                                  "[]",
                                                  "[[]]",
                                                  "[1]",
                                                  "[1, 2, 3]",
                                                  "[[1, 2], 3]",
                                                  "{}",
                                                  "{ from = 0, to = 1, count = 3 }",
                                                  "{ from = 0, to = 1, count = 100000000 }",
                                                  "true",
                                                  "2020-01-01",
                                                  "07:32:00",
                                                  "0x10",
                                                  "[nan, nan]",
                                                  "\"\xc3\"",
                                                  "\"\"\"\n"};

class Mutator {
 public:
  explicit Mutator(const fs::path& file) : original_(lines_of(file)) {}

  // Calls `visit(name, text)` for every mutant, or for each in `stride`.
  void for_each(std::size_t stride, const std::function<void(const std::string&, const std::string&)>& visit) {
    std::mt19937_64 random(1);
    std::size_t count = 0;
    for (std::size_t i = 0; i < original_.size(); ++i) {
      const auto mutant = [&](const std::string& name, const std::function<void(Lines&)>& change) {
        Lines lines = original_;
        change(lines);
        if (++count % stride == 0) visit(fmt::format("line {} {}", i + 1, name), joined(lines));
      };
      mutant("deleted", [&](Lines& l) { l.erase(l.begin() + static_cast<std::ptrdiff_t>(i)); });
      mutant("doubled", [&](Lines& l) { l.insert(l.begin() + static_cast<std::ptrdiff_t>(i), l[i]); });
      mutant("moved to the end", [&](Lines& l) {
        l.push_back(l[i]);
        l.erase(l.begin() + static_cast<std::ptrdiff_t>(i));
      });
      const std::string& line = original_[i];
      if (const std::size_t equals = line.find('='); equals != std::string::npos) {
        for (const std::string_view value : values) {
          mutant(fmt::format("with {}", value),
                 [&](Lines& l) { l[i] = fmt::format("{} {}", line.substr(0, equals + 1), value); });
        }
        mutant("negated", [&](Lines& l) { l[i].insert(std::min(equals + 2, line.size()), 1, '-'); });
        mutant("misspelt", [&](Lines& l) { l[i].insert(0, 1, 'x'); });
      }
      if (line.starts_with('#')) continue;
      for (std::size_t length = 0; length < line.size(); length += 1 + line.size() / 24) {
        mutant("cut", [&](Lines& l) { l[i].resize(length); });
        mutant("cut with all that follows", [&](Lines& l) {
          l.resize(i + 1);
          l[i].resize(length);
        });
      }
      for (int repeat = 0; repeat < 15 && !line.empty(); ++repeat) {
        mutant("with random bytes", [&](Lines& l) {
          for (std::size_t bytes = 1 + random() % 4; bytes > 0; --bytes) {
            l[i][random() % l[i].size()] = static_cast<char>(random() % 256);
          }
        });
        mutant("with two swapped",
               [&](Lines& l) { std::swap(l[i][random() % l[i].size()], l[i][random() % l[i].size()]); });
      }
    }
  }

 private:
  Lines original_;
};

struct Tally {
  int accepted = 0;
  int refused = 0;
};

template <class Load>
Tally try_all(const fs::path& file, std::size_t stride, Load&& load) {
  Tally tally;
  Mutator(file).for_each(stride, [&](const std::string& name, const std::string& text) {
    try {
      load(text);
      ++tally.accepted;
    } catch (const SceneError& error) {
      ++tally.refused;
      EXPECT_GE(error.line(), 1U) << file << " " << name << ": " << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << file << " " << name << ": " << error.what();
    }
  });
  return tally;
}

std::vector<fs::path> files_in(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(test::data_folder / folder)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  return files;
}

class MutatedScene : public ::testing::TestWithParam<fs::path> {};

TEST_P(MutatedScene, IsAcceptedOrRefusedWithALine) {
  // A tabulated pressure takes up to 0.1 s to make: every line is mutated there too, but in fewer ways.
  const std::string name = GetParam().stem().string();
  const std::size_t stride = name == "discs_xydas_kao" || name == "discs_power" ? 6 : 1;
  const Tally tally = try_all(GetParam(), stride, [](const std::string& text) { test::scene_of(text); });
  EXPECT_GT(tally.accepted, 10);
  EXPECT_GT(tally.refused, 100);
}

INSTANTIATE_TEST_SUITE_P(Scene, MutatedScene, ::testing::ValuesIn(files_in("scenes")),
                         [](const auto& file) { return file.param.stem().string(); });

TEST(MutatedSimulation, IsAcceptedOrRefusedWithALine) {
  const MaterialLibrary library({test::data_folder / "materials"});
  for (const fs::path& file : files_in("scenes/simulate")) {
    const Tally tally = try_all(file, 5, [&](const std::string& text) {
      read_simulate_scene(TomlDocument::parse(text, file.string()), library);
    });
    EXPECT_GT(tally.accepted, 10) << file;
    EXPECT_GT(tally.refused, 100) << file;
  }
}

TEST(MutatedMaterial, IsAcceptedOrRefusedWithALine) {
  const fs::path folder = fs::path(::testing::TempDir()) / fmt::format("mutated_material_{}", ::getpid());
  fs::create_directories(folder);
  const MaterialLibrary library({folder});
  const Tally tally = try_all(test::data_folder / "materials" / "rubber.toml", 1, [&](const std::string& text) {
    std::ofstream(folder / "mutant.toml") << text;
    ASSERT_TRUE(library.find("mutant"));
  });
  EXPECT_GT(tally.refused, 50);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace patchgrip::cli
