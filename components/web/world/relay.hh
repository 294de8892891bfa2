#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "pongsim/system.hh"
#include "web/world/world_side.hh"
#include "web/world/worlds.hh"

namespace pongsim::web {

/// Connects clients to a world: reports its topics and services, subscribes to topics as long as a client does, and
/// carries out the clients' wishes. Without clients it only checks three numbers a step. For the world's thread; must
/// not outlive the transport.
class Relay {
 public:
  /// @param log Must outlive it.
  Relay(std::shared_ptr<Worlds> worlds, const std::string& world, const Node& node, const Logger& log);
  ~Relay();
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

  /// Call in each step, in `preUpdate`.
  void update(const StepInfo& step);

  /// Reports the world's current settings to clients: call in each step. Cheap if nothing has changed.
  void tell(const WorldSettings& settings);

 private:
  using Clock = std::chrono::steady_clock;
  using Key = std::pair<std::string, std::string>;
  struct Heard {
    std::shared_ptr<HeardTopic> topic;
    Subscription subscription;
    /// Whether to receive only from this process, because the world itself publishes the topic.
    bool ownOnly = false;
  };

  void work();
  void look();
  Lists listsOf(const std::vector<OwnTopic>& topics);
  void followListeners(const std::vector<OwnTopic>& topics);
  Subscription subscribe(const std::shared_ptr<HeardTopic>& topic, bool ownOnly);

  std::shared_ptr<Worlds> worlds_;
  Node node_;
  const Logger& log_;
  std::shared_ptr<WorldLink> link_;
  std::unique_ptr<WorldSide> side_;
  std::map<Key, Heard> heard_;
  std::optional<WorldSettings> told_;
  std::uint64_t topicsVersion_ = 0;
  std::uint64_t servicesVersion_ = 0;
  /// Whether topics and services have been looked up since the last client connected.
  bool hasLooked_ = false;
  Clock::time_point lookedAt_{};
};

}  // namespace pongsim::web
