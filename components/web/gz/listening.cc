#include "web/gz/listening.hh"

#include <algorithm>
#include <optional>
#include <utility>

#include "pongsim/node.hh"
#include "web/gz/frame.hh"
#include "web/gz/picture.hh"
#include "web/world/waiting.hh"

namespace pongsim::web::gz {

namespace {

constexpr std::size_t kMostTopics = 1000;
constexpr std::string_view kImage = "ignition.msgs.Image";

}  // namespace

Listening::Listening(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, const GzSettings& settings)
    : client_(std::move(client)), worlds_(std::move(worlds)), settings_(settings) {}

std::string Listening::add(std::string_view topic, bool asPicture) {
  const std::string name(topic);
  if (const auto error = topicNameError(name)) return "the topic's name '" + name + "' " + *error;
  end(name);
  if (ears_.size() >= kMostTopics) {
    return "a client can subscribe to at most " + std::to_string(kMostTopics) + " topics; '" + name + "' is one more";
  }
  Ear ear;
  ear.key = nextKey_++;
  ear.asPicture = asPicture;
  const auto rate = rates_.find(name);
  const double wanted = rate == rates_.end() ? settings_.publicationHz : rate->second;
  ear.rate = std::make_shared<Rate>(std::min(wanted, settings_.publicationHz));
  std::string error = open(name, ear, worlds_->findTopic(name));
  if (error.empty()) ears_.emplace(name, std::move(ear));
  return error;
}

void Listening::remove(std::string_view topic) {
  end(topic);
  if (const auto rate = rates_.find(topic); rate != rates_.end()) rates_.erase(rate);
}

void Listening::end(std::string_view topic) {
  const auto found = ears_.find(topic);
  if (found == ears_.end()) return;
  found->second.hearing.reset();
  client_->forget(found->second.key);
  ears_.erase(found);
}

std::string Listening::limit(std::string_view topic, double hz) {
  const std::string name(topic);
  if (const auto error = topicNameError(name)) return "the topic's name '" + name + "' " + *error;
  if (!(hz > 0)) return "the rate of '" + name + "' must be above 0";
  if (!rates_.contains(name) && rates_.size() >= kMostTopics) return "too many topics have a rate";
  rates_.insert_or_assign(name, hz);
  const auto found = ears_.find(name);
  if (found != ears_.end()) found->second.rate->set(std::min(hz, settings_.publicationHz));
  return {};
}

void Listening::follow() {
  for (auto& [name, ear] : ears_) {
    if (const std::string error = open(name, ear, worlds_->findTopic(name)); !error.empty()) {
      client_->sendBinary(textFrame("error", name, error));
    }
  }
}

/// Makes the ear listen to the topic in its current state.
std::string Listening::open(const std::string& topic, Ear& ear, const std::optional<Worlds::TopicPlace>& place) {
  if (!place) {
    // it may have been added again
    ear.hearing.reset();
    ear.type.clear();
    ear.world.reset();
    return {};
  }
  if (ear.type == place->topic.type && ear.world == place->world) return {};
  ear.hearing.reset();
  ear.world = place->world;
  ear.type = place->topic.type;
  if (ear.asPicture && ear.type != kImage)
    return "topic '" + topic + "' has messages of type " + ear.type + ", not images";
  if (const auto limit = settings_.subscriptionLimits.find(ear.type); limit != settings_.subscriptionLimits.end()) {
    const auto others = std::ranges::count_if(ears_, [&](const auto& each) {
      return &each.second != &ear && each.second.hearing && each.second.type == ear.type;
    });
    if (others >= limit->second) {
      return "a client can subscribe to at most " + std::to_string(limit->second) + " topics with " + ear.type;
    }
  }
  ear.hearing = ear.world->hear(topic, ear.type, listenerFor(topic, ear));
  return {};
}

Listener Listening::listenerFor(const std::string& topic, const Ear& ear) const {
  Listener listener;
  listener.wants = [rate = ear.rate] { return rate->passes(Rate::Clock::now()); };
  const std::string front = head("pub", topic, ear.type);
  if (ear.asPicture) {
    listener.heard = [client = client_, key = ear.key, front](const Payload& message, std::uint64_t) {
      client->sendWhenFree(key, [front, message]() -> Frame {
        const std::optional<std::string> png = picture(message.bytes());
        return png ? Frame{front, Payload(*png)} : Frame{};
      });
    };
    return listener;
  }
  std::size_t most = mostWaiting(ear.type);
  if (settings_.queueSizePerConnection >= 0) {
    most = std::clamp<std::size_t>(static_cast<std::size_t>(settings_.queueSizePerConnection), 1, most);
  }
  listener.heard = [client = client_, key = ear.key, front, most](const Payload& message, std::uint64_t) {
    client->sendData(key, most, {front, message});
  };
  return listener;
}

}  // namespace pongsim::web::gz
