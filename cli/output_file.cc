#include <patchgrip/cli/output_file.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;

constexpr mode_t default_mode = 0666;

mode_t default_permissions() {
  const mode_t mask = umask(0);
  umask(mask);
  return default_mode & ~mask;
}

// Such a name stands for a file that somebody has opened already: it is written where it is.
bool names_descriptor(std::string_view path) {
  return path == "/dev/stderr" || path.starts_with("/dev/fd/") || path.starts_with("/proc/");
}

// Follows links to where a file is or would be made; a loop of links is left to open() to report.
fs::path resolved(fs::path path) {
  constexpr int most_links = 40;
  std::error_code error;
  for (int i = 0; i < most_links && fs::is_symlink(path, error); ++i) {
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / next;
  }
  return path;
}

void sync_folder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // a folder may be writable and not readable
  fsync(descriptor);
  close(descriptor);
}

}  // namespace

OutputFile::OutputFile(const std::string& target)
    : shown_(target == "-" ? "standard output" : printable(target, std::string::npos)) {
  std::signal(SIGPIPE, SIG_IGN);
  if (target == "-" || target == "/dev/stdout") {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  const fs::path path = resolved(target);
  struct stat status {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail("cannot be written");
  if (names_descriptor(target) || (exists && !S_ISREG(status.st_mode))) {
    open_directly(target);
    return;
  }
  if (exists && access(path.c_str(), W_OK) != 0) fail("cannot be replaced");
  open_beside(path);
  if (fchmod(descriptor_, exists ? status.st_mode & 07777 : default_permissions()) != 0)
    fail("cannot be given its permissions");
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) ::close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::open_directly(const std::string& path) {
  descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (descriptor_ >= 0) return;
  InterruptGuard::check();
  fail("cannot be written");
}

void OutputFile::open_beside(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::string name = (folder / ".patchgrip-XXXXXX").string();
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) fail("cannot be made");
  final_ = path;
  temporary_ = std::move(name);
}

void OutputFile::fail(std::string_view what) const {
  throw OutputError(fmt::format("{}: {}: {}", shown_, what, std::generic_category().message(errno)));
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
      if (!bytes.empty()) InterruptGuard::check();  // a signal cut the write short
    } else if (errno == EINTR) {
      InterruptGuard::check();
    } else if (errno == EPIPE) {
      throw ClosedPipe{};
    } else {
      fail("cannot be written");
    }
  }
}

void OutputFile::close() {
  if (descriptor_ == STDOUT_FILENO) return;
  const int result = ::close(std::exchange(descriptor_, -1));
  if (result != 0 && errno != EINTR) fail("cannot be written");
}

void OutputFile::commit() {
  if (temporary_.empty()) {
    close();
    return;
  }
  if (fsync(descriptor_) != 0) fail("cannot be written");
  close();
  if (rename(temporary_.c_str(), final_.c_str()) != 0) fail("cannot be replaced");
  temporary_.clear();
  sync_folder(final_.parent_path().empty() ? fs::path(".") : final_.parent_path());
}

}  // namespace patchgrip::cli
