#include "web/world/relay.hh"

#include <exception>
#include <set>
#include <span>
#include <utility>

namespace pongsim::web {

namespace {

constexpr std::string_view kAnyType = "*";
// Minimum interval between updates, for a world whose topics change in every step.
constexpr std::chrono::milliseconds kListInterval{50};

}  // namespace

Relay::Relay(std::shared_ptr<Worlds> worlds, const std::string& world, const Node& node, const Logger& log)
    : worlds_(std::move(worlds)),
      node_(node),
      log_(log),
      link_(std::make_shared<WorldLink>(world, [waking = node]() mutable { waking.wake(); })),
      endpoints_(std::make_unique<ClientEndpoints>(node, log)) {
  worlds_->add(link_);
}

Relay::~Relay() {
  subscriptions_.clear();
  for (const auto& task : link_->end()) task(*endpoints_);
  endpoints_.reset();
  worlds_->remove(*link_);
}

void Relay::update(const StepInfo& step) {
  link_->setTime(step.time);
  if (link_->takeHasWork()) runTasks();
  endpoints_->failOverdue();
  if (!worlds_->isWatched()) {
    if (std::exchange(hasListed_, false)) link_->setListsKnown(false);
    return;
  }
  updateLists();
}

void Relay::reportSettings(const WorldSettings& settings) {
  if (reported_ == settings) return;
  reported_ = settings;
  link_->setSettings(settings);
}

void Relay::runTasks() {
  for (const auto& task : link_->takeTasks()) task(*endpoints_);
  if (link_->takeSubscriptionsChanged()) followSubscriptions(node_.ownTopics());
}

/// Lists topics and services again if their versions have changed.
void Relay::updateLists() {
  const std::uint64_t topics = node_.ownTopicsVersion();
  const std::uint64_t services = node_.ownServicesVersion();
  if (hasListed_ && topics == topicsVersion_ && services == servicesVersion_) return;
  const Clock::time_point now = Clock::now();
  if (hasListed_ && now - listedAt_ < kListInterval) return;
  hasListed_ = true;
  listedAt_ = now;
  topicsVersion_ = topics;
  servicesVersion_ = services;
  const std::vector<OwnTopic> own = node_.ownTopics();
  Lists lists = listsOf(own);
  // a topic received from another process may now be published by the world itself
  followSubscriptions(own);
  const bool isFirst = !link_->areListsKnown();
  const bool isSame = lists == *link_->lists();
  if (!isSame) link_->setLists(std::make_shared<const Lists>(std::move(lists)));
  if (isFirst) link_->setListsKnown(true);
  if (isFirst || !isSame) worlds_->changed();
}

Lists Relay::listsOf(const std::vector<OwnTopic>& topics) {
  Lists lists;
  for (const OwnTopic& topic : topics) {
    if (topic.type == kAnyType) continue;
    Topic seen{topic.name, topic.type, topic.publishers + topic.relayingPublishers, topic.subscriptions,
               topic.isLatched};
    if (const auto found = subscriptions_.find({topic.name, topic.type}); found != subscriptions_.end()) {
      // our own is not reported
      if (found->second.subscription) --seen.subscribers;
      found->second.shared->keepLast(topic.isLatched);
    }
    if (seen.publishers + seen.subscribers > 0) lists.topics.push_back(std::move(seen));
  }
  lists.services = node_.ownServices();
  return lists;
}

void Relay::followSubscriptions(const std::vector<OwnTopic>& topics) {
  const auto wanted = link_->subscriptions();
  const std::set<std::shared_ptr<SharedSubscription>> all(wanted.begin(), wanted.end());
  std::erase_if(subscriptions_, [&](const auto& each) { return !all.contains(each.second.shared); });
  if (wanted.empty()) return;
  std::map<Key, const OwnTopic*> own;
  for (const OwnTopic& topic : topics) own.emplace(Key(topic.name, topic.type), &topic);
  for (const auto& shared : wanted) {
    const auto found = own.find({shared->name, shared->type});
    // receiving the world's own topics from other processes too would cost a DDS reader
    const bool ownOnly = found != own.end() && found->second->publishers > 0;
    Subscribed& subscribed = subscriptions_[{shared->name, shared->type}];
    if (subscribed.shared && subscribed.ownOnly == ownOnly) continue;
    shared->keepLast(found != own.end() && found->second->isLatched);
    subscribed = {shared, {}, ownOnly};
    subscribed.subscription = subscribe(shared, ownOnly);
  }
}

Subscription Relay::subscribe(const std::shared_ptr<SharedSubscription>& shared, bool ownOnly) {
  try {
    return node_.subscribeBytesAtOnce(
        shared->name, shared->type,
        [shared, link = link_](std::size_t size, const std::function<void(std::span<std::byte>)>& write) {
          shared->receive(size, write, link->timeNs());
        },
        {.ownOnly = ownOnly});
  } catch (const std::exception& error) {
    log_.warning("clients can't subscribe to '" + shared->name + "': " + error.what());
    return {};
  }
}

}  // namespace pongsim::web
