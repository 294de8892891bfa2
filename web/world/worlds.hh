#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "web/world/world_link.hh"

namespace pongsim::web {

/// The worlds of the process, for the clients of all of them. For any thread.
class Worlds : public std::enable_shared_from_this<Worlds> {
 public:
  /// A client's eye on the worlds. Called on the threads of the worlds; must be quick, and must not end watches.
  struct Watch {
    /// Topics, services or worlds have come or gone.
    std::function<void()> changed;
  };

  /// @return Watched until it is destroyed.
  std::shared_ptr<void> watch(Watch watch);

  /// @return In the order in which they have come.
  std::vector<std::shared_ptr<WorldLink>> all() const;
  /// @return The world of that name, or null.
  std::shared_ptr<WorldLink> find(std::string_view world) const;

  /// A topic or a service, and the world that has it.
  struct TopicPlace {
    std::shared_ptr<WorldLink> world;
    Topic topic;
  };
  struct ServicePlace {
    std::shared_ptr<WorldLink> world;
    OwnService service;
  };
  /// @return The topics of all worlds, sorted by name. Of one that several worlds have, or that has several types,
  /// the one with publishers, of several the first.
  std::vector<TopicPlace> topics() const;
  /// @return The services of all worlds, sorted by name; of those of one name the first.
  std::vector<ServicePlace> services() const;

  /// @return As `topics` and `services` have it; nothing where there is none. Cheap.
  std::optional<TopicPlace> findTopic(std::string_view name) const;
  std::optional<ServicePlace> findService(std::string_view name) const;

 private:
  friend class Relay;
  void add(std::shared_ptr<WorldLink> world);
  void remove(const WorldLink& world);
  void changed();
  bool isWatched() const { return watchCount_.load(std::memory_order_relaxed) > 0; }

  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<WorldLink>> worlds_;
  std::mutex watching_;
  std::vector<std::shared_ptr<const Watch>> watches_;
  std::atomic<int> watchCount_ = 0;
};

}  // namespace pongsim::web
