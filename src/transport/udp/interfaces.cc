#include "transport/udp/interfaces.hh"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace pongsim {

std::vector<NetworkInterface> networkInterfaces() {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return {};
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owned(first, freeifaddrs);
  std::vector<NetworkInterface> all;
  for (const ifaddrs* each = first; each != nullptr; each = each->ifa_next) {
    if (each->ifa_addr == nullptr || each->ifa_addr->sa_family != AF_INET || (each->ifa_flags & IFF_UP) == 0) continue;
    sockaddr_in address{};
    std::memcpy(&address, each->ifa_addr, sizeof address);
    char text[INET_ADDRSTRLEN] = {};
    if (inet_ntop(AF_INET, &address.sin_addr, text, sizeof text) != nullptr) all.push_back({each->ifa_name, text});
  }
  return all;
}

namespace transport {

std::optional<NetworkInterface> chosenInterface(const std::optional<std::string>& wanted) {
  std::string name = wanted.value_or("");
  if (const char* said = std::getenv("PONGSIM_NETWORK"); name.empty() && said != nullptr) name = said;
  if (name.empty()) return std::nullopt;

  const std::vector<NetworkInterface> known = networkInterfaces();
  const auto found = std::ranges::find_if(
      known, [&name](const NetworkInterface& each) { return each.name == name || each.address == name; });
  if (found == known.end()) {
    std::string list;
    for (const NetworkInterface& each : known)
      list += (list.empty() ? "" : ", ") + each.name + " (" + each.address + ")";
    throw std::invalid_argument("this machine has no network interface '" + name + "'; it has " +
                                (list.empty() ? "none" : list));
  }
  return found->address.starts_with("127.") ? std::nullopt : std::optional(*found);
}

}  // namespace transport

}  // namespace pongsim
