#pragma once

#include <libwebsockets.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "pongsim/log.hh"
#include "web/server/session.hh"

namespace pongsim::web {

/// Schedules calls on the server's thread: immediately, when another thread asks for it, or regularly.
class Waker {
 public:
  /// @param log Must be valid until `end`.
  Waker(lws_context* context, const Logger& log);

  // For any thread.

  /// See `Client::callSoon`.
  void add(std::shared_ptr<Callee> callee);
  /// Ends the thread's wait.
  void wake();

  // For the server's thread.

  /// See `Client::callRegularly`.
  std::shared_ptr<void> addRegular(std::weak_ptr<Callee> callee);
  /// Makes the calls that were added, and those that these add.
  void callAll();

  /// Call when the server ends, after its thread has: nothing is called from now on.
  void end();

 private:
  struct Regular {
    std::weak_ptr<Callee> callee;
  };

  void callRegulars();
  void beat(const std::stop_token& stop);
  void call(Callee& callee);

  const Logger& log_;
  std::mutex mutex_;
  std::condition_variable_any beats_;
  /// Null when the server has ended.
  lws_context* context_;
  std::vector<std::shared_ptr<Callee>> waiting_;
  /// Whether the server's thread is making calls, and will check again itself.
  bool isCalling_ = false;
  /// Whether regular calls are due.
  bool isDue_ = false;

  // used on the server's thread
  std::vector<std::shared_ptr<Callee>> called_;
  std::vector<std::weak_ptr<Regular>> regulars_;
  /// Makes regular calls due, while there are any. Not one of the library's timers: they sleep for whole milliseconds,
  /// rounded down, and poll for the rest, which took 5 % of a core.
  std::jthread timer_;
};

}  // namespace pongsim::web
