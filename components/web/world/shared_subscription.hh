#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "web/server/session.hh"

namespace pongsim::web {

/// A client's subscription to a topic. Called on the world's thread, one call at a time; must be fast, and must not end
/// subscriptions.
struct Listener {
  /// Called with each message in protobuf's binary format and its simulated time of arrival [ns].
  std::function<void(const Payload& message, std::uint64_t timeNs)> received;
  /// Called for each message before it is serialized, so that messages nobody wants cost nothing; not called for
  /// latched messages. Empty: wants all.
  std::function<bool()> wants = {};
};

/// The subscription to a topic that all its clients share: each message is serialized once.
class SharedSubscription {
 public:
  SharedSubscription(std::string topic, std::string messageType);

  const std::string name;
  /// Full name of the message type.
  const std::string type;

  // For any thread.

  /// A late subscriber to a latched topic gets the last message immediately, on the calling thread.
  void add(std::shared_ptr<const Listener> listener);
  /// Returns when the listener is no longer being called.
  void remove(const Listener& listener);

  // On the world's thread.

  /// Sets whether the last message is kept for late subscribers.
  void keepLast(bool keeps);
  /// Call for each message: `write` serializes it into `size` bytes.
  void receive(std::size_t size, const std::function<void(std::span<std::byte>)>& write, std::uint64_t timeNs);

 private:
  struct Subscriber {
    std::shared_ptr<const Listener> listener;
    /// Whether it wants the current message.
    bool wants = false;
  };
  struct Last {
    Payload message;
    std::uint64_t timeNs;
  };

  std::mutex mutex_;
  std::vector<Subscriber> subscribers_;
  bool keepsLast_ = false;
  std::optional<Last> last_;
};

}  // namespace pongsim::web
