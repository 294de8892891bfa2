#include "ros2/bridge/bridge.hh"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "ros2/config/quality.hh"
#include "ros2/pairs/pairs.hh"

namespace pongsim::ros2 {

namespace {

// Names that are the same in every namespace.
constexpr std::string_view kGlobalNames[] = {"/clock", "/tf", "/tf_static"};

}  // namespace

struct Bridge::Entry {
  TopicRule rule;
  bool isLatched = false;
  /// Whether ROS messages are passed to the simulation, now or as soon as it subscribes.
  bool isFromRosWanted = false;
  std::atomic<std::uint64_t> refused = 0;

  ToRos toRos;
  std::unique_ptr<RosPublisher> publisher;
  ToIgnition toIgnition;
  Publisher toSimulation;
  // destroyed first, because they use the others
  Subscription heard;
  std::unique_ptr<RosSubscription> subscription;
};

Bridge::Bridge(const Node& simulation, RosNode& ros, const Settings& settings)
    : simulation_(simulation),
      ros_(ros),
      settings_(settings),
      topicsVersion_(simulation_.ownTopicsVersion() - 1),
      mismatches_(ros) {}

Bridge::~Bridge() = default;

void Bridge::update() {
  // endpoints opened here change the version once more, without further work
  if (const std::uint64_t version = simulation_.ownTopicsVersion(); version != topicsVersion_) {
    topicsVersion_ = version;
    followTopics();
  }
  if (readersVersion_.load(std::memory_order_relaxed) != knownReaders_) {
    knownReaders_ = readersVersion_;
    followReaders();
  }
  mismatches_.update(topicsVersion_, [this] { return offers(); });
  if (hasLazyReaders_) followListeners();
}

void Bridge::followTopics() {
  const RosNode::Quiet quiet(ros_);
  const std::vector<OwnTopic> topics = simulation_.ownTopics();
  followRules(topics);
  for (Entry& entry : entries_) {
    const bool isOfRule = std::ranges::any_of(settings_.rules, [&](const TopicRule& rule) {
      return rule.ignition == entry.rule.ignition && rule.pair == entry.rule.pair && rule.ros == entry.rule.ros;
    });
    if (isOfRule) continue;
    const bool isThere = settings_.bridgesAll && std::ranges::any_of(topics, [&](const OwnTopic& topic) {
                           return topic.name == entry.rule.ignition && topic.type == entry.rule.pair->ignition;
                         });
    if (!isThere) want(entry, {});
  }
  for (const OwnTopic& topic : topics) {
    const bool hasRule = std::ranges::any_of(settings_.rules, [&](const TopicRule& rule) {
      return rule.ignition == topic.name && (rule.pair == nullptr || rule.pair->ignition == topic.type);
    });
    const Pair* pair = defaultPair(topic.type);
    if (hasRule || pair == nullptr || !settings_.bridgesAll) continue;
    TopicRule rule;
    rule.ignition = topic.name;
    rule.ros = rosNameFor(topic.name);
    if (std::ranges::find(kGlobalNames, rule.ros) == std::end(kGlobalNames)) {
      rule.ros = absoluteName(settings_.nameSpace, rule.ros.substr(1));
    }
    rule.pair = pair;
    if (reserved_.contains(rule.ros) || isTakenByRule(rule)) continue;
    Entry* entry = entryFor(rule);
    if (entry == nullptr) continue;
    try {
      want(*entry, {topic.publishers > 0, topic.subscriptions > 0, topic.isLatched});
    } catch (const std::runtime_error& error) {
      // an enclave's permissions may deny a topic that no rule names
      if (refusedNames_.insert(topic.name + " " + topic.type).second) {
        ros_.log().warning("topic '" + topic.name + "' is not bridged: " + error.what());
      }
    }
  }
}

/// Whether a rule gives the ROS name to another topic of the simulation.
bool Bridge::isTakenByRule(const TopicRule& automatic) {
  const auto found = std::ranges::find(settings_.rules, automatic.ros, &TopicRule::ros);
  if (found == settings_.rules.end()) return false;
  if (refusedNames_.insert(automatic.ignition + " " + automatic.pair->ignition).second) {
    ros_.log().warning("topic '" + automatic.ignition + "' is not bridged: the configuration gives its ROS name, '" +
                       automatic.ros + "', to '" + found->ignition + "'");
  }
  return true;
}

void Bridge::followRules(const std::vector<OwnTopic>& topics) {
  for (const TopicRule& rule : settings_.rules) {
    if (rule.pair == nullptr) continue;
    warnOfOtherTypes(rule, topics);
    Entry* entry = entryFor(rule);
    if (entry == nullptr) continue;
    const bool isLatched = std::ranges::any_of(topics, [&](const OwnTopic& topic) {
      return topic.name == rule.ignition && topic.type == rule.pair->ignition && topic.isLatched;
    });
    want(*entry, {rule.goesToRos(), rule.comesFromRos(), isLatched});
  }
}

/// A rule for a type that the topic does not have has no effect; without a warning that is hard to find.
void Bridge::warnOfOtherTypes(const TopicRule& rule, const std::vector<OwnTopic>& topics) {
  for (const OwnTopic& topic : topics) {
    if (topic.name != rule.ignition || topic.type == rule.pair->ignition || topic.type == "*") continue;
    if (!refusedNames_.insert(topic.name + " " + topic.type).second) continue;
    const SourcePosition& place = rule.position;
    const std::string where =
        place.line > 0 ? *place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": "
                       : "";
    ros_.log().warning(where + "topic '" + topic.name + "' of the simulation has type " + topic.type +
                       ", but the configuration bridges it as " + rule.pair->ignition);
  }
}

/// @return Null if another topic already has the ROS name.
Bridge::Entry* Bridge::entryFor(const TopicRule& rule) {
  const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) {
    return entry.rule.ignition == rule.ignition && entry.rule.pair == rule.pair && entry.rule.ros == rule.ros;
  });
  if (found != entries_.end()) return &*found;
  const auto other = std::ranges::find_if(entries_, [&](const Entry& entry) { return entry.rule.ros == rule.ros; });
  const auto error = rosNameError(rule.ros);
  if (error || (other != entries_.end() && other->rule.pair->ros != rule.pair->ros)) {
    if (!refusedNames_.insert(rule.ignition + " " + rule.pair->ignition).second) return nullptr;
    ros_.log().warning("topic '" + rule.ignition + "' is not bridged: " +
                       (error ? "its name in ROS, '" + rule.ros + "', " + *error
                              : "ROS topic '" + rule.ros + "' already has type " + std::string(other->rule.pair->ros) +
                                    ", from '" + other->rule.ignition + "'"));
    return nullptr;
  }
  Entry& entry = entries_.emplace_back();
  entry.rule = rule;
  return &entry;
}

