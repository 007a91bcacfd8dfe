#include <patchgrip/cli/output_file.h>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <patchgrip/cli/interrupt.h>

#include "scratch_folder.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;

using ::testing::HasSubstr;

class OutputFileTest : public test::ScratchFolder {
 protected:
  static std::string content(const std::string& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  static std::string refusal(const std::string& target) {
    try {
      OutputFile out(target);
      out.write("text");
      out.commit();
    } catch (const OutputError& error) {
      return error.what();
    }
    return "written";
  }
};

TEST_F(OutputFileTest, ACommittedFileHasItAll) {
  OutputFile out(path("table"));
  out.write("one ");
  out.write("two");
  EXPECT_FALSE(fs::exists(path("table")));
  out.commit();
  EXPECT_EQ(content(path("table")), "one two");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(OutputFileTest, WithoutCommitTheOldFileStaysAndNothingIsLeft) {
  std::ofstream(path("table")) << "old";
  {
    OutputFile out(path("table"));
    out.write("new");
  }
  EXPECT_EQ(content(path("table")), "old");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(OutputFileTest, ASymbolicLinkStaysAndItsTargetIsReplaced) {
  fs::create_directories(folder_ / "elsewhere");
  std::ofstream(path("elsewhere/table")) << "old";
  fs::create_symlink("elsewhere/table", path("link"));
  OutputFile out(path("link"));
  out.write("new");
  out.commit();
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(content(path("elsewhere/table")), "new");
}

TEST_F(OutputFileTest, ADanglingLinkIsFilled) {
  fs::create_symlink("table", path("link"));
  EXPECT_EQ(refusal(path("link")), "written");
  EXPECT_EQ(content(path("table")), "text");
  EXPECT_TRUE(fs::is_symlink(path("link")));
}

TEST_F(OutputFileTest, ALinkToItselfIsRefused) {
  fs::create_symlink("link", path("link"));
  EXPECT_THAT(refusal(path("link")), HasSubstr("symbolic links"));
  EXPECT_EQ(entries(), 1U);
}

TEST_F(OutputFileTest, PermissionsOfTheOldFileAreKept) {
  std::ofstream(path("table")) << "old";
  fs::permissions(path("table"), fs::perms(0640));
  EXPECT_EQ(refusal(path("table")), "written");
  EXPECT_EQ(fs::status(path("table")).permissions(), fs::perms(0640));
}

TEST_F(OutputFileTest, ANewFileFollowsTheUsualMask) {
  const mode_t before = umask(027);
  EXPECT_EQ(refusal(path("table")), "written");
  umask(before);
  EXPECT_EQ(fs::status(path("table")).permissions(), fs::perms(0640));
}

TEST_F(OutputFileTest, AReadOnlyFileIsNotReplaced) {
  std::ofstream(path("table")) << "old";
  fs::permissions(path("table"), fs::perms(0444));
  // No permission stops root: the test runs for every other user.
  if (::geteuid() == 0) GTEST_SKIP() << "root writes everything";
  EXPECT_THAT(refusal(path("table")), HasSubstr("cannot be replaced: Permission denied"));
  EXPECT_EQ(content(path("table")), "old");
}

TEST_F(OutputFileTest, AFolderIsRefused) {
  EXPECT_THAT(refusal(folder_.string()), HasSubstr("Is a directory"));
  EXPECT_EQ(entries(), 0U);
}

TEST_F(OutputFileTest, AMissingFolderIsRefused) {
  EXPECT_THAT(refusal(path("no/table")), HasSubstr("No such file or directory"));
}

TEST_F(OutputFileTest, AFileInPlaceOfAFolderIsRefused) {
  std::ofstream(path("file")) << "old";
  EXPECT_THAT(refusal(path("file/table")), HasSubstr("Not a directory"));
}

TEST_F(OutputFileTest, AnEmptyNameIsRefused) { EXPECT_NE(refusal(""), "written"); }

TEST_F(OutputFileTest, ALongNameWorks) { EXPECT_EQ(refusal(path(std::string(255, 'x'))), "written"); }

TEST_F(OutputFileTest, AFullDiskIsReported) {
  EXPECT_THAT(refusal("/dev/full"), HasSubstr("/dev/full: cannot be written: No space left"));
}

TEST_F(OutputFileTest, APipeIsWrittenDirectly) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_EQ(refusal(path("pipe")), "written");
  std::array<char, 16> text{};
  EXPECT_EQ(read(reader, text.data(), text.size()), 4);
  close(reader);
}

TEST_F(OutputFileTest, AReaderThatLeavesEndsTheWriting) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  OutputFile out(path("pipe"));
  close(reader);
  EXPECT_THROW(out.write("text"), ClosedPipe);
}

TEST_F(OutputFileTest, ASignalEndsABlockedWrite) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  const int reader = open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  OutputFile out(path("pipe"));
  const InterruptGuard guard;
  struct sigaction wake {};
  wake.sa_handler = [](int) { std::raise(SIGTERM); };
  sigaction(SIGALRM, &wake, nullptr);
  alarm(1);
  try {
    out.write(std::string(1U << 22U, 'x'));
    ADD_FAILURE() << "the pipe took it all";
  } catch (const Interrupted& stop) {
    EXPECT_EQ(stop.signal, SIGTERM);
  }
  std::signal(SIGALRM, SIG_DFL);
  close(reader);
}

}  // namespace
}  // namespace patchgrip::cli
