#include "log/record/topic_recorder.hh"

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace pongsim::log {

namespace {

bool isExpression(const std::string& topic) { return topic.find_first_of("*?[]().") != std::string::npos; }

}  // namespace

TopicRecorder::TopicRecorder(const Node& node, const std::vector<std::string>& topics, Writer& writer,
                             std::function<void(const std::exception&)> failed)
    : node_(node), writer_(writer), failed_(std::move(failed)) {
  for (const std::string& topic : topics) {
    if (!isExpression(topic)) {
      if (const auto wrong = topicNameError(topic)) throw std::invalid_argument("'" + topic + "' " + *wrong);
      subscribe(topic);
      continue;
    }
    try {
      expressions_.emplace_back(topic);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("'" + topic + "' is not a regular expression: " + error.what());
    }
  }
}

void TopicRecorder::update(Time now) {
  now_ = now;
  if (expressions_.empty() || version_ == node_.ownTopicsVersion()) return;
  for (const OwnTopic& topic : node_.ownTopics()) {
    const bool isWanted = std::ranges::any_of(
        expressions_, [&](const TopicExpression& expression) { return expression.matches(topic.name); });
    if (isWanted && !subscriptions_.contains(topic.name)) subscribe(topic.name);
  }
  // read again, because our own subscriptions have changed it
  version_ = node_.ownTopicsVersion();
}

void TopicRecorder::subscribe(const std::string& topic) {
  const std::string name = topic.starts_with('/') ? topic : "/" + topic;
  const auto received = [this, name](std::string_view type, std::span<const std::byte> bytes) {
    try {
      writer_.write({now_.count(), name, type, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}});
    } catch (const std::exception& why) {
      failed_(why);
    }
  };
  subscriptions_.emplace(topic, node_.subscribeAnyType(name, received));
}

}  // namespace pongsim::log
