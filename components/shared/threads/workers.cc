#include "shared/threads/workers.hh"

#include <stdexcept>
#include <string>
#include <system_error>

namespace pongsim::shared {

namespace {

/// Flag in `inside_`, beside the number of threads.
constexpr std::uint32_t kOpen = 1U << 31U;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

bool Workers::Part::takeFirst(std::size_t& index) {
  std::uint64_t left = left_.load(std::memory_order_relaxed);
  do {
    index = left & kLow;
    if (index >= left >> kBits) return false;
  } while (!left_.compare_exchange_weak(left, left + 1, std::memory_order_relaxed));
  return true;
}

bool Workers::Part::takeLast(std::size_t& index) {
  std::uint64_t left = left_.load(std::memory_order_relaxed);
  do {
    index = (left >> kBits) - 1;
    if ((left & kLow) >= left >> kBits) return false;
  } while (!left_.compare_exchange_weak(left, left - (1ULL << kBits), std::memory_order_relaxed));
  return true;
}

Workers::Workers(int threads, int spins) : spins_(spins), parts_(static_cast<std::size_t>(threads)) {
  try {
    for (int worker = 1; worker < threads; ++worker) threads_.emplace_back([this, worker] { help(worker); });
  } catch (const std::system_error& error) {
    end();
    throw std::runtime_error("can't start " + std::to_string(threads) + " threads: " + error.code().message());
  }
}

Workers::~Workers() {
  if (areOfThisProcess()) {
    end();
  } else {
    for (std::thread& thread : threads_) thread.detach();
  }
}

void Workers::end() {
  ends_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::share(std::size_t count, Call call, void* context) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].set(count * i / parts_.size(), count * (i + 1) / parts_.size());
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
    if (i < spins_) {
      pause();
    } else {
      std::this_thread::yield();
    }
  }
}

void Workers::take(int worker) {
  const auto own = static_cast<std::size_t>(worker);
  std::size_t index = 0;
  while (parts_[own].takeFirst(index)) call_(context_, index, worker);
  for (std::size_t turn = 1; turn < parts_.size(); ++turn) {
    Part& part = parts_[(own + turn) % parts_.size()];
    while (part.takeLast(index)) call_(context_, index, worker);
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
  for (int i = 0; i < spins_; ++i) {
    const std::uint32_t round = round_;
    if (round != last) return round;
    pause();
  }
  round_.wait(last);
  return round_;
}

}  // namespace pongsim::shared
