#include "web/foxglove/channels.hh"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "web/foxglove/status.hh"
#include "web/foxglove/wire.hh"

namespace pongsim::web::foxglove {

namespace {

using nlohmann::json;

json jsonOf(std::uint32_t id, const Offer& offer) {
  json channel = {{"id", id},
                  {"topic", offer.topic},
                  {"encoding", offer.encoding},
                  {"schemaName", offer.schemaName},
                  {"schema", offer.schema ? *offer.schema : std::string()}};
  if (!offer.schemaEncoding.empty()) channel["schemaEncoding"] = offer.schemaEncoding;
  return channel;
}

}  // namespace

Channels::Channels(std::shared_ptr<Client> client) : client_(std::move(client)) {}

void Channels::follow(std::vector<Offer> offers) {
  std::map<std::string_view, const Offer*> wanted;
  for (const Offer& offer : offers) wanted.emplace(offer.topic, &offer);
  json gone = json::array();
  for (auto each = channels_.begin(); each != channels_.end();) {
    const auto found = wanted.find(each->second.topic);
    if (found != wanted.end() && found->second->isAs(each->second)) {
      wanted.erase(found);
      ++each;
      continue;
    }
    for (auto subscription = subscribed_.begin(); subscription != subscribed_.end();) {
      const auto current = subscription++;
      if (current->second.channel == each->first) end(current);
    }
    gone.push_back(each->first);
    each = channels_.erase(each);
  }
  if (!gone.empty()) client_->sendText(textOf({{"op", "unadvertise"}, {"channelIds", std::move(gone)}}));

  json come = json::array();
  for (const auto& [topic, offer] : wanted) {
    const std::uint32_t id = nextChannel_++;
    come.push_back(jsonOf(id, *offer));
    channels_.emplace(id, *offer);
  }
  // clients wait for the first list, even an empty one
  if (come.empty() && std::exchange(hasTold_, true)) return;
  hasTold_ = true;
  client_->sendText(textOf({{"op", "advertise"}, {"channels", std::move(come)}}));
}

std::string Channels::subscribe(std::uint32_t subscription, std::uint32_t channel) {
  const auto found = channels_.find(channel);
  // it may have been removed while the request was on its way
  if (found == channels_.end()) return "there is no channel " + std::to_string(channel);
  if (subscribed_.contains(subscription)) {
    return "subscription " + std::to_string(subscription) + " already exists";
  }
  if (std::ranges::any_of(subscribed_, [&](const auto& each) { return each.second.channel == channel; })) {
    return "channel " + std::to_string(channel) + " already has a subscription";
  }
  Head head = [subscription](std::uint64_t timeNs) { return dataHead(subscription, timeNs); };
  subscribed_[subscription] = {channel, found->second.open(client_, subscription, std::move(head))};
  return {};
}

std::string Channels::unsubscribe(std::uint32_t subscription) {
  const auto found = subscribed_.find(subscription);
  if (found == subscribed_.end()) return "there is no subscription " + std::to_string(subscription);
  end(found);
  return {};
}

void Channels::end(std::map<std::uint32_t, Subscribed>::iterator subscription) {
  subscription->second.open.reset();
  client_->forget(subscription->first);
  subscribed_.erase(subscription);
}

}  // namespace pongsim::web::foxglove
