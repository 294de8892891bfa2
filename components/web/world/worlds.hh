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

/// The worlds of the process, shared by all clients. For any thread.
class Worlds : public std::enable_shared_from_this<Worlds> {
 public:
  /// Callbacks of a client that watches the worlds. Called on the worlds' threads; must be fast, and must not end
  /// watches.
  struct Watch {
    /// Topics, services or worlds have been added or removed.
    std::function<void()> changed;
  };

  /// @return The watch, which lasts until this is destroyed.
  std::shared_ptr<void> watch(Watch watch);

  /// @return All worlds, oldest first.
  std::vector<std::shared_ptr<WorldLink>> all() const;
  /// @return Whether all have listed their topics; they start when the first client connects.
  bool areListsKnown() const;
  /// @return The world with this name, or null.
  std::shared_ptr<WorldLink> find(std::string_view world) const;

  /// A topic or a service, and its world.
  struct TopicPlace {
    std::shared_ptr<WorldLink> world;
    Topic topic;
  };
  struct ServicePlace {
    std::shared_ptr<WorldLink> world;
    OwnService service;
  };
  /// @return The topics of all worlds, sorted by name. If several worlds have a topic, or it has several types, the
  /// first one with publishers.
  std::vector<TopicPlace> topics() const;
  /// @return The services of all worlds, sorted by name; of those with the same name, the first one.
  std::vector<ServicePlace> services() const;

  /// @return The same entry as in `topics` and `services`; nothing if there is none. Cheap.
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
