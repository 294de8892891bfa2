#include "base/workers.hh"

namespace pongsim::base {

namespace {

/// Flag in `inside_`, beside the number of threads.
constexpr std::uint32_t kOpen = 1U << 31U;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

Workers::Workers(int threads, int looks) : looks_(looks), parts_(static_cast<std::size_t>(threads)) {
  for (int worker = 1; worker < threads; ++worker) threads_.emplace_back([this, worker] { help(worker); });
}

Workers::~Workers() {
  ends_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::share(std::size_t count, Call call, void* context) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].next.store(count * i / parts_.size(), std::memory_order_relaxed);
    parts_[i].end = count * (i + 1) / parts_.size();
  }
  call_ = call;
  context_ = context;
  inside_ = kOpen;
  ++round_;
  round_.notify_all();
  take(0);
  // everything is taken: sleeping threads need not wake, but running ones must finish
  inside_.fetch_and(~kOpen);
  for (int i = 0; inside_ != 0; ++i) {
    // on a busy machine, a running thread may be waiting for a core
    if (i < looks_) {
      pause();
    } else {
      std::this_thread::yield();
    }
  }
}

void Workers::take(int worker) {
  for (std::size_t turn = 0; turn < parts_.size(); ++turn) {
    Part& part = parts_[(static_cast<std::size_t>(worker) + turn) % parts_.size()];
    // checking first avoids taking the cache line from its owner
    while (part.next.load(std::memory_order_relaxed) < part.end) {
      const std::size_t i = part.next.fetch_add(1, std::memory_order_relaxed);
      if (i < part.end) call_(context_, i, worker);
    }
  }
}

void Workers::help(int worker) {
  for (std::uint32_t round = 0;;) {
    round = waitForRound(round);
    if (ends_) return;
    std::uint32_t inside = inside_;
    while ((inside & kOpen) != 0 && !inside_.compare_exchange_weak(inside, inside + 1)) {
    }
    if ((inside & kOpen) == 0) continue;
    take(worker);
    --inside_;
  }
}

std::uint32_t Workers::waitForRound(std::uint32_t last) const {
  for (int i = 0; i < looks_; ++i) {
    const std::uint32_t round = round_;
    if (round != last) return round;
    pause();
  }
  round_.wait(last);
  return round_;
}

}  // namespace pongsim::base
