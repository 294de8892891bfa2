#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "web/gz/rate.hh"
#include "web/gz/settings.hh"
#include "web/server/session.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::gz {

/// What one client subscribes to, including topics that do not exist yet. For the server's thread.
class Subscriptions {
 public:
  /// @param settings Must outlive it.
  Subscriptions(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, const GzSettings& settings);

  /// Subscribes; an existing subscription to the topic is replaced.
  /// @param asPicture As PNG, for a topic with images.
  /// @return What is wrong, as a sentence without a full stop, or an empty text.
  std::string add(std::string_view topic, bool asPicture);
  void remove(std::string_view topic);
  /// Limits the rate of the topic's messages, also if the client subscribes later.
  /// @return See `add`.
  std::string limit(std::string_view topic, double hz);

  /// Opens subscriptions for new topics, and closes those of removed ones.
  void follow();

 private:
  struct TopicSubscription {
    std::uint64_t key = 0;
    bool asPicture = false;
    /// The current message type: empty if the topic does not exist.
    std::string type;
    std::shared_ptr<WorldLink> world;
    std::shared_ptr<Rate> rate;
    /// Null while the topic does not exist.
    std::shared_ptr<void> handle;
  };

  std::string open(const std::string& topic, TopicSubscription& subscription,
                   const std::optional<Worlds::TopicPlace>& place);
  void end(std::string_view topic);
  Listener listenerFor(const std::string& topic, const TopicSubscription& subscription) const;

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  const GzSettings& settings_;
  std::uint64_t nextKey_ = 1;
  std::map<std::string, TopicSubscription, std::less<>> subscriptions_;
  /// Rate limits set by the client, by topic.
  std::map<std::string, double, std::less<>> rates_;
};

}  // namespace pongsim::web::gz
