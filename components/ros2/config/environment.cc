#include "ros2/config/environment.hh"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace pongsim::ros2 {

namespace {

std::string_view environment(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? std::string_view() : std::string_view(text);
}

int domainOfEnvironment() {
  const std::string_view text = environment("ROS_DOMAIN_ID");
  if (text.empty()) return 0;
  int domain = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), domain);
  if (error != std::errc() || end != text.data() + text.size() || domain < 0 || domain > kLastDomain) {
    throw std::invalid_argument("ROS_DOMAIN_ID is '" + std::string(text) + "', not an integer between 0 and 232");
  }
  return domain;
}

/// @return The addresses of ROS_STATIC_PEERS, which semicolons separate.
std::vector<std::string> staticPeers() {
  std::vector<std::string> peers;
  std::string_view text = environment("ROS_STATIC_PEERS");
  while (!text.empty()) {
    const std::string_view peer = text.substr(0, text.find(';'));
    if (!peer.empty()) peers.emplace_back(peer);
    text.remove_prefix(std::min(peer.size() + 1, text.size()));
  }
  return peers;
}

/// @return What nodes use instead of the UDP that they share with us, or nothing.
std::string otherTransport() {
  const std::string_view middleware = environment("RMW_IMPLEMENTATION");
  if (!middleware.empty() && middleware.find("fastrtps") == std::string_view::npos &&
      middleware.find("cyclonedds") == std::string_view::npos && middleware.find("connext") == std::string_view::npos) {
    return "RMW_IMPLEMENTATION is '" + std::string(middleware) + "', but the simulation speaks DDS";
  }
  const std::string_view transports = environment("FASTDDS_BUILTIN_TRANSPORTS");
  if (!transports.empty() && transports != "DEFAULT" && transports != "UDPv4") {
    return "FASTDDS_BUILTIN_TRANSPORTS is '" + std::string(transports) +
           "', but the simulation speaks UDP over IPv4: DEFAULT and UDPv4 have it";
  }
  return {};
}

}  // namespace

ParticipantOptions participantOptionsOfEnvironment() {
  ParticipantOptions options;
  options.domain = domainOfEnvironment();
  options.isLoopbackOnly = environment("ROS_LOCALHOST_ONLY") == "1";
  if (const std::string_view text = environment("PONGSIM_NETWORK"); !text.empty()) options.interface = text;
  // as in rcl, the older variable comes first
  if (options.isLoopbackOnly) return options;
  const std::string_view range = environment("ROS_AUTOMATIC_DISCOVERY_RANGE");
  if (range == "LOCALHOST") {
    options.isLoopbackOnly = true;
  } else if (range == "OFF") {
    options.isAlone = true;
  } else if (!range.empty() && range != "SUBNET" && range != "SYSTEM_DEFAULT") {
    throw std::invalid_argument("ROS_AUTOMATIC_DISCOVERY_RANGE is '" + std::string(range) +
                                "', not SUBNET, LOCALHOST, OFF or SYSTEM_DEFAULT");
  }
  if (!options.isAlone) options.staticPeers = staticPeers();
  return options;
}

std::vector<std::string> unmetVariables(const ParticipantOptions& options) {
  std::vector<std::string> sentences;
  const bool isOpen = options.interface && !options.isLoopbackOnly;
  if (options.isAlone) {
    sentences.emplace_back("ROS_AUTOMATIC_DISCOVERY_RANGE is OFF: no node is met");
    return sentences;
  }
  if (options.isLoopbackOnly && options.interface) {
    sentences.emplace_back(
        "nodes are met on this machine alone: ROS_LOCALHOST_ONLY or ROS_AUTOMATIC_DISCOVERY_RANGE says so");
  }
  if (environment("ROS_AUTOMATIC_DISCOVERY_RANGE") == "SUBNET" && !isOpen) {
    sentences.emplace_back(
        "ROS_AUTOMATIC_DISCOVERY_RANGE is SUBNET, but nodes on other machines are met only with --network");
  }
  if (!options.staticPeers.empty() && !isOpen) {
    sentences.emplace_back("ROS_STATIC_PEERS is set, but nodes on other machines are met only with --network");
  }
  if (!environment("ROS_DISCOVERY_SERVER").empty()) {
    sentences.emplace_back(
        "ROS_DISCOVERY_SERVER is set, but the simulation uses no discovery server: nodes that do are not met");
  }
  if (const std::string why = otherTransport(); !why.empty()) {
    sentences.push_back(why + ": nodes with this setting are not met");
  }
  for (const char* name : {"FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE",
                           "FASTDDS_ENVIRONMENT_FILE", "CYCLONEDDS_URI"}) {
    if (environment(name).empty()) continue;
    sentences.push_back(
        std::string(name) +
        " is set, but the simulation does not read it: nodes are met if its settings leave them UDP over "
        "IPv4 and the usual discovery");
  }
  return sentences;
}

}  // namespace pongsim::ros2
