#pragma once

#include <atomic>
#include <string>

#include <ignition/transport/Node.hh>

#include "ign/heartbeats.hh"
#include "ign/payload.hh"

namespace pongsim::ign {

/// A topic of the world as ign-transport has it. For the courier's thread, but where it says otherwise.
class OutgoingTopic {
 public:
  /// For any thread: does nothing yet.
  OutgoingTopic(std::string name, std::string type);

  const std::string name;
  const std::string type;

  /// Whether somebody listens, as `look` found. For any thread.
  std::atomic<bool> isHeard = false;

  /// @return False, with words of the library's on stderr, where it can't be had.
  bool advertise();
  void unadvertise();

  /// Sees who listens.
  /// @return Whether `isHeard` has changed.
  bool look(const Heartbeats& heartbeats);

  /// Hands the bytes over, without a copy. Readers that are behind do without.
  void send(Payload payload);

 private:
  bool hasListeners(const Heartbeats& heartbeats) const;

  ignition::transport::Node node_;
  ignition::transport::Node::Publisher publisher_;
  std::string wireName_;
};

}  // namespace pongsim::ign
