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

/// A topic on ign-transport that the world subscribes to: messages published there are passed to the world.
class IncomingTopic : public std::enable_shared_from_this<IncomingTopic> {
 public:
  /// @param wake Called on a thread of ign-transport when `openNewTypes` has work to do.
  IncomingTopic(std::string name, const Logger& log, std::function<void()> wake);

  const std::string name;

  // On the courier's thread.

  void subscribe();
  void unsubscribe();

  // On the simulation's thread.

  /// Sets the types that the world subscribes to.
  /// @param takesAny Whether it also takes all others.
  void listenTo(Node& simulation, const std::set<std::string>& types, bool takesAny);
  /// Opens newly seen types, if all types are taken.
  void openNewTypes(Node& simulation);
  /// Ends the subscription: nothing reaches the world from then on.
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
  /// Messages that arrived before their type was opened.
  std::deque<Early> early_;
  /// Types without a subscriber, each reported once.
  std::set<std::string> refused_;
};

}  // namespace pongsim::ign
