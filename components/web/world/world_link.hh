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
#include "web/world/heard_topic.hh"
#include "web/world/lists.hh"
#include "web/world/world_settings.hh"

namespace pongsim::web {

class WorldSide;

/// Clients' access to a world. For any thread; changes to the world are queued as wishes, and the world is woken. May
/// outlive the world: then nothing more arrives, and nothing is done.
class WorldLink : public std::enable_shared_from_this<WorldLink> {
 public:
  /// @param wake Makes the world carry out wishes soon.
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
  std::shared_ptr<void> hear(const std::string& topic, const std::string& type, Listener listener);

  /// A client's publisher on a topic, which ends when it is destroyed.
  class Voice {
   public:
    virtual ~Voice() = default;
    /// @param message In protobuf's binary format.
    /// @return Whether it is queued; false if too much is waiting for the world.
    virtual bool publish(Payload message) = 0;
  };
  /// @param type Full name of the message type, which must be known.
  /// @return Null if too much is waiting for the world.
  std::shared_ptr<Voice> speak(const std::string& topic, const std::string& type);

  /// Calls a service of the world.
  /// @param answered Called once, on the world's thread or the caller's.
  void request(const OwnService& service, std::shared_ptr<const Message> request, Answered answered);

  /// Makes the world look for changes of what clients need.
  void changed();

 private:
  friend class Relay;
  class SpokenTopic;
  /// Something to do on the world's thread.
  using Wish = std::function<void(WorldSide&)>;

  bool post(std::size_t bytes, Wish wish);
  void heardNoMore(const std::pair<std::string, std::string>& key);

  // called by `Relay`
  std::vector<Wish> takeWishes();
  std::vector<std::shared_ptr<HeardTopic>> heardTopics();
  void setLists(std::shared_ptr<const Lists> lists);
  void setListsKnown(bool known) { areListsKnown_.store(known, std::memory_order_release); }
  void setSettings(const WorldSettings& settings);
  void setTime(std::chrono::nanoseconds time) {
    timeNs_.store(static_cast<std::uint64_t>(time.count()), std::memory_order_relaxed);
  }
  bool takeHasWork() { return take(hasWork_); }
  /// @return Whether subscriptions have started or ended since the last call.
  bool takeEarsChanged() { return take(haveEarsChanged_); }
  static bool take(std::atomic<bool>& flag) {
    return flag.load(std::memory_order_relaxed) && flag.exchange(false, std::memory_order_acquire);
  }
  /// @return The remaining wishes.
  std::vector<Wish> end();

  const std::string world_;
  std::atomic<std::uint64_t> timeNs_ = 0;
  std::atomic<bool> hasWork_ = false;
  std::atomic<bool> haveEarsChanged_ = false;
  std::atomic<bool> areListsKnown_ = false;
  std::atomic<std::uint64_t> nextVoice_ = 0;
  mutable std::mutex mutex_;
  /// Empty when the world has ended.
  std::function<void()> wake_;
  std::shared_ptr<const Lists> lists_ = std::make_shared<const Lists>();
  std::optional<WorldSettings> settings_;
  std::vector<Wish> wishes_;
  std::size_t wishBytes_ = 0;
  struct Heard {
    std::shared_ptr<HeardTopic> topic;
    /// Number of current and future subscriptions.
    int ears = 0;
  };
  /// Keyed by name and type. Never lock a topic's mutex while holding this one, because a listener may queue a wish.
  std::map<std::pair<std::string, std::string>, Heard> heard_;
};

}  // namespace pongsim::web
