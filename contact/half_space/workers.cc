#include <patchgrip/contact/half_space/workers.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {
namespace {

// Between two loops of a solution there are microseconds; waking a sleeping thread costs tens of them.
constexpr int looks_before_sleep = 4000;

void rest() noexcept {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

template <class Changed>
bool changes_soon(const Changed& changed) noexcept {
  for (int i = 0; i < looks_before_sleep; ++i) {
    if (changed()) return true;
    rest();
  }
  return false;
}

}  // namespace

Workers::Workers(int threads)
    : shares_(static_cast<std::size_t>(static_cast<int>(require_in("threads", threads, 1, most_threads)))) {
  threads_.reserve(static_cast<std::size_t>(threads - 1));
  try {
    for (int thread = 1; thread < threads; ++thread) threads_.emplace_back(&Workers::serve, this, thread);
  } catch (...) {
    stop();
    throw;
  }
}

Workers::~Workers() { stop(); }

void Workers::stop() noexcept {
  stopped_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::share(int parts, Call call, const void* part) {
  call_ = call;
  part_ = part;
  parts_ = parts;
  undone_ = static_cast<std::uint32_t>(parts);
  for (int share = 0; share < count(); ++share) {
    std::atomic<std::uint64_t>& tickets = shares_[static_cast<std::size_t>(share)].tickets;
    tickets = ((tickets >> 32) + 1) << 32 | static_cast<std::uint32_t>(begin(share + 1) - begin(share));
  }
  ++round_;
  round_.notify_all();
  take_parts(0);
  if (changes_soon([&] { return undone_ == 0; })) return;
  for (std::uint32_t undone = undone_; undone != 0; undone = undone_) undone_.wait(undone);
}

// A thread takes its own share, then what the others have left of theirs.
void Workers::take_parts(int thread) {
  for (int k = 0; k < count(); ++k) take_share((thread + k) % count(), thread);
}

// Whoever draws a ticket keeps its round open until the part is done: call, part and parts are those of the round.
void Workers::take_share(int share, int thread) {
  std::atomic<std::uint64_t>& tickets = shares_[static_cast<std::size_t>(share)].tickets;
  for (std::uint64_t ticket = tickets; static_cast<std::uint32_t>(ticket) != 0;) {
    if (!tickets.compare_exchange_weak(ticket, ticket - 1)) continue;
    call_(part_, begin(share) + static_cast<int>(static_cast<std::uint32_t>(ticket) - 1), thread);
    if (--undone_ == 0) undone_.notify_one();
    ticket = tickets;
  }
}

void Workers::serve(int thread) {
  for (std::uint32_t seen = 0;;) {
    if (!changes_soon([&] { return round_ != seen; })) round_.wait(seen);
    seen = round_;
    if (stopped_) return;
    take_parts(thread);
  }
}

}  // namespace patchgrip::contact
