#include <patchgrip/cli/interrupt.h>

#include <array>
#include <csignal>
#include <cstddef>

namespace patchgrip::cli {
namespace {

constexpr std::array<int, 3> noted{SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t pending = 0;
std::array<struct sigaction, noted.size()> before{};

extern "C" void note(int signal) { pending = signal; }

}  // namespace

InterruptGuard::InterruptGuard() {
  pending = 0;
  struct sigaction action {};
  action.sa_handler = note;  // without SA_RESTART: a blocked write returns
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < noted.size(); ++i) {
    sigaction(noted[i], nullptr, &before[i]);
    if (before[i].sa_handler != SIG_IGN) sigaction(noted[i], &action, nullptr);
  }
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < noted.size(); ++i) sigaction(noted[i], &before[i], nullptr);
  pending = 0;
}

void InterruptGuard::check() {
  if (pending != 0) throw Interrupted{pending};
}

void InterruptGuard::forget() noexcept { pending = 0; }

}  // namespace patchgrip::cli
