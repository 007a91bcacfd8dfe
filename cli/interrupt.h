// A request to stop (Ctrl-C, kill, a closed terminal), noted by a signal handler and asked for where stopping is safe.
#pragma once

namespace patchgrip::cli {

// While it lives, SIGINT, SIGTERM and SIGHUP are noted instead of ending the program, and interrupt a blocking write.
// A signal that was ignored stays ignored. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  // Throws Interrupted once a signal has arrived while there is a guard.
  static void check();

  // Takes note of a signal no further, so that what there is can be written; the next one counts again.
  static void forget() noexcept;
};

struct Interrupted {
  int signal;
};

}  // namespace patchgrip::cli
