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

/// The publishers and pending service requests of clients in a world. On the world's thread.
class ClientEndpoints {
 public:
  /// @param log Must outlive it.
  ClientEndpoints(const Node& node, const Logger& log);
  /// Fails the pending requests: the world has ended.
  ~ClientEndpoints();
  ClientEndpoints(const ClientEndpoints&) = delete;
  ClientEndpoints& operator=(const ClientEndpoints&) = delete;

  /// Opens a publisher under this number. A topic that can't be opened is skipped with a warning.
  void open(std::uint64_t publisher, const std::string& topic, const std::string& type);
  void publish(std::uint64_t publisher, std::span<const std::byte> message);
  void close(std::uint64_t publisher);

  /// @param answered Called once.
  void request(const OwnService& service, const Message& request, Answered answered);

  /// Fails requests that have had no reply for 10 s. Cheap if there are none.
  void failOverdue();

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
  std::map<std::uint64_t, Publisher> publishers_;
  /// Oldest first.
  std::list<Waiting> waiting_;
  /// Answered requests; destroyed later, because a request must not be destroyed inside its own callback.
  std::list<Waiting> answered_;
};

}  // namespace pongsim::web
