#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "pongsim/export.hh"
#include "pongsim/log.hh"
#include "pongsim/message.hh"
#include "pongsim/node.hh"

namespace pongsim {

/// Calls services one after another on its own thread, so that the simulation does not wait for the replies. Failures
/// are logged. The thread starts with the first call.
class PONGSIM_API BackgroundCalls {
 public:
  struct Call {
    std::string service;
    std::shared_ptr<const Message> request;
    /// Full name of the reply's type.
    std::string replyType;
    std::chrono::milliseconds timeout{5000};
    /// Called on the worker thread with the result; `reply` is only valid if the call worked. Empty: failures are
    /// logged.
    std::function<void(const CallResult& result, const Message& reply)> done = {};
  };
  /// @param log Must outlive this.
  /// @param mostWaiting Largest number of waiting calls.
  BackgroundCalls(const Node& node, const Logger& log, std::size_t mostWaiting = 1000);
  /// Waits for the current call; waiting calls are discarded.
  ~BackgroundCalls();
  BackgroundCalls(const BackgroundCalls&) = delete;
  BackgroundCalls& operator=(const BackgroundCalls&) = delete;

  /// Queues a call and returns at once.
  /// @return False, with a warning, if too many calls are waiting.
  bool post(Call call);

 private:
  void work(const std::stop_token& stop);
  void make(const Call& call);

  Node node_;
  const Logger& log_;
  const std::size_t mostWaiting_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Call> waiting_;
  // ends first
  std::jthread worker_;
};

}  // namespace pongsim
