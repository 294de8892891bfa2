#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/console.hh"
#include "cli/topic_command.hh"
#include "cli/topic_name.hh"
#include "pongsim/node.hh"

namespace pongsim::cli {

namespace {

std::string table(const char* title, const std::vector<TopicInfo::Endpoint>& endpoints) {
  std::string text = std::string(title) + " [Process, Message Type]:\n";
  for (const TopicInfo::Endpoint& endpoint : endpoints) {
    text += "  " + (endpoint.pid > 0 ? std::to_string(endpoint.pid) : "?") + ", " + endpoint.type + "\n";
  }
  return text;
}

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// @return All types that the topic is used with.
std::set<std::string> typesOf(const TopicInfo& topic) {
  std::set<std::string> types;
  for (const auto* side : {&topic.publishers, &topic.subscribers}) {
    for (const TopicInfo::Endpoint& endpoint : *side) types.insert(endpoint.type);
  }
  return types;
}

/// @return An array with an object for each topic, those that are only subscribed to among them.
std::string jsonOf(const std::vector<TopicInfo>& topics) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const TopicInfo& topic : topics) {
    list.push_back({{"name", topic.name},
                    {"types", typesOf(topic)},
                    {"publishers", topic.publishers.size()},
                    {"subscribers", topic.subscribers.size()}});
  }
  return list.dump() + "\n";
}

/// @return "/clock [ignition.msgs.Clock] 1 publisher, 0 subscribers", with all types that the topic is used with.
std::string line(const TopicInfo& topic) {
  const std::set<std::string> types = typesOf(topic);
  std::string text = topic.name + " [";
  for (const std::string& type : types) text += (type == *types.begin() ? "" : ", ") + type;
  return text + "] " + counted(topic.publishers.size(), "publisher") + ", " +
         counted(topic.subscribers.size(), "subscriber") + "\n";
}

}  // namespace

int listTopics(bool isVerbose, bool asJson) {
  Transport transport;
  const std::vector<TopicInfo> topics = transport.discover(kDiscoveryTime);
  if (asJson) return print(jsonOf(topics)) ? kDone : kFailed;
  std::string text;
  for (const TopicInfo& topic : topics) {
    if (isVerbose) {
      text += line(topic);
    } else if (!topic.publishers.empty()) {
      text += topic.name + "\n";
    }
  }
  if (text.empty()) say("no topics: nobody publishes");
  return print(text) ? kDone : kFailed;
}

int showTopic(const std::string& name) {
  Transport transport;
  const std::vector<TopicInfo> topics = transport.discover(kDiscoveryTime);
  const auto topic =
      std::find_if(topics.begin(), topics.end(), [&name](const TopicInfo& each) { return each.name == name; });
  if (topic == topics.end()) return fail("no publishers on " + name, nearestTopic(name, topics));

  std::string text =
      topic->publishers.empty() ? "No publishers on topic [" + name + "]\n" : table("Publishers", topic->publishers);
  if (!topic->subscribers.empty()) text += table("Subscribers", topic->subscribers);
  return print(text) ? kDone : kFailed;
}

}  // namespace pongsim::cli
