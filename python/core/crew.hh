#pragma once

#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
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
  void takeFrom(const std::function<void(std::size_t)>& work);

  std::size_t wanted_;
  /// Where the threads are.
  pid_t process_ = 0;
  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable given_;
  std::condition_variable done_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::size_t round_ = 0;
  std::size_t busy_ = 0;
  bool ends_ = false;
};

}  // namespace pongsim::python
