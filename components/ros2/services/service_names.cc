#include "ros2/services/service_names.hh"

#include <utility>

#include "pongsim/node.hh"
#include "ros2/node/names.hh"

namespace pongsim::ros2 {

ServiceNames::ServiceNames(std::string prefix, std::string_view world) : prefix_(std::move(prefix)), world_(world) {
  while (prefix_.ends_with('/')) prefix_.pop_back();
}

std::string ServiceNames::ofSimulator(std::string_view name) const { return prefix_ + "/" + std::string(name); }

std::string ServiceNames::ofWorld(std::string_view name) const { return rosNameFor(inSimulation(name)).substr(1); }

std::string ServiceNames::inSimulation(std::string_view name) const {
  return cleanTopic("/world/" + world_ + "/" + std::string(name));
}

}  // namespace pongsim::ros2