void Bridge::want(Entry& entry, const Wanted& wanted) {
  if (wanted.fromRos && !entry.isFromRosWanted) openFromRos(entry);
  if (!wanted.fromRos && entry.isFromRosWanted) {
    entry.subscription.reset();
    entry.toSimulation = {};
  }
  entry.isFromRosWanted = wanted.fromRos;
  if (wanted.toRos && !entry.publisher) openToRos(entry, wanted.isLatched);
  if (!wanted.toRos && entry.publisher) {
    entry.heard = {};
    entry.publisher.reset();
  }
}

Frames Bridge::framesOf(const TopicRule& rule) const {
  Frames frames = settings_.frames;
  frames.prefix = rule.framePrefix.value_or(frames.prefix);
  frames.frameId = rule.frameId;
  return frames;
}

void Bridge::openToRos(Entry& entry, bool isLatched) {
  const TopicRule& rule = entry.rule;
  entry.isLatched = isLatched;
  entry.toRos = rule.pair->toRos(framesOf(rule));
  entry.publisher = std::make_unique<RosPublisher>(ros_, rule.ros, rule.pair->type(), writerQos(rule, isLatched),
                                                   [this] { ++readersVersion_; });
  ++readersVersion_;
}

void Bridge::openFromRos(Entry& entry) {
  const TopicRule& rule = entry.rule;
  entry.toIgnition = rule.pair->toIgnition(framesOf(rule));
  entry.toSimulation = simulation_.advertise(rule.ignition, rule.pair->ignition, {.relays = true});
  if (isLazyFromRos(rule)) {
    hasLazyReaders_ = true;
  } else {
    read(entry);
  }
}

