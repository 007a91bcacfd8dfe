#include <patchgrip/cli/progress.h>

#include <fmt/format.h>
#include <unistd.h>

#include <string_view>
#include <utility>

namespace patchgrip::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto first_shown = 500ms;
constexpr auto interval = 100ms;

// A terminal that takes nothing must not stop the run: what cannot be shown is not shown.
void show(std::string_view text) {
  [[maybe_unused]] const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

Progress::Progress(std::string what, std::size_t total, bool shown)
    : what_(std::move(what)), total_(total), shown_(shown), next_(std::chrono::steady_clock::now() + first_shown) {}

Progress::~Progress() {
  if (written_) show("\r\x1b[K");
}

bool Progress::wanted(int output) noexcept { return isatty(STDERR_FILENO) != 0 && isatty(output) == 0; }

void Progress::at(std::size_t done) {
  if (!shown_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + interval;
  written_ = true;
  show(fmt::format("\r\x1b[K{}: {} %", what_, 100 * done / total_));
}

}  // namespace patchgrip::cli
