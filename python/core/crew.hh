#pragma once

#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace pongsim::python {

/// Threads that share out pieces of work. Which of them does which piece is left to chance.
class Crew {
 public:
  /// @param threads How many work at a time, the caller of `run` among them; from 1 on. The others begin with the first
  /// `run` that needs them.
  explicit Crew(std::size_t threads) : wanted_(threads) {}
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Calls `work` with each number below `count`, once, and returns when all calls have. `work` must not throw.
  /// @throws std::runtime_error in a process that was forked off, to which the threads did not come along.
  void run(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void begin();
  void serve();
  /// @return The round after `last`.
  std::uint32_t waitForRound(std::uint32_t last) const;
  void takeAll();

  std::size_t wanted_;
  /// Where the threads are.
  pid_t process_ = 0;
  std::vector<std::thread> threads_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::uint32_t> round_ = 0;
  /// How many threads beside the caller's are at it, and whether more may come.
  std::atomic<std::uint32_t> inside_ = 0;
  std::atomic<bool> ends_ = false;
};

}  // namespace pongsim::python
