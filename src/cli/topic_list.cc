#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "cli/console.hh"
#include "cli/topic_command.hh"
#include "cli/topic_name.hh"
#include "pongsim/node.hh"

namespace pongsim::cli {

namespace {

/// How long `-i` looks at what passes.
constexpr std::chrono::milliseconds kWatchTime{500};

/// @return "1000 Hz", "0.5 Hz".
std::string rateText(double rate) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f Hz", rate < 10 ? 1 : 0, rate);
  return text;
}

/// @param passed What became of the messages: "sent".
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

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// @return "/clock [ignition.msgs.Clock] 1 publisher, 0 subscribers", with all types that the topic is used with.
std::string line(const TopicInfo& topic) {
  std::set<std::string> types;
  for (const auto* side : {&topic.publishers, &topic.subscribers}) {
    for (const TopicInfo::Endpoint& endpoint : *side) types.insert(endpoint.type);
  }
  std::string text = topic.name + " [";
  for (const std::string& type : types) text += (type == *types.begin() ? "" : ", ") + type;
  return text + "] " + counted(topic.publishers.size(), "publisher") + ", " +
         counted(topic.subscribers.size(), "subscriber") + "\n";
}

}  // namespace

int listTopics(bool isVerbose) {
  Transport transport;
  std::string text;
  for (const TopicInfo& topic : transport.discover(kDiscoveryTime)) {
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
  const auto found =
      std::find_if(topics.begin(), topics.end(), [&name](const TopicInfo& each) { return each.name == name; });
  if (found == topics.end()) return fail("no publishers on " + name, nearestTopic(name, topics));

  // nothing is sent, at any rate, while nobody listens
  Subscription listening;
  if (found->subscribers.empty()) {
    listening = transport.node().subscribeBytes(name, found->publishers.front().type, [](auto) {}, {.queueLength = 1});
  }
  const TopicInfo topic = transport.watchTopic(name, kWatchTime);
  std::string text = topic.publishers.empty() ? "No publishers on topic [" + name + "]\n"
                                              : table("Publishers", "sent", topic.publishers);
  if (!topic.subscribers.empty()) text += table("Subscribers", "received", topic.subscribers);
  return print(text) ? kDone : kFailed;
}

}  // namespace pongsim::cli
