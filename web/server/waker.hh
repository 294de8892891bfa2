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

/// Has things called on the server's thread: at once when another thread says so, which wakes it, or regularly.
class Waker {
 public:
  /// @param log Must outlive `end`.
  Waker(lws_context* context, const Logger& log);

  // For any thread.

  /// As `Client::callSoon`.
  void add(std::shared_ptr<Callee> callee);
  /// Ends the thread's wait.
  void wake();

  // For the server's thread.

  /// As `Client::callRegularly`.
  std::shared_ptr<void> addRegular(std::weak_ptr<Callee> callee);
  /// Calls all that were added, and those whom they add.
  void callAll();

  /// The server ends, and its thread has: nobody is called from now on.
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
  /// Whether the server's thread is at it, and looks again by itself.
  bool isCalling_ = false;
  /// Whether those who are called regularly are due.
  bool isDue_ = false;

  // of the server's thread
  std::vector<std::shared_ptr<Callee>> called_;
  std::vector<std::weak_ptr<Regular>> regulars_;
  /// Says when, while somebody is called regularly: the library's own timers sleep for whole milliseconds, rounded
  /// down, and ask on and on for what is left of the time, which took 5 % of a processor.
  std::jthread timer_;
};

}  // namespace pongsim::web
