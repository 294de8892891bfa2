#pragma once

#include <atomic>
#include <string>

#include <ignition/transport/Node.hh>

#include "ign/heartbeats.hh"
#include "ign/payload.hh"

namespace pongsim::ign {

/// A topic of the world that is published on ign-transport. For the courier's thread, unless noted otherwise.
class OutgoingTopic {
 public:
  /// For any thread: does not call the library.
  /// @param type On the wire.
  OutgoingTopic(std::string name, std::string type);

  const std::string name;
  const std::string type;

  /// Whether there are subscribers, as of the last `look`. May be read on any thread.
  std::atomic<bool> isHeard = false;

  /// @return False on failure; the library then prints an error on stderr.
  bool advertise();
  void unadvertise();

  /// Checks for subscribers.
  /// @return Whether `isHeard` has changed.
  bool look(const Heartbeats& heartbeats);

  /// Sends the bytes without copying them. ZeroMQ drops messages for subscribers that are too slow.
  void send(Payload payload);

 private:
  bool hasListeners(const Heartbeats& heartbeats) const;

  ignition::transport::Node node_;
  ignition::transport::Node::Publisher publisher_;
  std::string wireName_;
};

}  // namespace pongsim::ign
