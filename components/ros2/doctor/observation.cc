#include "ros2/doctor/observation.hh"

#include <algorithm>

#include "ros2/node/names.hh"
#include "ros2/types/type_info.hh"

namespace pongsim::ros2 {

std::vector<Graph::Endpoint> Observation::endpointsOn(const std::string& topic, Graph::Role role) const {
  std::vector<Graph::Endpoint> found;
  for (const Graph::Endpoint& each : endpoints) {
    if (each.role == role && each.contract.topic == topicOnWire(topic)) found.push_back(each);
  }
  return found;
}

std::vector<std::string> Observation::topicsOf(const std::string& type) const {
  std::set<std::string> topics;
  for (const Graph::Endpoint& each : endpoints) {
    const auto topic = topicFromWire(each.contract.topic);
    if (each.role == Graph::Role::kWriter && topic && rosTypeName(each.contract.type) == type) topics.insert(*topic);
  }
  return {topics.begin(), topics.end()};
}

std::string Observation::nodesThat(const std::vector<NodeInfo::Interface> NodeInfo::*use,
                                   const std::string& topic) const {
  std::string names;
  for (const NodeInfo& node : nodes) {
    if (std::ranges::find(node.*use, topic, &NodeInfo::Interface::name) == (node.*use).end()) continue;
    names += (names.empty() ? "" : ", ") + node.fullName();
  }
  return names.empty() ? "an unnamed node" : names;
}

}  // namespace pongsim::ros2
