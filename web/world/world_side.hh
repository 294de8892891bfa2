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

/// What clients have in a world: publishers, and requests that wait for their answers. On the world's thread.
class WorldSide {
 public:
  /// @param log Must outlive it.
  WorldSide(const Node& node, const Logger& log);
  /// Answers the requests that wait: the world has ended.
  ~WorldSide();
  WorldSide(const WorldSide&) = delete;
  WorldSide& operator=(const WorldSide&) = delete;

  /// Speaks on a topic, under that number. A topic that can't be had is left out with a warning.
  void open(std::uint64_t voice, const std::string& topic, const std::string& type);
  void publish(std::uint64_t voice, std::span<const std::byte> message);
  void close(std::uint64_t voice);

  /// @param answered Called once.
  void request(const OwnService& service, const Message& request, Answered answered);

  /// Answers requests to which nobody has answered for 10 s. Cheap where none waits.
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
  /// The oldest first.
  std::list<Waiting> waiting_;
  /// Answered, but not to be destroyed from within their answer.
  std::list<Waiting> answered_;
};

}  // namespace pongsim::web
