#pragma once

#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace pongsim::python {

/// A thread pool. Which thread does which piece of work is unspecified.
class Crew {
 public:
  /// @param threads Number of threads, including the caller of `run`; at least 1. The others start with the first `run`
  /// that needs them.
  explicit Crew(std::size_t threads) : wanted_(threads) {}
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Calls `work` once with each number below `count`, and returns after all calls. `work` must not throw.
  /// @throws std::runtime_error in a forked process, which does not inherit the threads.
  void run(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void begin();
  void serve();
  /// @return The round after `last`.
  std::uint32_t waitForRound(std::uint32_t last) const;
  void takeAll();

  std::size_t wanted_;
  /// The process that has the threads.
  pid_t process_ = 0;
  std::vector<std::thread> threads_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::uint32_t> round_ = 0;
  /// Number of threads other than the caller's that are inside, and whether more may enter.
  std::atomic<std::uint32_t> inside_ = 0;
  std::atomic<bool> ends_ = false;
};

}  // namespace pongsim::python
