#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "ros2/doctor/observation.hh"
#include "ros2/node/node.hh"

namespace pongsim::ros2 {

/// Watches what the nodes of a domain publish: subscribes to each topic with a type that it knows.
class Observer {
 public:
  /// @param node Of this program.
  explicit Observer(RosNode& node);
  ~Observer();
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;

  /// Waits until all nodes are known, then watches.
  void watch(std::chrono::nanoseconds time);
  /// @return What it has seen, with the nodes that don't use simulated time, which are asked now.
  Observation observation();

 private:
  void subscribe();
  void open(const std::string& topic, const std::string& type);
  template <class Message>
  void openFor(const std::string& topic, void (Observer::*receive)(const std::string&, const Message&, const Guid&));
  Qos qosOf(const std::string& topic) const;

  template <class Message>
  void receiveStream(const std::string& topic, const Message& message, const Guid& writer);
  template <class Message>
  void receiveTransforms(const std::string& topic, const Message& message, const Guid& writer);
  template <class Message>
  void receiveClock(const std::string& topic, const Message& message, const Guid& writer);
  template <class Message>
  void receiveText(const std::string& topic, const Message& message, const Guid& writer);

  RosNode& node_;
  NodeWatch nodes_;
  std::mutex mutex_;
  Observation seen_;
  /// By topic and type.
  std::map<std::string, std::unique_ptr<RosSubscription>> subscriptions_;
};

}  // namespace pongsim::ros2
