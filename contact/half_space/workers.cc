#include <patchgrip/contact/half_space/workers.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {
namespace {

// Between two loops of a solution there are a few microseconds, and a hundred where transforms are planned; to wake a
// sleeping thread may take as long. Who waits soon lets others run.
constexpr int looks_before_yield = 500, looks_before_sleep = 1000;

void rest() noexcept {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

template <class Changed>
bool changes_soon(const Changed& changed) noexcept {
  for (int i = 0; i < looks_before_sleep; ++i) {
    if (changed()) return true;
    if (i < looks_before_yield) {
      rest();
    } else {
      std::this_thread::yield();
    }
  }
  return false;
}

}  // namespace

Workers::Workers(int threads) : shares_(static_cast<std::size_t>(require_in("threads", threads, 1, most_threads))) {
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

// A thread takes its own share, then what the others have left of theirs, and says once what it has done: until then
// the round stays open, and call, part and parts are those of the round.
void Workers::take_parts(int thread) {
  std::uint32_t done = 0;
  for (int k = 0; k < count(); ++k) done += take_share((thread + k) % count(), thread);
  if (done > 0 && (undone_ -= done) == 0) undone_.notify_one();
}

std::uint32_t Workers::take_share(int share, int thread) {
  std::atomic<std::uint64_t>& tickets = shares_[static_cast<std::size_t>(share)].tickets;
  std::uint32_t done = 0;
  for (std::uint64_t ticket = tickets; static_cast<std::uint32_t>(ticket) != 0;) {
    if (!tickets.compare_exchange_weak(ticket, ticket - 1)) continue;
    call_(part_, begin(share + 1) - static_cast<int>(static_cast<std::uint32_t>(ticket)), thread);
    ++done;
    ticket = tickets;
  }
  return done;
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
