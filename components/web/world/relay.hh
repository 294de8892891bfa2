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
#include "web/world/client_endpoints.hh"
#include "web/world/worlds.hh"

namespace pongsim::web {

/// Connects clients to a world: lists its topics and services, subscribes to topics as long as a client does, and runs
/// the tasks of the clients (`WorldLink`). Without clients it only checks three numbers a step. For the world's thread;
/// must not outlive the transport.
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
  void reportSettings(const WorldSettings& settings);

 private:
  using Clock = std::chrono::steady_clock;
  using Key = std::pair<std::string, std::string>;
  struct Subscribed {
    std::shared_ptr<SharedSubscription> shared;
    Subscription subscription;
    /// Whether to receive only from this process, because the world itself publishes the topic.
    bool ownOnly = false;
  };

  void runTasks();
  void updateLists();
  Lists listsOf(const std::vector<OwnTopic>& topics);
  void followSubscriptions(const std::vector<OwnTopic>& topics);
  Subscription subscribe(const std::shared_ptr<SharedSubscription>& shared, bool ownOnly);

  std::shared_ptr<Worlds> worlds_;
  Node node_;
  const Logger& log_;
  std::shared_ptr<WorldLink> link_;
  std::unique_ptr<ClientEndpoints> endpoints_;
  std::map<Key, Subscribed> subscriptions_;
  std::optional<WorldSettings> reported_;
  std::uint64_t topicsVersion_ = 0;
  std::uint64_t servicesVersion_ = 0;
  /// Whether the lists have been updated since the first of the current clients connected.
  bool hasListed_ = false;
  Clock::time_point listedAt_{};
};

}  // namespace pongsim::web
