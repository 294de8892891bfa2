#include "ign/place.hh"

#include <arpa/inet.h>

#include <ignition/transport/NetUtils.hh>
#include <ignition/transport/TopicUtils.hh>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "pongsim/program/network_interface.hh"

namespace pongsim::ign {

namespace {

std::string environment(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? "" : text;
}

/// What the library reads, besides address and partition.
constexpr GazeboVariable kRead[] = {
    gazebo::kRelay,    gazebo::kMulticastIp, gazebo::kMessagePort, gazebo::kServicePort,  gazebo::kUsername,
    gazebo::kPassword, gazebo::kStatistics,  gazebo::kSendQueue,   gazebo::kReceiveQueue, gazebo::kVerbose};

/// Gives Fortress's variable the value of the later one.
void rename(const GazeboVariable& variable) {
  if (const char* const value = std::getenv(variable.later)) {
    setenv(variable.fortress, value, 1);
  } else {
    unsetenv(variable.fortress);
  }
}

/// @return HOST:USER.
std::string defaultPartition() { return ignition::transport::hostname() + ":" + ignition::transport::username(); }

std::string listOf(const std::vector<NetworkInterface>& all) {
  std::string list;
  for (const NetworkInterface& each : all) list += (list.empty() ? "" : ", ") + each.address + " (" + each.name + ")";
  return list.empty() ? "none" : list;
}

std::string chosenAddress(Generation generation) {
  const std::vector<NetworkInterface> known = networkInterfaces();
  const char* const variable = nameFor(gazebo::kIp, generation);
  if (const std::string said = environment(variable); !said.empty()) {
    const bool isLoopback = said.starts_with("127.") && inet_addr(said.c_str()) != INADDR_NONE;
    if (isLoopback || std::ranges::find(known, said, &NetworkInterface::address) != known.end()) return said;
    throw std::invalid_argument(std::string(variable) + " is '" + said +
                                "', which is not an IPv4 address of this machine; it has " + listOf(known));
  }
  const std::string said = environment("PONGSIM_NETWORK");
  if (said.empty()) return "127.0.0.1";
  const auto found = std::ranges::find_if(
      known, [&said](const NetworkInterface& each) { return each.name == said || each.address == said; });
  if (found != known.end()) return found->address;
  throw std::invalid_argument("this machine has no network interface '" + said + "'; it has " + listOf(known));
}

}  // namespace

Place placeOfEnvironment(Generation generation) {
  Place place;
  place.address = chosenAddress(generation);
  place.isOpen = !place.address.starts_with("127.");
  const char* const variable = nameFor(gazebo::kPartition, generation);
  const std::string said = environment(variable);
  if (!ignition::transport::TopicUtils::IsValidPartition(said)) {
    throw std::invalid_argument(std::string(variable) + " is '" + said +
                                "', which is not a partition: it contains a space, '@', '~', ':=' or '//'");
  }
  // as in the library, an empty one is one, too
  place.partition = std::getenv(variable) == nullptr ? defaultPartition() : said;
  return place;
}

void settle(const Place& place, int queueLength, Generation generation) {
  if (generation == Generation::kGz) {
    for (const GazeboVariable& variable : kRead) rename(variable);
    setenv(gazebo::kPartition.fortress, place.partition.c_str(), 1);
  }
  setenv(gazebo::kIp.fortress, place.address.c_str(), 1);
  setenv(gazebo::kSendQueue.fortress, std::to_string(queueLength).c_str(), 0);
}

}  // namespace pongsim::ign
