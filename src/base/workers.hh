#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace pongsim::base {

/// Threads that share a piece of work which comes again and again, thousands of times a second: they wait awake for a
/// moment before they sleep. Each begins with its own part, the same each time, so that what it needs is in its
/// processor's caches, and then helps the others, from the far ends of their parts, which they come to last. Allocates
/// nothing once made.
class Workers {
 public:
  /// @param threads How many work, the caller of `forEach` included; at least 1.
  /// @param looks How often a thread looks for work before it sleeps. 2,000 are some tens of microseconds: what lies
  /// between two pieces of work in a step.
  explicit Workers(int threads, int looks = 2000);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int count() const { return static_cast<int>(threads_.size()) + 1; }

  /// Calls `work(index, worker)` for each index below `count` (less than 2^32) and returns when all calls have;
  /// `worker` is below `this->count()`, and no two calls at once have the same. Which worker does what is not said. The
  /// work must not throw.
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
  /// What of the work is a thread's own, on a cache line of its own.
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

  void share(std::size_t count, Call call, void* context);
  void help(int worker);
  void take(int worker);
  /// Waits until there is another round than `last`.
  std::uint32_t waitForRound(std::uint32_t last) const;

  const int looks_;

  // the work; written only while nobody is in it
  std::vector<Part> parts_;
  Call call_ = nullptr;
  void* context_ = nullptr;

  /// How many threads are in the work, and whether more may come in.
  std::atomic<std::uint32_t> inside_ = 0;
  /// Counts the pieces of work.
  std::atomic<std::uint32_t> round_ = 0;
  std::atomic<bool> ends_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace pongsim::base
