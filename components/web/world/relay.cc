#include "web/world/relay.hh"

#include <exception>
#include <set>
#include <span>
#include <utility>

namespace pongsim::web {

namespace {

constexpr std::string_view kAnyType = "*";
// Minimum interval of look-ups for a world whose topics change in every step.
constexpr std::chrono::milliseconds kBetweenLooks{50};

}  // namespace

Relay::Relay(std::shared_ptr<Worlds> worlds, const std::string& world, const Node& node, const Logger& log)
    : worlds_(std::move(worlds)),
      node_(node),
      log_(log),
      link_(std::make_shared<WorldLink>(world, [waking = node]() mutable { waking.wake(); })),
      side_(std::make_unique<WorldSide>(node, log)) {
  worlds_->add(link_);
}

Relay::~Relay() {
  heard_.clear();
  for (const auto& wish : link_->end()) wish(*side_);
  side_.reset();
  worlds_->remove(*link_);
}

void Relay::update(const StepInfo& step) {
  link_->setTime(step.time);
  if (link_->takeHasWork()) work();
  side_->giveUpOld();
  if (!worlds_->isWatched()) {
    if (std::exchange(hasLooked_, false)) link_->setListsKnown(false);
    return;
  }
  look();
}

void Relay::tell(const WorldSettings& settings) {
  if (told_ == settings) return;
  told_ = settings;
  link_->setSettings(settings);
}

void Relay::work() {
  for (const auto& wish : link_->takeWishes()) wish(*side_);
  if (link_->takeEarsChanged()) followListeners(node_.ownTopics());
}

/// Lists topics and services, if something may have changed.
void Relay::look() {
  const std::uint64_t topics = node_.ownTopicsVersion();
  const std::uint64_t services = node_.ownServicesVersion();
  if (hasLooked_ && topics == topicsVersion_ && services == servicesVersion_) return;
  const Clock::time_point now = Clock::now();
  if (hasLooked_ && now - lookedAt_ < kBetweenLooks) return;
  hasLooked_ = true;
  lookedAt_ = now;
  topicsVersion_ = topics;
  servicesVersion_ = services;
  const std::vector<OwnTopic> own = node_.ownTopics();
  Lists lists = listsOf(own);
  // a topic received from another process may now be published by the world itself
  followListeners(own);
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
    if (const auto heard = heard_.find({topic.name, topic.type}); heard != heard_.end()) {
      if (heard->second.subscription) --seen.subscribers;
      heard->second.topic->keepLast(topic.isLatched);
    }
    if (seen.publishers + seen.subscribers > 0) lists.topics.push_back(std::move(seen));
  }
  lists.services = node_.ownServices();
  return lists;
}

void Relay::followListeners(const std::vector<OwnTopic>& topics) {
  const auto wanted = link_->heardTopics();
  const std::set<std::shared_ptr<HeardTopic>> all(wanted.begin(), wanted.end());
  std::erase_if(heard_, [&](const auto& each) { return !all.contains(each.second.topic); });
  if (wanted.empty()) return;
  std::map<Key, const OwnTopic*> own;
  for (const OwnTopic& topic : topics) own.emplace(Key(topic.name, topic.type), &topic);
  for (const auto& topic : wanted) {
    const auto found = own.find({topic->name, topic->type});
    // receiving the world's own topics from other processes too would cost a DDS reader
    const bool ownOnly = found != own.end() && found->second->publishers > 0;
    Heard& heard = heard_[{topic->name, topic->type}];
    if (heard.topic && heard.ownOnly == ownOnly) continue;
    topic->keepLast(found != own.end() && found->second->isLatched);
    heard = {topic, {}, ownOnly};
    heard.subscription = subscribe(topic, ownOnly);
  }
}

Subscription Relay::subscribe(const std::shared_ptr<HeardTopic>& topic, bool ownOnly) {
  try {
    return node_.subscribeBytesAtOnce(
        topic->name, topic->type,
        [topic, link = link_](std::size_t size, const std::function<void(std::span<std::byte>)>& write) {
          topic->heard(size, write, link->timeNs());
        },
        {.ownOnly = ownOnly});
  } catch (const std::exception& error) {
    log_.warning("clients can't subscribe to '" + topic->name + "': " + error.what());
    return {};
  }
}

}  // namespace pongsim::web
