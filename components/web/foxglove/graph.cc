#include "web/foxglove/graph.hh"

#include <set>
#include <utility>

#include "web/foxglove/status.hh"

namespace pongsim::web::foxglove {

namespace {

using nlohmann::json;

template <class Ends>
json changed(const Ends& before, const Ends& now, const char* ids) {
  json list = json::array();
  for (const auto& [name, ends] : now) {
    const auto found = before.find(name);
    if (found == before.end() || found->second != ends) list.push_back({{"name", name}, {ids, ends}});
  }
  // endpoints removed from a topic that still exists
  for (const auto& [name, ends] : before) {
    if (!now.contains(name)) list.push_back({{"name", name}, {ids, json::array()}});
  }
  return list;
}

void addTo(std::vector<std::string>& ends, const std::string& world, int count) {
  for (int i = 1; i <= count; ++i) ends.push_back(world + "/" + std::to_string(i));
}

}  // namespace

Graph::Graph(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds)
    : client_(std::move(client)), worlds_(std::move(worlds)) {}

void Graph::setWanted(bool wanted) {
  isWanted_ = wanted;
  hasSent_ = false;
  publishers_.clear();
  subscribers_.clear();
  providers_.clear();
  follow();
}

void Graph::follow() {
  if (!isWanted_) return;
  Ends publishers;
  Ends subscribers;
  Ends providers;
  for (const auto& world : worlds_->all()) {
    const auto lists = world->lists();
    for (const Topic& topic : lists->topics) {
      if (topic.publishers > 0) addTo(publishers[topic.name], world->world(), topic.publishers);
      if (topic.subscribers > 0) addTo(subscribers[topic.name], world->world(), topic.subscribers);
    }
    for (const OwnService& service : lists->services) addTo(providers[service.name], world->world(), 1);
  }
  std::set<std::string> gone;
  for (const Ends* before : {&publishers_, &subscribers_}) {
    for (const auto& [name, ends] : *before) {
      if (!publishers.contains(name) && !subscribers.contains(name)) gone.insert(name);
    }
  }
  std::vector<std::string> goneServices;
  for (const auto& [name, ends] : providers_) {
    if (!providers.contains(name)) goneServices.push_back(name);
  }
  const bool isSame = publishers == publishers_ && subscribers == subscribers_ && providers == providers_;
  if (!isSame || !std::exchange(hasSent_, true)) {
    client_->sendText(textOf({{"op", "connectionGraphUpdate"},
                              {"publishedTopics", changed(publishers_, publishers, "publisherIds")},
                              {"subscribedTopics", changed(subscribers_, subscribers, "subscriberIds")},
                              {"advertisedServices", changed(providers_, providers, "providerIds")},
                              {"removedTopics", gone},
                              {"removedServices", goneServices}}));
  }
  publishers_ = std::move(publishers);
  subscribers_ = std::move(subscribers);
  providers_ = std::move(providers);
}

}  // namespace pongsim::web::foxglove
