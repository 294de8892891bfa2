#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/fortress/gz_types.hh"
#include "cli/look_around.hh"
#include "cli/topic/topic_command.hh"
#include "cli/topic/topic_name.hh"
#include "pongsim/node.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

/// How long `-i` watches the traffic.
constexpr std::chrono::milliseconds kWatchTime{500};

/// @return "1000 Hz", "0.5 Hz".
std::string rateText(double rate) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f Hz", rate < 10 ? 1 : 0, rate);
  return text;
}

/// @param passed What happened to the messages: "sent".
std::string table(const char* title, const char* passed, const std::vector<TopicInfo::Endpoint>& endpoints) {
  std::string text = std::string(title) + " [Process, Message Type, Rate, Messages]:\n";
  for (const TopicInfo::Endpoint& endpoint : endpoints) {
    text += "  " + (endpoint.pid > 0 ? std::to_string(endpoint.pid) : "?") + ", " + endpoint.type + ", ";
    if (const auto& traffic = endpoint.traffic) {
      text += rateText(traffic->rate) + ", " + std::to_string(traffic->messages) + " " + passed + ", " +
              std::to_string(traffic->dropped) + " dropped\n";
    } else {
      text += "does not answer\n";
    }
  }
  return text;
}

nlohmann::ordered_json jsonOf(const std::vector<TopicInfo::Endpoint>& endpoints) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const TopicInfo::Endpoint& endpoint : endpoints) {
    nlohmann::ordered_json& added = list.emplace_back();
    added = {{"pid", endpoint.pid}, {"type", endpoint.type}};
    if (!endpoint.traffic) continue;
    added["hz"] = endpoint.traffic->rate;
    added["messages"] = endpoint.traffic->messages;
    added["dropped"] = endpoint.traffic->dropped;
  }
  return list;
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

/// @return An array with an object for each topic, including those that have only subscribers.
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

int listTopics(bool isVerbose, bool asJson, bool asGz) {
  Transport transport;
  const std::vector<TopicInfo> topics = topicsAround(transport);
  if (asJson) return print(withTypeNames(jsonOf(topics), asGz)) ? kDone : kFailed;
  std::string text;
  for (const TopicInfo& topic : topics) {
    if (isVerbose) {
      text += line(topic);
    } else if (!topic.publishers.empty()) {
      text += topic.name + "\n";
    }
  }
  if (text.empty()) say("no topics with publishers");
  return print(withTypeNames(text, asGz)) ? kDone : kFailed;
}

int showTopic(const std::string& name, bool asJson, bool asGz) {
  Transport transport;
  const std::vector<TopicInfo> topics = topicsAround(transport);
  const auto found =
      std::find_if(topics.begin(), topics.end(), [&name](const TopicInfo& each) { return each.name == name; });
  if (found == topics.end()) return fail("no publishers on " + name, nearestTopic(name, topics));

  // publishers send nothing while nobody listens, so there would be no rate to measure
  Subscription listening;
  if (found->subscribers.empty()) {
    listening = transport.node().subscribeBytes(name, found->publishers.front().type, [](auto) {}, {.queueLength = 1});
  }
  const TopicInfo topic = transport.watchTopic(name, kWatchTime);
  if (asJson) {
    const nlohmann::ordered_json json = {
        {"name", topic.name}, {"publishers", jsonOf(topic.publishers)}, {"subscribers", jsonOf(topic.subscribers)}};
    return print(withTypeNames(json.dump() + "\n", asGz)) ? kDone : kFailed;
  }
  std::string text = topic.publishers.empty() ? "No publishers on topic [" + name + "]\n"
                                              : table("Publishers", "sent", topic.publishers);
  if (!topic.subscribers.empty()) text += table("Subscribers", "received", topic.subscribers);
  return print(withTypeNames(text, asGz)) ? kDone : kFailed;
}

}  // namespace pongsim::cli
