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

/// Calls services, one after another, on a thread of its own: an answer may take its time, and the simulation waits for
/// nobody. What goes wrong is logged. The thread begins with the first call.
class PONGSIM_API BackgroundCalls {
 public:
  struct Call {
    std::string service;
    std::shared_ptr<const Message> request;
    /// Full name.
    std::string replyType;
    std::chrono::milliseconds timeout{5000};
    /// Told on the worker's thread what came of it; the reply is there where it worked. Empty: what goes wrong is
    /// logged.
    std::function<void(const CallResult& result, const Message& reply)> done = {};
  };
  /// @param log Must outlive it.
  /// @param mostWaiting How many may wait.
  BackgroundCalls(const Node& node, const Logger& log, std::size_t mostWaiting = 1000);
  /// Waits for the call that is being made; the others are not made any more.
  ~BackgroundCalls();
  BackgroundCalls(const BackgroundCalls&) = delete;
  BackgroundCalls& operator=(const BackgroundCalls&) = delete;

  /// Has the service called. Returns at once.
  /// @return Whether it will be: not, with a warning, where too many wait already.
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
