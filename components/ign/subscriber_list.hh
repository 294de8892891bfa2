#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pongsim::ign {

/// Tells other processes to which topics this one subscribes. Since version 13 the library answers requests for that,
/// which `gz topic -l` and `gz topic -i` make; Debian's does not know them. For one thread at a time.
class SubscriberList {
 public:
  /// The type of a request in discovery, SUBSCRIBERS_REQ.
  static constexpr int kRequest = 8;
  /// The type of an answer, SUBSCRIBERS_REP; there is one for each topic and type.
  static constexpr int kReply = 9;

  /// @param address IPv4 address at which this process uses ign-transport.
  explicit SubscriberList(const std::string& address);
  ~SubscriberList();
  SubscriberList(const SubscriberList&) = delete;
  SubscriberList& operator=(const SubscriberList&) = delete;

  /// Sends the answers to the group of discovery.
  /// @param subscriptions Names of topics, without the partition, and types on the wire.
  void send(const std::vector<std::pair<std::string, std::string>>& subscriptions) const;

 private:
  int socket_ = -1;
  const std::string address_;
  const std::string node_;
};

}  // namespace pongsim::ign
