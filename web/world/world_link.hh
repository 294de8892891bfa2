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

/// A world as clients reach it. For any thread; what touches the world is left there as a wish, and the world is woken.
/// It may outlive the world: then nothing comes any more, and nothing is done.
class WorldLink : public std::enable_shared_from_this<WorldLink> {
 public:
  /// @param wake Has the world carry out wishes soon.
  WorldLink(std::string world, std::function<void()> wake);

  const std::string& world() const { return world_; }
  /// @return The simulated time of the last step [ns].
  std::uint64_t timeNs() const { return timeNs_.load(std::memory_order_relaxed); }
  /// @return What there was when it was last looked at.
  std::shared_ptr<const Lists> lists() const;

  /// @return Whether it has been looked what there is since somebody watches the worlds.
  bool areListsKnown() const { return areListsKnown_.load(std::memory_order_acquire); }
  /// @return What can be set of it, as it is; nothing where that is not known yet, or the world has ended.
  std::optional<WorldSettings> settings() const;

  /// Listens to a topic, until what is returned is destroyed.
  /// @param type Full name of the message type.
  std::shared_ptr<void> hear(const std::string& topic, const std::string& type, Listener listener);

  /// Something that a client publishes on a topic, until it is destroyed.
  class Voice {
   public:
    virtual ~Voice() = default;
    /// @param message In protobuf's binary form.
    /// @return Whether it is on its way; false where too much waits for the world.
    virtual bool publish(Payload message) = 0;
  };
  /// @param type Full name of the message type, which is known.
  /// @return Null where too much waits for the world.
  std::shared_ptr<Voice> speak(const std::string& topic, const std::string& type);

  /// Asks a service of the world.
  /// @param answered Called once, on the world's thread or the caller's.
  void request(const OwnService& service, std::shared_ptr<const Message> request, Answered answered);

  /// Has the world see what has changed for clients.
  void changed();

 private:
  friend class Relay;
  class SpokenTopic;
  /// Something to be done on the world's thread.
  using Wish = std::function<void(WorldSide&)>;

  bool post(std::size_t bytes, Wish wish);
  void heardNoMore(const std::pair<std::string, std::string>& key);

  // what `Relay` does with it
  std::vector<Wish> takeWishes();
  std::vector<std::shared_ptr<HeardTopic>> heardTopics();
  void setLists(std::shared_ptr<const Lists> lists);
  void setListsKnown(bool known) { areListsKnown_.store(known, std::memory_order_release); }
  void setSettings(const WorldSettings& settings);
  void setTime(std::chrono::nanoseconds time) {
    timeNs_.store(static_cast<std::uint64_t>(time.count()), std::memory_order_relaxed);
  }
  bool takeHasWork() { return take(hasWork_); }
  /// @return Whether somebody has begun or ended to listen since it was asked last.
  bool takeEarsChanged() { return take(haveEarsChanged_); }
  static bool take(std::atomic<bool>& flag) {
    return flag.load(std::memory_order_relaxed) && flag.exchange(false, std::memory_order_acquire);
  }
  /// @return The wishes that are left.
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
    /// How many listen, or are about to.
    int ears = 0;
  };
  /// By name and type. A topic's own mutex is never taken with this one held, for who hears a message may wish for
  /// something.
  std::map<std::pair<std::string, std::string>, Heard> heard_;
};

}  // namespace pongsim::web
