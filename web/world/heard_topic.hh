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

/// A client's ear on a topic. Called on the thread of the world, by one at a time; must be quick, and must not end
/// ears.
struct Listener {
  /// Told each message in protobuf's binary form, with the simulated time at which it came [ns].
  std::function<void(const Payload& message, std::uint64_t timeNs)> heard;
  /// Asked for each message before it is written into bytes, so that one that nobody wants costs nothing, and before it
  /// is heard; but not of what is latched. Empty: wants all.
  std::function<bool()> wants = {};
};

/// A topic that clients listen to, all by one subscription: each message is written into bytes once.
class HeardTopic {
 public:
  HeardTopic(std::string topic, std::string messageType);

  const std::string name;
  /// Full name of the message type.
  const std::string type;

  // For any thread.

  /// Who comes later hears the last message of a latched topic at once, on the calling thread.
  void add(std::shared_ptr<const Listener> listener);
  /// Returns when the listener is not called any more.
  void remove(const Listener& listener);

  // On the world's thread.

  /// Whether the last message is kept for who comes later.
  void keepLast(bool keeps);
  /// A message of so many bytes has come, which `write` writes.
  void heard(std::size_t size, const std::function<void(std::span<std::byte>)>& write, std::uint64_t timeNs);

 private:
  struct Ear {
    std::shared_ptr<const Listener> listener;
    /// Whether it wants the message that there is now.
    bool wants = false;
  };
  struct Last {
    Payload message;
    std::uint64_t timeNs;
  };

  std::mutex mutex_;
  std::vector<Ear> ears_;
  bool keepsLast_ = false;
  std::optional<Last> last_;
};

}  // namespace pongsim::web
