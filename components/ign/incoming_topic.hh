#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <ignition/transport/Node.hh>

#include "pongsim/log.hh"
#include "pongsim/node.hh"

namespace pongsim::ign {

/// A topic on ign-transport to which the world subscribes: its messages are passed to the world.
class IncomingTopic : public std::enable_shared_from_this<IncomingTopic> {
 public:
  /// @param wake Called on a thread of ign-transport when a message of a new type has arrived: `openNewTypes` has to be
  /// called.
  IncomingTopic(std::string name, const Logger& log, std::function<void()> wake);

  const std::string name;

  // For the courier's thread.

  void subscribe();
  void unsubscribe();

  // For the simulation's thread.

  /// Sets the message types to which the world subscribes.
  /// @param takesAny Whether the world subscribes to messages of any type.
  void listenTo(Node& simulation, const std::set<std::string>& types, bool takesAny);
  /// If all types are taken, makes publishers for types that have arrived since the last call, and publishes their
  /// messages.
  void openNewTypes(Node& simulation);
  /// Ends the subscription: no message is passed to the world after this call.
  void end();

 private:
  struct Early {
    std::string type;
    std::vector<std::byte> bytes;
  };

  void receive(const std::string& type, std::span<const std::byte> bytes);
  void open(Node& simulation, const std::string& type);

  const Logger& log_;
  std::function<void()> wake_;
  ignition::transport::Node node_;

  std::mutex mutex_;
  bool hasEnded_ = false;
  bool takesAny_ = false;
  std::map<std::string, Publisher> publishers_;
  /// Messages that arrived before there was a publisher for their type.
  std::deque<Early> early_;
  /// Types to which the world does not subscribe, each reported once.
  std::set<std::string> refused_;
};

}  // namespace pongsim::ign
