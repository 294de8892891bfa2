// What a process sees of the bus and of what others offer on it.
#include <algorithm>
#include <chrono>
#include <iterator>
#include <tuple>

#include "transport/any_type.hh"
#include "transport/bus.hh"
#include "transport/deadline.hh"
#include "transport/names/service_name.hh"
#include "transport/names/topic_name.hh"
#include "transport/names/type_name.hh"
#include "transport/network/network.hh"

namespace pongsim::transport {

std::vector<OwnTopic> Bus::ownTopics(const DispatchQueue& queue) {
  const std::lock_guard lock(setUp_);
  std::vector<OwnTopic> topics;
  for (const auto& [key, channel] : channels_) {
    const auto found = channel->usersOf.find(&queue);
    if (found == channel->usersOf.end()) continue;
    const Channel::Users& users = found->second;
    const int publishers = users.publishers - users.relayingPublishers;
    const int subscriptions = users.subscriptions - users.relayingSubscriptions;
    if (publishers + subscriptions == 0) continue;
    topics.push_back({channel->topic, channel->type, publishers, subscriptions, users.latchedPublishers > 0,
                      users.relayingPublishers});
  }
  for (const auto& any : anyTypes_) {
    if (any->queue == &queue && !any->options.relays)
      topics.push_back({any->topic, std::string(kAnyType), 0, 1, false, 0});
  }
  std::ranges::stable_sort(topics, {}, [](const OwnTopic& topic) { return std::tie(topic.name, topic.type); });
  return topics;
}

std::vector<OwnService> Bus::ownServices(const DispatchQueue& queue) {
  std::vector<OwnService> services = server_.services(queue);
  const std::lock_guard lock(setUp_);
  if (queues_.size() < 2 || queues_[1].get() != &queue) return services;
  // what it offers itself comes first where both have a name
  std::ranges::move(server_.services(*queues_.front()), std::back_inserter(services));
  std::ranges::stable_sort(services, {}, &OwnService::name);
  const auto twice = std::ranges::unique(services, {}, &OwnService::name);
  services.erase(twice.begin(), twice.end());
  return services;
}

/// What has passed through each channel.
TrafficReport Bus::traffic() {
  const std::lock_guard lock(setUp_);
  TrafficReport report;
  report.at = std::chrono::steady_clock::now().time_since_epoch();
  for (const auto& [key, channel] : channels_) {
    if (channel->users.publishers > channel->users.ownOnlyPublishers) {
      report.endpoints.push_back({channel->topic, channel->type, Role::kPublisher, channel->sent,
                                  channel->writer ? channel->writer->dropped() : 0});
    }
    if (channel->users.subscriptions == channel->users.ownOnlySubscriptions) continue;
    EndpointTraffic heard{channel->topic, channel->type, Role::kSubscriber, 0,
                          channel->reader ? channel->reader->lost() : 0};
    const std::lock_guard inboxesLock(mutex_);
    for (const Inbox* inbox : channel->inboxes) {
      heard.messages += inbox->received();
      heard.dropped += inbox->dropped();
    }
    report.endpoints.push_back(std::move(heard));
  }
  return report;
}

void Bus::announce() {
  if (network_) network_->announce();
}

std::vector<TopicInfo> Bus::discover(std::chrono::nanoseconds timeout) {
  if (!network_) return {};
  heardAll_ = network_->discover(timeout);
  return network_->directory().topics();
}

TopicInfo Bus::waitForTopic(std::string_view topic, bool wantPublisher, std::chrono::nanoseconds timeout) {
  const std::string name = absoluteTopic(topic);
  if (!network_) return {name, {}, {}};
  network_->announce();
  network_->directory().waitForTopic(name, wantPublisher ? Role::kPublisher : Role::kSubscriber,
                                     deadlineAfter(timeout));
  return network_->directory().topic(name);
}

TopicInfo Bus::watchTopic(std::string_view topic, std::chrono::nanoseconds duration) {
  const std::string name = absoluteTopic(topic);
  if (!network_) return {name, {}, {}};
  network_->watchTraffic(duration);
  return network_->directory().topic(name);
}

std::vector<ServiceInfo> Bus::discoverServices(std::chrono::nanoseconds timeout) {
  if (!network_) return {};
  heardAll_ = network_->discover(timeout);
  return network_->directory().services();
}

ServiceInfo Bus::waitForService(std::string_view service, std::chrono::nanoseconds timeout) {
  const std::string name = absoluteService(service);
  if (!network_) return {name, {}};
  network_->announce();
  network_->directory().waitForTopic(requestTopic(name), Role::kSubscriber, deadlineAfter(timeout));
  return network_->directory().service(name);
}

}  // namespace pongsim::transport
