#include "sim/shared_topics.hh"

#include <cstddef>
#include <map>
#include <string>

#include "pongsim/node.hh"

namespace pongsim::sim {

namespace {

constexpr std::size_t kMostTold = 3;

struct TopicUse {
  bool publishes = false;
  bool hears = false;
};

std::map<std::string, TopicUse> topicsOf(Simulation& simulation) {
  std::map<std::string, TopicUse> topics;
  for (const OwnTopic& topic : simulation.transport().node().ownTopics()) {
    TopicUse& users = topics[topic.name];
    users.publishes = users.publishes || topic.publishers > 0;
    users.hears = users.hears || topic.subscriptions > 0;
  }
  return topics;
}

/// @return "topic '/a'", "topics '/a', '/b', '/c' and 2 more"
std::string listOf(const std::vector<std::string>& topics) {
  std::string text = topics.size() == 1 ? "topic " : "topics ";
  for (std::size_t i = 0; i < topics.size() && i < kMostTold; ++i) text += (i > 0 ? ", '" : "'") + topics[i] + "'";
  if (topics.size() > kMostTold) text += " and " + std::to_string(topics.size() - kMostTold) + " more";
  return text;
}

std::string quotedWorld(Simulation& simulation) { return "world '" + std::string(simulation.world().name()) + "'"; }

/// @param place Position of the other world in its file.
void warnOfPair(Simulation& one, Simulation& other, const SourcePosition& place, Diagnostics& diagnostics) {
  const std::map<std::string, TopicUse> ofOne = topicsOf(one);
  std::vector<std::string> both, heardByOther, heardByOne;
  for (const auto& [name, users] : topicsOf(other)) {
    const auto found = ofOne.find(name);
    if (found == ofOne.end()) continue;
    if (found->second.publishes && users.publishes) both.push_back(name);
    if (found->second.publishes && users.hears) heardByOther.push_back(name);
    if (found->second.hears && users.publishes) heardByOne.push_back(name);
  }
  if (!both.empty()) {
    diagnostics.warning(place, quotedWorld(one) + " and " + quotedWorld(other) + " publish on the same " + listOf(both),
                        "subscribers get the messages of both");
  }
  const auto warn = [&](Simulation& from, Simulation& to, const std::vector<std::string>& topics) {
    if (topics.empty()) return;
    diagnostics.warning(place,
                        quotedWorld(to) + " subscribes to what " + quotedWorld(from) + " publishes: " + listOf(topics),
                        "its runs are then not reproducible, since each world runs at its own pace");
  };
  warn(one, other, heardByOther);
  warn(other, one, heardByOne);
}

}  // namespace

void warnOfSharedTopics(const std::vector<std::unique_ptr<Simulation>>& worlds,
                        const std::vector<SourcePosition>& positions, Diagnostics& diagnostics) {
  for (std::size_t i = 1; i < worlds.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) warnOfPair(*worlds[j], *worlds[i], positions[i], diagnostics);
  }
}

}  // namespace pongsim::sim
