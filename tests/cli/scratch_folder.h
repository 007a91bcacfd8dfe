// A folder of its own for the files of a test, removed at its end.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <patchgrip/cli/press/press_scene.h>

#include "scenes.h"

namespace patchgrip::cli::test {

class ScratchFolder : public ::testing::Test {
 protected:
  ScratchFolder()
      : folder_(std::filesystem::temp_directory_path() /
                ("patchgrip_" + std::to_string(::getpid()) + "_" +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(folder_);
  }
  ~ScratchFolder() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  // A scene of `patchgrip press` that lies in the folder.
  PressScene press_scene_here(std::string text) const {
    return read_press_scene(TomlDocument::parse(std::move(text), (folder_ / "scene.toml").string()),
                            MaterialLibrary({data_folder / "materials"}));
  }

  std::filesystem::path folder_;
};

}  // namespace patchgrip::cli::test
