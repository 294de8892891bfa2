#include "web/foxglove/subscriptions.hh"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "web/foxglove/status.hh"
#include "web/foxglove/wire.hh"
#include "web/server/traffic.hh"

namespace pongsim::web::foxglove {

namespace {

using nlohmann::json;

json jsonOf(std::uint32_t id, const Channel& channel) {
  json description = {{"id", id},
                      {"topic", channel.topic},
                      {"encoding", channel.encoding},
                      {"schemaName", channel.schemaName},
                      {"schema", channel.schema ? *channel.schema : std::string()}};
  if (!channel.schemaEncoding.empty()) description["schemaEncoding"] = channel.schemaEncoding;
  return description;
}

}  // namespace

Subscriptions::Subscriptions(std::shared_ptr<Client> client) : client_(std::move(client)) {}

void Subscriptions::follow(std::vector<Channel> channels) {
  std::map<std::string_view, const Channel*> wanted;
  for (const Channel& channel : channels) wanted.emplace(channel.topic, &channel);
  json removed = json::array();
  for (auto each = channels_.begin(); each != channels_.end();) {
    const auto found = wanted.find(each->second.topic);
    if (found != wanted.end() && found->second->isSame(each->second)) {
      wanted.erase(found);
      ++each;
      continue;
    }
    for (auto subscription = subscriptions_.begin(); subscription != subscriptions_.end();) {
      const auto current = subscription++;
      if (current->second.channel == each->first) end(current);
    }
    removed.push_back(each->first);
    each = channels_.erase(each);
  }
  if (!removed.empty()) client_->sendText(textOf({{"op", "unadvertise"}, {"channelIds", std::move(removed)}}));

  json added = json::array();
  for (const auto& [topic, channel] : wanted) {
    const std::uint32_t id = nextChannel_++;
    added.push_back(jsonOf(id, *channel));
    channels_.emplace(id, *channel);
  }
  // clients wait for the first list, even an empty one
  if (added.empty() && std::exchange(hasAdvertised_, true)) return;
  hasAdvertised_ = true;
  client_->sendText(textOf({{"op", "advertise"}, {"channels", std::move(added)}}));
}

std::string Subscriptions::subscribe(std::uint32_t subscription, std::uint32_t channel) {
  const auto found = channels_.find(channel);
  // it may have been removed while the request was on its way
  if (found == channels_.end()) return "there is no channel " + std::to_string(channel);
  if (subscriptions_.contains(subscription)) {
    return "subscription " + std::to_string(subscription) + " already exists";
  }
  if (std::ranges::any_of(subscriptions_, [&](const auto& each) { return each.second.channel == channel; })) {
    return "channel " + std::to_string(channel) + " already has a subscription";
  }
  client_->traffic().name(subscription, found->second.topic);
  Head head = [subscription](std::uint64_t timeNs) { return dataHead(subscription, timeNs); };
  subscriptions_[subscription] = {channel, found->second.open(client_, subscription, std::move(head))};
  return {};
}

std::string Subscriptions::unsubscribe(std::uint32_t subscription) {
  const auto found = subscriptions_.find(subscription);
  if (found == subscriptions_.end()) return "there is no subscription " + std::to_string(subscription);
  end(found);
  return {};
}

std::string Subscriptions::ask(std::uint32_t subscription, const json& wish) {
  const auto found = subscriptions_.find(subscription);
  // its channel may have been removed while the request was on its way
  if (found == subscriptions_.end()) return "there is no subscription " + std::to_string(subscription);
  const Channel& channel = channels_.at(found->second.channel);
  if (!channel.ask) return "'" + channel.topic + "' sends by itself";
  return channel.ask(found->second.open, wish);
}

void Subscriptions::end(std::map<std::uint32_t, Subscription>::iterator subscription) {
  subscription->second.open.reset();
  client_->forget(subscription->first);
  subscriptions_.erase(subscription);
}

}  // namespace pongsim::web::foxglove
