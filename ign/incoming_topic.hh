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

/// A topic that the world listens to, as ign-transport has it: what is published there goes to the world.
class IncomingTopic : public std::enable_shared_from_this<IncomingTopic> {
 public:
  /// @param wake Called on a thread of ign-transport when `openNewTypes` has something to do.
  IncomingTopic(std::string name, const Logger& log, std::function<void()> wake);

  const std::string name;

  // On the courier's thread.

  void subscribe();
  void unsubscribe();

  // On the simulation's thread.

  /// Says which types the world listens to.
  /// @param takesAny Whether it takes all others, too.
  void listenTo(Node& simulation, const std::set<std::string>& types, bool takesAny);
  /// Opens the types that have come where all are taken.
  void openNewTypes(Node& simulation);
  /// Ends it: nothing goes to the world from then on.
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
  /// What came before its type was opened.
  std::deque<Early> early_;
  /// Types that nobody listens to, complained of once each.
  std::set<std::string> refused_;
};

}  // namespace pongsim::ign
