#include "core/crew.hh"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace pongsim::python {

namespace {

/// A sleeping thread is often woken on the processor of the thread that wakes it, and has to wait there. So a short
/// pause, such as that between two steps of a learner, is spent spinning.
constexpr std::chrono::microseconds kAwake{200};
/// Number of checks between two readings of the clock.
constexpr int kLooks = 64;
/// A flag in `inside_`, beside the number of threads.
constexpr std::uint32_t kOpen = 1U << 31U;

/// Pauses the processor for some ten cycles, without a system call, which would yield it to others.
void rest() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

Crew::~Crew() {
  if (threads_.empty()) return;
  if (process_ != getpid()) {
    // after a fork they belong to the parent process, so there is nothing to join
    for (std::thread& thread : threads_) thread.detach();
    return;
  }
  ends_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Crew::begin() {
  if (!threads_.empty() && process_ != getpid()) {
    throw std::runtime_error(
        "the threads of these environments did not survive the fork of the process; create the environments in the "
        "process that "
        "steps them");
  }
  process_ = getpid();
  while (threads_.size() + 1 < wanted_) threads_.emplace_back([this] { serve(); });
}

void Crew::takeAll() {
  for (std::size_t i = next_++; i < count_; i = next_++) (*work_)(i);
}

std::uint32_t Crew::waitForRound(std::uint32_t last) const {
  const auto end = std::chrono::steady_clock::now() + kAwake;
  do {
    for (int i = 0; i < kLooks; ++i) {
      if (const std::uint32_t round = round_; round != last) return round;
      rest();
    }
  } while (std::chrono::steady_clock::now() < end);
  round_.wait(last);
  return round_;
}

void Crew::serve() {
  for (std::uint32_t round = 0; !ends_;) {
    round = waitForRound(round);
    std::uint32_t inside = inside_;
    while ((inside & kOpen) != 0 && !inside_.compare_exchange_weak(inside, inside + 1)) continue;
    if ((inside & kOpen) == 0) continue;
    takeAll();
    if (--inside_ == 0) inside_.notify_one();
  }
}

void Crew::run(std::size_t count, const std::function<void(std::size_t)>& work) {
  if (std::min(count, wanted_) <= 1) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  begin();
  work_ = &work;
  count_ = count;
  next_ = 0;
  inside_ = kOpen;
  ++round_;
  round_.notify_all();
  takeAll();
  // all work is taken; wait only for threads that are still at it
  std::uint32_t inside = inside_.fetch_and(~kOpen) & ~kOpen;
  for (int i = 0; inside != 0; ++i, inside = inside_) {
    if (i < 16 * kLooks) {
      rest();
    } else {
      inside_.wait(inside);
    }
  }
}

}  // namespace pongsim::python
