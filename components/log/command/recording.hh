#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "log/command/topic_choice.hh"
#include "log/store/writer.hh"
#include "pongsim/node.hh"

namespace pongsim::log {

/// Records topics of other processes, stamped with wall time, until it is stopped.
class Recording {
 public:
  /// Whether a topic of this type can be written.
  using CanWrite = std::function<bool(std::string_view topic, std::string_view type)>;

  /// @param transport, writer, choice Must outlive it.
  /// @param canWrite Topics with only types that it rejects are not subscribed to, unless they were chosen by name.
  /// Null: accepts all.
  Recording(Transport& transport, Writer& writer, const TopicChoice& choice, CanWrite canWrite = nullptr);

  /// Processes incoming messages for a while; looks for new topics now and then.
  /// @throws Failure if they can't be written.
  void goOn();

  std::uint64_t messages() const { return messages_; }
  /// Number of topics with at least one message.
  std::size_t topics() const { return receivedTopics_.size(); }
  bool hasHeard(const std::string& topic) const { return receivedTopics_.contains(topic); }
  /// @return Number of lost messages for each topic that lost any.
  std::map<std::string, std::uint64_t> lost() const;

 private:
  using Clock = std::chrono::steady_clock;

  void discover();
  bool isUseful(const TopicInfo& topic) const;
  void subscribe(const std::string& topic);
  void take(const std::string& topic, std::string_view type, std::span<const std::byte> bytes);

  Transport& transport_;
  Writer& writer_;
  const TopicChoice& choice_;
  CanWrite canWrite_;
  Clock::time_point nextDiscovery_ = Clock::now();
  std::uint64_t messages_ = 0;
  std::set<std::string> receivedTopics_;
  /// Topics that the identity is not allowed to subscribe to.
  std::set<std::string> refused_;
  /// Why recording stopped.
  std::exception_ptr failure_;
  // last, so that what their callbacks use still exists
  std::map<std::string, Subscription> subscriptions_;
};

}  // namespace pongsim::log