void Bridge::read(Entry& entry) {
  const TopicRule& rule = entry.rule;
  entry.subscription = std::make_unique<RosSubscription>(
      ros_, rule.ros, rule.pair->type(), readerQos(rule), [this, &entry](const Sample& sample) {
        std::string error;
        if (const Message* message = entry.toIgnition(sample.payload, error)) {
          entry.toSimulation.publish(*message);
        } else {
          ++entry.refused;
          ros_.complainOf(entry.rule.ros, error);
        }
      });
}

void Bridge::followReaders() {
  for (Entry& entry : entries_) {
    if (!entry.publisher) continue;
    const bool isAwaited = !isLazyToRos(entry.rule, entry.isLatched) || entry.publisher->hasReaders();
    if (isAwaited && !entry.heard) listen(entry);
    if (!isAwaited && entry.heard) entry.heard = {};
  }
}

void Bridge::followListeners() {
  for (Entry& entry : entries_) {
    if (!entry.isFromRosWanted || !isLazyFromRos(entry.rule)) continue;
    const bool isAwaited = entry.toSimulation.hasSubscribers();
    if (isAwaited && !entry.subscription) read(entry);
    if (!isAwaited && entry.subscription) entry.subscription.reset();
  }
}

void Bridge::listen(Entry& entry) {
  entry.heard = simulation_.subscribeAtOnce(entry.rule.ignition, entry.rule.pair->ignition,
                                            [&entry](const Message& message, const Bulk* bulk) {
                                              entry.toRos(message, bulk, [&entry](std::size_t size, const Fill& fill) {
                                                entry.publisher->writer().write(size, fill);
                                              });
                                            },
                                            {.relays = true});
}

std::vector<Offer> Bridge::offers() const {
  std::vector<Offer> all;
  for (const Entry& entry : entries_) {
    Offer& offer = all.emplace_back(Offer{entry.rule.ros, entry.rule.ignition, entry.rule.pair});
    if (entry.publisher) offer.writer = writerQos(entry.rule, entry.isLatched);
    if (entry.subscription) offer.reader = readerQos(entry.rule);
  }
  return all;
}

void Bridge::setBridgesAll(bool all) {
  if (all == settings_.bridgesAll) return;
  settings_.bridgesAll = all;
  --topicsVersion_;
}

void Bridge::setWallTime(bool isUsed) {
  if (isUsed == settings_.frames.usesWallTime) return;
  settings_.frames.usesWallTime = isUsed;
  for (Entry& entry : entries_) {
    if (!entry.publisher) continue;
    // it is not called while it changes
    entry.heard = {};
    entry.toRos = entry.rule.pair->toRos(framesOf(entry.rule));
  }
  ++readersVersion_;
}

std::vector<Bridge::Topic> Bridge::topics() const {
  std::vector<Topic> all;
  for (const Entry& entry : entries_) {
    Topic& topic = all.emplace_back();
    topic.ros = entry.rule.ros;
    topic.ignition = entry.rule.ignition;
    topic.pair = entry.rule.pair;
    if (entry.publisher) {
      topic.isToRos = true;
      topic.readers = entry.publisher->writer().readers();
      topic.sent = entry.publisher->writer().sent();
      topic.dropped = entry.publisher->writer().dropped();
    }
    topic.isFromRos = entry.isFromRosWanted;
    topic.refused = entry.refused;
    if (entry.subscription) {
      topic.writers = entry.subscription->reader().writers();
      topic.received = entry.subscription->reader().received();
    }
  }
  return all;
}

}  // namespace pongsim::ros2
