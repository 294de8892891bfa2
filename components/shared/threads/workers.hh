#pragma once

#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace pongsim::shared {

/// A thread pool for loops that recur thousands of times a second: idle threads spin for a moment before they sleep.
/// Each thread starts with its own range of indices, the same each time, so that its data stays in its processor's
/// caches. Then it steals work from the ends of the others' ranges. Allocates nothing after construction.
class Workers {
 public:
  /// @param threads Number of threads, including the caller of `forEach`; at least 1.
  /// @param spins How often a thread checks for work before it sleeps. 2,000 checks take some tens of microseconds, as
  /// long as the gap between two pieces of work in a step.
  /// @throws std::runtime_error where the system has no more threads.
  explicit Workers(int threads, int spins = 2000);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// @return Whether the threads belong to the calling process: not after a fork. Then the destructor leaves them to
  /// the parent.
  bool areOfThisProcess() const { return process_ == getpid(); }
  int count() const { return static_cast<int>(threads_.size()) + 1; }

  /// Calls `work(index, worker)` for each index below `count` (less than 2^32), and returns after all calls. `worker`
  /// is below `this->count()`, and concurrent calls have different workers. Which worker gets which index is
  /// unspecified. The work must not throw.
  template <class Work>
  void forEach(std::size_t count, Work&& work) {
    if (threads_.empty() || count < 2) {
      for (std::size_t i = 0; i < count; ++i) work(i, 0);
      return;
    }
    share(
        count, [](void* context, std::size_t index, int worker) { (*static_cast<Work*>(context))(index, worker); },
        &work);
  }

 private:
  /// A thread's own part of the work, on a separate cache line.
  class alignas(64) Part {
   public:
    void set(std::size_t begin, std::size_t end) { left_.store(begin | end << kBits, std::memory_order_relaxed); }
    /// Takes an index off an end of what is left.
    /// @return Whether there was one.
    bool takeFirst(std::size_t& index);
    bool takeLast(std::size_t& index);

   private:
    static constexpr unsigned kBits = 32;
    static constexpr std::uint64_t kLow = 0xffffffff;

    /// The first index that is left in the lower half, the one behind the last in the upper half.
    std::atomic<std::uint64_t> left_ = 0;
  };
  using Call = void (*)(void* context, std::size_t index, int worker);

  void end();
  void share(std::size_t count, Call call, void* context);
  void help(int worker);
  void take(int worker);
  /// Waits for a round other than `last`.
  std::uint32_t waitForRound(std::uint32_t last) const;

  const int spins_;
  const pid_t process_ = getpid();

  // the work; only written while no thread is inside
  std::vector<Part> parts_;
  Call call_ = nullptr;
  void* context_ = nullptr;

  /// Number of threads inside, and whether more may enter.
  std::atomic<std::uint32_t> inside_ = 0;
  /// Number of pieces of work so far.
  std::atomic<std::uint32_t> round_ = 0;
  std::atomic<bool> ends_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace pongsim::shared
