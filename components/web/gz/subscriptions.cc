#include "web/gz/subscriptions.hh"

#include <algorithm>
#include <optional>
#include <utility>

#include "pongsim/node.hh"
#include "web/gz/frame.hh"
#include "web/gz/picture.hh"
#include "web/server/traffic.hh"
#include "web/world/queue_depth.hh"

namespace pongsim::web::gz {

namespace {

constexpr std::size_t kMostTopics = 1000;
constexpr std::string_view kImage = "ignition.msgs.Image";

}  // namespace

Subscriptions::Subscriptions(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, const GzSettings& settings)
    : client_(std::move(client)), worlds_(std::move(worlds)), settings_(settings) {}

std::string Subscriptions::add(std::string_view topic, bool asPicture) {
  const std::string name(topic);
  if (const auto error = topicNameError(name)) return "the topic's name '" + name + "' " + *error;
  end(name);
  if (subscriptions_.size() >= kMostTopics) {
    return "a client can subscribe to at most " + std::to_string(kMostTopics) + " topics; '" + name + "' is one more";
  }
  TopicSubscription subscription;
  subscription.key = nextKey_++;
  client_->traffic().name(subscription.key, name);
  subscription.asPicture = asPicture;
  const auto rate = rates_.find(name);
  const double wanted = rate == rates_.end() ? settings_.publicationHz : rate->second;
  subscription.rate = std::make_shared<Rate>(std::min(wanted, settings_.publicationHz));
  std::string error = open(name, subscription, worlds_->findTopic(name));
  if (error.empty()) subscriptions_.emplace(name, std::move(subscription));
  return error;
}

void Subscriptions::remove(std::string_view topic) {
  end(topic);
  if (const auto rate = rates_.find(topic); rate != rates_.end()) rates_.erase(rate);
}

void Subscriptions::end(std::string_view topic) {
  const auto found = subscriptions_.find(topic);
  if (found == subscriptions_.end()) return;
  found->second.handle.reset();
  client_->forget(found->second.key);
  subscriptions_.erase(found);
}

std::string Subscriptions::limit(std::string_view topic, double hz) {
  const std::string name(topic);
  if (const auto error = topicNameError(name)) return "the topic's name '" + name + "' " + *error;
  if (!(hz > 0)) return "the rate of '" + name + "' must be above 0";
  if (!rates_.contains(name) && rates_.size() >= kMostTopics) return "too many topics have a rate";
  rates_.insert_or_assign(name, hz);
  const auto found = subscriptions_.find(name);
  if (found != subscriptions_.end()) found->second.rate->set(std::min(hz, settings_.publicationHz));
  return {};
}

void Subscriptions::follow() {
  for (auto& [name, subscription] : subscriptions_) {
    if (const std::string error = open(name, subscription, worlds_->findTopic(name)); !error.empty()) {
      client_->sendBinary(textFrame("error", name, error));
    }
  }
}

/// Subscribes to the topic as it is now: its world, its type.
std::string Subscriptions::open(const std::string& topic, TopicSubscription& subscription,
                                const std::optional<Worlds::TopicPlace>& place) {
  if (!place) {
    // forgets type and world: if the topic is added again, it has to be subscribed to again
    subscription.handle.reset();
    subscription.type.clear();
    subscription.world.reset();
    return {};
  }
  if (subscription.type == place->topic.type && subscription.world == place->world) return {};
  subscription.handle.reset();
  subscription.world = place->world;
  subscription.type = place->topic.type;
  if (subscription.asPicture && subscription.type != kImage)
    return "topic '" + topic + "' has messages of type " + subscription.type + ", not images";
  if (const auto limit = settings_.subscriptionLimits.find(subscription.type);
      limit != settings_.subscriptionLimits.end()) {
    const auto others = std::ranges::count_if(subscriptions_, [&](const auto& each) {
      return &each.second != &subscription && each.second.handle && each.second.type == subscription.type;
    });
    if (others >= limit->second) {
      return "a client can subscribe to at most " + std::to_string(limit->second) + " topics with " + subscription.type;
    }
  }
  subscription.handle = subscription.world->subscribe(topic, subscription.type, listenerFor(topic, subscription));
  return {};
}

Listener Subscriptions::listenerFor(const std::string& topic, const TopicSubscription& subscription) const {
  Listener listener;
  listener.wants = [rate = subscription.rate] { return rate->passes(Rate::Clock::now()); };
  const std::string front = head("pub", topic, subscription.type);
  if (subscription.asPicture) {
    listener.received = [client = client_, key = subscription.key, front](const Payload& message, std::uint64_t) {
      client->sendWhenFree(key, [front, message]() -> Frame {
        const std::optional<std::string> png = picture(message.bytes());
        return png ? Frame{front, Payload(*png)} : Frame{};
      });
    };
    return listener;
  }
  std::size_t depth = queueDepth(subscription.type);
  if (settings_.queueSizePerConnection >= 0) {
    depth = std::clamp<std::size_t>(static_cast<std::size_t>(settings_.queueSizePerConnection), 1, depth);
  }
  listener.received = [client = client_, key = subscription.key, front, depth](const Payload& message, std::uint64_t) {
    client->sendData(key, depth, {front, message});
  };
  return listener;
}

}  // namespace pongsim::web::gz
