#include "ros2/recording/ros2_encoder.hh"

#include <google/protobuf/message.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "ros2/config/bridge_file.hh"
#include "ros2/config/quality.hh"
#include "ros2/config/rules.hh"
#include "ros2/node/names.hh"
#include "ros2/pairs/pairs.hh"
#include "ros2/recording/offered_quality.hh"

namespace pongsim::ros2 {

namespace {

constexpr const char* kConfigFile = "config_file";
constexpr const char* kTransformTopic = "/tf";
constexpr const char* kFixedTransforms = "/tf_static";

/// @return Whether it is the default topic on which a drive publishes its robot's pose: "/model/M/tf".
bool isOdometry(std::string_view topic, std::string_view type) {
  return type == "ignition.msgs.Pose_V" && topic.starts_with("/model/") && topic.ends_with("/tf") &&
         std::ranges::count(topic, '/') == 3;
}

TopicRule automaticRule(const std::string& topic, const std::string& ros, const Pair& pair) {
  TopicRule rule;
  rule.ignition = topic;
  rule.ros = ros;
  rule.pair = &pair;
  return rule;
}

EncodedTopic encodedTopicOf(const TopicRule& rule) {
  const TypeInfo type = rule.pair->type();
  const Qos qos = writerQos(rule, rule.ros == kFixedTransforms);
  return {rule.ros,
          type.name,
          "cdr",
          "ros2msg",
          rule.pair->definition(),
          {{"offered_qos_profiles", offeredQuality(qos)}, {"topic_type_hash", type.hash}}};
}

class Ros2TopicEncoder final : public TopicEncoder {
 public:
  /// @param rules One or more, for one topic and type of the simulation.
  explicit Ros2TopicEncoder(const std::vector<TopicRule>& rules) : message_(newMessage(rules.front().pair->ignition)) {
    for (const TopicRule& rule : rules) {
      topics_.push_back(encodedTopicOf(rule));
      conversions_.push_back(rule.pair->toRos({.prefix = rule.framePrefix.value_or(""), .frameId = rule.frameId}));
    }
  }

  const std::vector<EncodedTopic>& topics() const override { return topics_; }

  void encode(std::span<const std::byte> message, const Take& take) override {
    if (!std::in_range<int>(message.size()) ||
        !message_->ParseFromArray(message.data(), static_cast<int>(message.size()))) {
      throw std::runtime_error(std::to_string(message.size()) + " bytes are not of type " + message_->GetTypeName());
    }
    for (std::size_t i = 0; i < conversions_.size(); ++i) {
      conversions_[i]->convert(*message_, nullptr, [this](std::size_t size, const Fill& fill) {
        payload_.resize(size);
        fill(payload_);
      });
      take(i, payload_);
    }
  }

 private:
  std::vector<EncodedTopic> topics_;
  std::vector<std::unique_ptr<ToRos>> conversions_;
  MessagePointer message_;
  std::vector<std::byte> payload_;
};

class Ros2TopicDecoder final : public TopicDecoder {
 public:
  explicit Ros2TopicDecoder(const Pair& pair) : type_(pair.ignition), conversion_(pair.toIgnition({})) {
    encoding_.type = pair.type().name;
    encoding_.messageEncoding = "cdr";
    encoding_.schemaEncoding = "ros2msg";
    encoding_.schema = pair.definition();
  }

  const EncodedTopic& encoding() const override { return encoding_; }
  std::string messageType() const override { return type_; }

  const Message& decode(std::span<const std::byte> payload) override {
    std::string error;
    const Message* message = conversion_->convert(payload, error);
    if (message == nullptr) throw std::runtime_error(error);
    return *message;
  }

