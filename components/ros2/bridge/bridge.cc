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

struct Bridge::BridgedTopic {
  TopicRule rule;
  bool isLatched = false;
  /// Whether ROS messages are passed to the simulation, now or as soon as it subscribes.
  bool isFromRosWanted = false;
  std::atomic<std::uint64_t> refused = 0;

  /// What `toRos` was made with.
  Frames frames;
  std::unique_ptr<ToRos> toRos;
  std::unique_ptr<RosPublisher> publisher;
  std::unique_ptr<ToIgnition> toIgnition;
  Publisher toSimulation;
  // last, so that they are destroyed first: they call the others
  Subscription fromSimulation;
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
  if (hasLazyReaders_) followSubscribers();
}

void Bridge::followTopics() {
  const RosNode::Quiet quiet(ros_);
  const std::vector<OwnTopic> topics = simulation_.ownTopics();
  if (readVariances_) variances_ = readVariances_();
  followFrames();
  followRules(topics);
  for (BridgedTopic& bridged : bridged_) {
    const bool isOfRule = std::ranges::any_of(settings_.rules, [&](const TopicRule& rule) {
      return rule.ignition == bridged.rule.ignition && rule.pair == bridged.rule.pair && rule.ros == bridged.rule.ros;
    });
    if (isOfRule) continue;
    const bool isThere = settings_.bridgesAll && std::ranges::any_of(topics, [&](const OwnTopic& topic) {
                           return topic.name == bridged.rule.ignition && topic.type == bridged.rule.pair->ignition;
                         });
    if (!isThere) want(bridged, {});
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
    BridgedTopic* bridged = bridgedTopic(rule);
    if (bridged == nullptr) continue;
    try {
      want(*bridged, {topic.publishers > 0, topic.subscriptions > 0, topic.isLatched});
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
    BridgedTopic* bridged = bridgedTopic(rule);
    if (bridged == nullptr) continue;
    const bool isLatched = std::ranges::any_of(topics, [&](const OwnTopic& topic) {
      return topic.name == rule.ignition && topic.type == rule.pair->ignition && topic.isLatched;
    });
    want(*bridged, {rule.goesToRos(), rule.comesFromRos(), isLatched});
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
Bridge::BridgedTopic* Bridge::bridgedTopic(const TopicRule& rule) {
  const auto found = std::ranges::find_if(bridged_, [&](const BridgedTopic& bridged) {
    return bridged.rule.ignition == rule.ignition && bridged.rule.pair == rule.pair && bridged.rule.ros == rule.ros;
  });
  if (found != bridged_.end()) return &*found;
  const auto other =
      std::ranges::find_if(bridged_, [&](const BridgedTopic& bridged) { return bridged.rule.ros == rule.ros; });
  const auto error = rosNameError(rule.ros);
  if (error || (other != bridged_.end() && other->rule.pair->ros != rule.pair->ros)) {
    if (!refusedNames_.insert(rule.ignition + " " + rule.pair->ignition).second) return nullptr;
    ros_.log().warning("topic '" + rule.ignition + "' is not bridged: " +
                       (error ? "its name in ROS, '" + rule.ros + "', " + *error
                              : "ROS topic '" + rule.ros + "' already has type " + std::string(other->rule.pair->ros) +
                                    ", from '" + other->rule.ignition + "'"));
    return nullptr;
  }
  BridgedTopic& bridged = bridged_.emplace_back();
  bridged.rule = rule;
  return &bridged;
}

void Bridge::want(BridgedTopic& bridged, const Directions& wanted) {
  if (wanted.fromRos && !bridged.isFromRosWanted) openFromRos(bridged);
  if (!wanted.fromRos && bridged.isFromRosWanted) {
    bridged.subscription.reset();
    bridged.toSimulation = {};
  }
  bridged.isFromRosWanted = wanted.fromRos;
  if (wanted.toRos && !bridged.publisher) openToRos(bridged, wanted.isLatched);
  if (!wanted.toRos && bridged.publisher) {
    bridged.fromSimulation = {};
    bridged.publisher.reset();
  }
}

Frames Bridge::framesOf(const TopicRule& rule) const {
  Frames frames = settings_.frames;
  frames.prefix = rule.framePrefix.value_or(frames.prefix);
  frames.frameId = rule.frameId;
  if (const auto found = variances_.find(rule.ignition); found != variances_.end()) frames.variances = found->second;
  return frames;
}

void Bridge::openToRos(BridgedTopic& bridged, bool isLatched) {
  const TopicRule& rule = bridged.rule;
  bridged.isLatched = isLatched;
  bridged.frames = framesOf(rule);
  bridged.toRos = rule.pair->toRos(bridged.frames);
  bridged.publisher = std::make_unique<RosPublisher>(ros_, rule.ros, rule.pair->type(), writerQos(rule, isLatched),
                                                     [this] { ++readersVersion_; });
  ++readersVersion_;
}

void Bridge::openFromRos(BridgedTopic& bridged) {
  const TopicRule& rule = bridged.rule;
  bridged.toIgnition = rule.pair->toIgnition(framesOf(rule));
  bridged.toSimulation = simulation_.advertise(rule.ignition, rule.pair->ignition, {.relays = true});
  if (isLazyFromRos(rule)) {
    hasLazyReaders_ = true;
  } else {
    read(bridged);
  }
}

void Bridge::read(BridgedTopic& bridged) {
  const TopicRule& rule = bridged.rule;
  bridged.subscription = std::make_unique<RosSubscription>(
      ros_, rule.ros, rule.pair->type(), readerQos(rule), [this, &bridged](const Sample& sample) {
        std::string error;
        if (const Message* message = bridged.toIgnition->convert(sample.payload, error)) {
          bridged.toSimulation.publish(*message);
        } else {
          ++bridged.refused;
          ros_.complainOf(bridged.rule.ros, error);
        }
      });
}

void Bridge::followReaders() {
  for (BridgedTopic& bridged : bridged_) {
    if (!bridged.publisher) continue;
    const bool isAwaited = !isLazyToRos(bridged.rule, bridged.isLatched) || bridged.publisher->hasReaders();
    if (isAwaited && !bridged.fromSimulation) subscribe(bridged);
    if (!isAwaited && bridged.fromSimulation) bridged.fromSimulation = {};
  }
}

void Bridge::followSubscribers() {
  for (BridgedTopic& bridged : bridged_) {
    if (!bridged.isFromRosWanted || !isLazyFromRos(bridged.rule)) continue;
    const bool isAwaited = bridged.toSimulation.hasSubscribers();
    if (isAwaited && !bridged.subscription) read(bridged);
    if (!isAwaited && bridged.subscription) bridged.subscription.reset();
  }
}

void Bridge::subscribe(BridgedTopic& bridged) {
  bridged.fromSimulation = simulation_.subscribeAtOnce(
      bridged.rule.ignition, bridged.rule.pair->ignition,
      [&bridged](const Message& message, const Bulk* bulk) {
        bridged.toRos->convert(message, bulk, [&bridged](std::size_t size, const Fill& fill) {
          bridged.publisher->writer().write(size, fill);
        });
      },
      {.relays = true});
}

std::vector<Offer> Bridge::offers() const {
  std::vector<Offer> all;
  for (const BridgedTopic& bridged : bridged_) {
    Offer& offer = all.emplace_back(Offer{bridged.rule.ros, bridged.rule.ignition, bridged.rule.pair});
    if (bridged.publisher) offer.writer = writerQos(bridged.rule, bridged.isLatched);
    if (bridged.subscription) offer.reader = readerQos(bridged.rule);
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
  followFrames();
}

/// A topic may be bridged before its sensor is there.
void Bridge::followFrames() {
  for (BridgedTopic& bridged : bridged_) {
    Frames frames = framesOf(bridged.rule);
    if (!bridged.publisher || frames == bridged.frames) continue;
    bridged.frames = std::move(frames);
    // ends the subscription first, because it calls `toRos`
    bridged.fromSimulation = {};
    bridged.toRos = bridged.rule.pair->toRos(bridged.frames);
    ++readersVersion_;
  }
}

std::vector<Bridge::Topic> Bridge::topics() const {
  std::vector<Topic> all;
  for (const BridgedTopic& bridged : bridged_) {
    Topic& topic = all.emplace_back();
    topic.ros = bridged.rule.ros;
    topic.ignition = bridged.rule.ignition;
    topic.pair = bridged.rule.pair;
    if (bridged.publisher) {
      topic.isToRos = true;
      topic.readers = bridged.publisher->writer().readers();
      topic.sent = bridged.publisher->writer().sent();
      topic.dropped = bridged.publisher->writer().dropped();
    }
    topic.isFromRos = bridged.isFromRosWanted;
    topic.refused = bridged.refused;
    if (bridged.subscription) {
      topic.writers = bridged.subscription->reader().writers();
      topic.received = bridged.subscription->reader().received();
    }
  }
  return all;
}

}  // namespace pongsim::ros2
