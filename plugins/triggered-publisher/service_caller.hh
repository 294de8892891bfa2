#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/log.hh"
#include "pongsim/message.hh"
#include "pongsim/node.hh"

namespace pongsim {

/// One `<service>` of a TriggeredPublisher.
struct ServiceCall {
  /// @throws Error at the element for what is missing or wrong.
  explicit ServiceCall(const Element& element);

  std::string name;
  MessagePointer request;
  MessagePointer reply;
  std::chrono::milliseconds timeout{0};
};

/// Calls services, one after another, on a thread of its own: an answer may take its time, and the simulation waits for
/// nobody. What goes wrong is logged.
class ServiceCaller {
 public:
  /// @param log Must outlive it.
  ServiceCaller(std::vector<ServiceCall> calls, const Node& node, const Logger& log);
  /// Waits for the call that is being made.
  ~ServiceCaller() = default;
  ServiceCaller(const ServiceCaller&) = delete;
  ServiceCaller& operator=(const ServiceCaller&) = delete;

  /// Has all services called once more. Returns at once.
  void call();

 private:
  void work(const std::stop_token& stop);
  void callAll(const std::stop_token& stop);

  std::vector<ServiceCall> calls_;
  Node node_;
  const Logger& log_;

  std::mutex mutex_;
  std::condition_variable_any changed_;
  int waiting_ = 0;
  // ends first
  std::jthread worker_;
};

}  // namespace pongsim