 private:
  EncodedTopic encoding_;
  std::string type_;
  std::unique_ptr<ToIgnition> conversion_;
};

}  // namespace

std::unique_ptr<MessageEncoder> Ros2Encoder::make(const EncoderSettings& settings, Diagnostics& diagnostics) {
  Diagnostics found;
  Rules rules;
  for (const auto& [name, value] : settings) {
    if (name == kConfigFile) {
      rules = makeRules(readBridgeFile(value, found), {}, found);
    } else {
      found.error({}, "the ROS 2 encoding has no setting '" + name + "'");
    }
  }
  for (const Diagnostic& each : found.all()) diagnostics.add(each);
  if (found.hasErrors()) return nullptr;
  return std::make_unique<Ros2Encoder>(std::move(rules.topics));
}

/// @return The topic's counterparts in ROS; or why there are none.
std::variant<std::vector<TopicRule>, std::string> Ros2Encoder::rulesFor(const std::string& topic,
                                                                        const std::string& type) const {
  std::vector<TopicRule> found;
  for (const TopicRule& rule : rules_) {
    if (rule.ignition == topic && rule.pair->ignition == type) found.push_back(rule);
  }
  if (!found.empty()) return found;
  const Pair* pair = defaultPair(type);
  if (pair == nullptr) return type + " has no counterpart in ROS";
  TopicRule rule = automaticRule(topic, rosNameFor(topic), *pair);
  if (const auto wrong = rosNameError(rule.ros)) return "its name in ROS, '" + rule.ros + "', " + *wrong;
  if (std::string other = takenBy(rule); !other.empty()) return other;
  found.push_back(std::move(rule));
  if (isOdometry(topic, type)) {
    rule = automaticRule(topic, kTransformTopic, *pair);
    if (takenBy(rule).empty()) found.push_back(std::move(rule));
  }
  return found;
}

/// @return Which topic has the ROS name already, as the end of a sentence; empty: none.
std::string Ros2Encoder::takenBy(const TopicRule& rule) const {
  const auto said = std::ranges::find(rules_, rule.ros, &TopicRule::ros);
  // transforms of several robots share one topic
  const bool isShared = rule.ros == kTransformTopic && said != rules_.end() && said->pair->ros == rule.pair->ros;
  if (said != rules_.end() && !isShared)
    return "the configuration gives its ROS name, '" + rule.ros + "', to '" + said->ignition + "'";
  const auto other = taken_.find(rule.ros);
  if (other == taken_.end() || other->second.pair->ros == rule.pair->ros) return {};
  return "ROS topic '" + rule.ros + "' already has type " + std::string(other->second.pair->ros) + ", from '" +
         other->second.ignition + "'";
}

std::variant<std::unique_ptr<TopicEncoder>, std::string> Ros2Encoder::openTopic(std::string_view topic,
                                                                                std::string_view type) {
  const std::string fullType = messageTypeName(type).value_or(std::string(type));
  const auto found = rulesFor(std::string(topic), fullType);
  if (const auto* why = std::get_if<std::string>(&found)) return *why;
  const auto& rules = std::get<std::vector<TopicRule>>(found);
  for (const TopicRule& rule : rules) taken_.emplace(rule.ros, rule);
  return std::make_unique<Ros2TopicEncoder>(rules);
}

std::variant<std::unique_ptr<TopicDecoder>, std::string> Ros2Encoder::openInput(std::string_view ros,
                                                                                std::string_view type) {
  const Pair* usual = nullptr;
  for (const Pair& pair : allPairs()) {
    if (pair.ros != ros) continue;
    if (pair.ignition == type) return std::make_unique<Ros2TopicDecoder>(pair);
    if (usual == nullptr || (pair.isDefault && !usual->isDefault)) usual = &pair;
  }
  if (usual != nullptr && type.empty()) return std::make_unique<Ros2TopicDecoder>(*usual);
  if (usual != nullptr) return std::string(ros) + " can't be converted to " + std::string(type);
  const std::string hint = hintOfRosType(ros);
  return "'" + std::string(ros) + "' is no type of ROS that pongsim knows" + (hint.empty() ? "" : "; " + hint);
}

}  // namespace pongsim::ros2
