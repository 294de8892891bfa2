#pragma once

#include <chrono>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "pongsim/log.hh"
#include "pongsim/node.hh"

namespace pongsim::web {

/// What clients have in a world: publishers, and pending requests. On the world's thread.
class WorldSide {
 public:
  /// @param log Must outlive it.
  WorldSide(const Node& node, const Logger& log);
  /// Fails the pending requests: the world has ended.
  ~WorldSide();
  WorldSide(const WorldSide&) = delete;
  WorldSide& operator=(const WorldSide&) = delete;

  /// Opens a publisher with this number. A topic that can't be opened is skipped with a warning.
  void open(std::uint64_t voice, const std::string& topic, const std::string& type);
  void publish(std::uint64_t voice, std::span<const std::byte> message);
  void close(std::uint64_t voice);

  /// @param answered Called once.
  void request(const OwnService& service, const Message& request, Answered answered);

  /// Fails requests that have had no reply for 10 s. Cheap if there are none.
  void giveUpOld();

 private:
  using Clock = std::chrono::steady_clock;
  struct Waiting {
    std::string service;
    Clock::time_point until;
    Answered answered;
    PendingRequest pending;
  };

  void answer(std::list<Waiting>::iterator waiting, const CallResult& result, const Message* reply);

  Node node_;
  const Logger& log_;
  std::map<std::uint64_t, Publisher> voices_;
  /// Oldest first.
  std::list<Waiting> waiting_;
  /// Answered, but must not be destroyed inside their callback.
  std::list<Waiting> answered_;
};

}  // namespace pongsim::web
