#include <patchgrip/cli/scene/materials.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "scenes.h"

namespace patchgrip::cli {
namespace {

using ::testing::Contains;
using ::testing::IsSupersetOf;

const MaterialLibrary& library() {
  static const MaterialLibrary all({test::data_folder / "materials"});
  return all;
}

TEST(Materials, EveryOneOfTheRepositoryLoadsAndIsASolid) {
  EXPECT_THAT(library().names(), IsSupersetOf({"rubber", "glass", "steel"}));
  for (const std::string& name : library().names()) {
    const auto material = library().find(name);
    ASSERT_TRUE(material) << name;
    EXPECT_GT(material->youngs_modulus, 1e3) << name << ": is it in Pa?";
    EXPECT_LT(material->youngs_modulus, 2e12) << name;
    EXPECT_GE(material->poisson_ratio, 0) << name;
  }
}

TEST(Materials, HaveTheValuesOfTheirSource) {
  const auto steel = library().find("steel");  // Keppler 2006, Example 4.5
  ASSERT_TRUE(steel);
  EXPECT_EQ(steel->youngs_modulus, 200e9);
  EXPECT_EQ(steel->poisson_ratio, 0.3);
}

TEST(Materials, ANameIsNotAPath) {
  EXPECT_FALSE(library().find("../materials/rubber"));
  EXPECT_FALSE(library().find(""));
  EXPECT_FALSE(library().find("no_such_material"));
}

TEST(Materials, TheFirstFolderWins) {
  const MaterialLibrary both({"/nonexistent", test::data_folder / "materials"});
  EXPECT_TRUE(both.find("rubber"));
}

TEST(Materials, ComeWithTheInstalledProgramAndWithTheSourceTree) {
  EXPECT_EQ(material_folders_of("/opt/patchgrip/bin/patchgrip").front(), "/opt/patchgrip/share/patchgrip/materials");
  EXPECT_THAT(material_folders_of(test::data_folder.parent_path() / "build" / "release" / "bin" / "patchgrip"),
              Contains(test::data_folder / "materials"));
}

}  // namespace
}  // namespace patchgrip::cli
