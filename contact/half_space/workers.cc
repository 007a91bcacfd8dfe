#include <patchgrip/contact/half_space/workers.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

Workers::Workers(int threads) {
  require_in("threads", threads, 1, most_threads);
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
  next_ = 0;
  busy_ = static_cast<int>(threads_.size());
  ++round_;
  round_.notify_all();
  take_parts(0);
  for (int busy = busy_; busy != 0; busy = busy_) busy_.wait(busy);
}

void Workers::take_parts(int thread) {
  for (int index = next_++; index < parts_; index = next_++) call_(part_, index, thread);
}

void Workers::serve(int thread) {
  for (std::uint32_t seen = 0;; ++seen) {
    round_.wait(seen);
    if (stopped_) return;
    take_parts(thread);
    if (--busy_ == 0) busy_.notify_all();
  }
}

}  // namespace patchgrip::contact
