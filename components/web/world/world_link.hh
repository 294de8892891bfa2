#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/service.hh"
#include "web/world/lists.hh"
#include "web/world/shared_subscription.hh"
#include "web/world/world_settings.hh"

namespace pongsim::web {

class ClientEndpoints;
class RemotePublisher;

/// Clients' access to a world. For any thread: what has to be done in the world is queued for its thread, and the world
/// is woken. May outlive the world; then requests fail, and no messages arrive.
class WorldLink : public std::enable_shared_from_this<WorldLink> {
 public:
  /// @param wake Makes the world run the queued tasks soon.
  WorldLink(std::string world, std::function<void()> wake);

  const std::string& world() const { return world_; }
  /// @return The simulated time of the last step [ns].
  std::uint64_t timeNs() const { return timeNs_.load(std::memory_order_relaxed); }
  /// @return Topics and services, as of the last look.
  std::shared_ptr<const Lists> lists() const;

  /// @return Whether topics and services have been looked up since somebody started watching the worlds.
  bool areListsKnown() const { return areListsKnown_.load(std::memory_order_acquire); }
  /// @return The current settings that can be changed; nothing if they are not known yet, or the world has ended.
  std::optional<WorldSettings> settings() const;

  /// Subscribes to a topic, until the result is destroyed.
  /// @param type Full name of the message type.
  std::shared_ptr<void> subscribe(const std::string& topic, const std::string& type, Listener listener);

  /// @param type Full name of the message type, which must be known.
  /// @return Null if too much is waiting for the world.
  std::unique_ptr<RemotePublisher> advertise(const std::string& topic, const std::string& type);

  /// Calls a service of the world.
  /// @param answered Called once, on the world's thread or the caller's.
  void request(const OwnService& service, std::shared_ptr<const Message> request, Answered answered);

  /// Makes the world look for changes of what clients need.
  void changed();

 private:
  friend class Relay;
  friend class RemotePublisher;
  /// Called on the world's thread.
  using Task = std::function<void(ClientEndpoints&)>;

  bool post(std::size_t bytes, Task task);
  void unsubscribe(const std::pair<std::string, std::string>& key);

  // called by `Relay`
  std::vector<Task> takeTasks();
  std::vector<std::shared_ptr<SharedSubscription>> subscriptions();
  void setLists(std::shared_ptr<const Lists> lists);
  void setListsKnown(bool known) { areListsKnown_.store(known, std::memory_order_release); }
  void setSettings(const WorldSettings& settings);
  void setTime(std::chrono::nanoseconds time) {
    timeNs_.store(static_cast<std::uint64_t>(time.count()), std::memory_order_relaxed);
  }
  bool takeHasWork() { return take(hasWork_); }
  /// @return Whether subscriptions have started or ended since the last call.
  bool takeSubscriptionsChanged() { return take(haveSubscriptionsChanged_); }
  static bool take(std::atomic<bool>& flag) {
    return flag.load(std::memory_order_relaxed) && flag.exchange(false, std::memory_order_acquire);
  }
  /// @return The remaining tasks.
  std::vector<Task> end();

  const std::string world_;
  std::atomic<std::uint64_t> timeNs_ = 0;
  std::atomic<bool> hasWork_ = false;
  std::atomic<bool> haveSubscriptionsChanged_ = false;
  std::atomic<bool> areListsKnown_ = false;
  std::atomic<std::uint64_t> nextPublisher_ = 0;
  mutable std::mutex mutex_;
  /// Empty when the world has ended.
  std::function<void()> wake_;
  std::shared_ptr<const Lists> lists_ = std::make_shared<const Lists>();
  std::optional<WorldSettings> settings_;
  std::vector<Task> tasks_;
  std::size_t taskBytes_ = 0;
  struct Counted {
    std::shared_ptr<SharedSubscription> subscription;
    /// Number of listeners, including those about to be added.
    int listeners = 0;
  };
  /// Keyed by name and type. Never lock a subscription's mutex while holding `mutex_`: a listener may post a task.
  std::map<std::pair<std::string, std::string>, Counted> subscriptions_;
};

/// A client's publisher on a topic of a world, which ends when this is destroyed. For any thread.
class RemotePublisher {
 public:
  /// @param number Identifies it in the world (`ClientEndpoints::open`).
  RemotePublisher(std::shared_ptr<WorldLink> link, std::uint64_t number) : link_(std::move(link)), number_(number) {}
  ~RemotePublisher();
  RemotePublisher(const RemotePublisher&) = delete;
  RemotePublisher& operator=(const RemotePublisher&) = delete;

  /// @param message In protobuf's binary format.
  /// @return Whether it is queued; false if too much is waiting for the world.
  bool publish(Payload message);

 private:
  const std::shared_ptr<WorldLink> link_;
  const std::uint64_t number_;
};

}  // namespace pongsim::web
