// A result on its way to a file or to standard output, all of it or nothing.
//
// A regular file is written beside its target, under a temporary name, and takes the target's place in commit(), after
// it has reached the disk. Until then, and whatever happens, an older file stays as it was; without commit() the
// temporary goes. A symbolic link stays and its target is replaced; the permissions of the replaced file are kept. "-",
// standard output and anything that is not a regular file (/dev/full, a pipe) are written directly.
//
// Throws   OutputError with the path and the system's reason; ClosedPipe when nobody reads any more (SIGPIPE is ignored
//          from here on); Interrupted when a signal arrives while a write blocks.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace patchgrip::cli {

struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ClosedPipe {};

class OutputFile {
 public:
  explicit OutputFile(const std::string& target);  // "-" for standard output
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  void commit();

  int descriptor() const noexcept { return descriptor_; }

 private:
  [[noreturn]] void fail(std::string_view what) const;  // with the reason in errno
  void open_directly(const std::string& path);
  void open_beside(const std::filesystem::path& path);
  void close();

  std::string shown_;                // the target as given
  std::filesystem::path final_;      // where a regular file goes in the end
  std::filesystem::path temporary_;  // empty if written directly, and after commit()
  int descriptor_ = -1;
};

}  // namespace patchgrip::cli
