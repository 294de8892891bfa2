#include "ign/place.hh"

#include <arpa/inet.h>

#include <ignition/transport/NodeOptions.hh>
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

std::string listOf(const std::vector<NetworkInterface>& all) {
  std::string list;
  for (const NetworkInterface& each : all) list += (list.empty() ? "" : ", ") + each.address + " (" + each.name + ")";
  return list.empty() ? "none" : list;
}

std::string chosenAddress() {
  const std::vector<NetworkInterface> known = networkInterfaces();
  if (const std::string said = environment("IGN_IP"); !said.empty()) {
    const bool isLoopback = said.starts_with("127.") && inet_addr(said.c_str()) != INADDR_NONE;
    if (isLoopback || std::ranges::find(known, said, &NetworkInterface::address) != known.end()) return said;
    throw std::invalid_argument("IGN_IP is '" + said + "', which is not an IPv4 address of this machine; it has " +
                                listOf(known));
  }
  const std::string said = environment("PONGSIM_NETWORK");
  if (said.empty()) return "127.0.0.1";
  const auto found = std::ranges::find_if(
      known, [&said](const NetworkInterface& each) { return each.name == said || each.address == said; });
  if (found != known.end()) return found->address;
  throw std::invalid_argument("this machine has no network interface '" + said + "'; it has " + listOf(known));
}

}  // namespace

Place placeOfEnvironment() {
  Place place;
  place.address = chosenAddress();
  place.isOpen = !place.address.starts_with("127.");
  const std::string said = environment("IGN_PARTITION");
  if (!ignition::transport::TopicUtils::IsValidPartition(said)) {
    throw std::invalid_argument("IGN_PARTITION is '" + said +
                                "', which is not a partition: it contains a space, '@', '~', ':=' or '//'");
  }
  place.partition = said.empty() ? ignition::transport::NodeOptions().Partition() : said;
  return place;
}

void settle(const Place& place, int queueLength) {
  setenv("IGN_IP", place.address.c_str(), 1);
  setenv("IGN_TRANSPORT_SNDHWM", std::to_string(queueLength).c_str(), 0);
}

}  // namespace pongsim::ign
