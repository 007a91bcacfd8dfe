#include <patchgrip/verification/fe/work_folder.h>

#include <unistd.h>

#include <system_error>

namespace patchgrip::verification {
namespace {

// Removed with all that is in it at the end of the program.
class WorkFolder {
 public:
  WorkFolder() : path_(std::filesystem::temp_directory_path() / ("patchgrip-verify-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~WorkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  std::filesystem::path next(const std::string& extension) {
    return path_ / ("file" + std::to_string(++count_) + extension);
  }

 private:
  std::filesystem::path path_;
  int count_ = 0;
};

}  // namespace

std::filesystem::path new_work_file(const std::string& extension) {
  static WorkFolder folder;
  return folder.next(extension);
}

}  // namespace patchgrip::verification
