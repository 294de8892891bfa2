#include "ign/subscriber_list.hh"

#include <arpa/inet.h>
#include <ignition/msgs/discovery.pb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "ign/library.hh"
#include "ign/names.hh"

namespace pongsim::ign {

namespace {

using ignition::transport::AdvertiseMessageOptions;
using ignition::transport::MessagePublisher;

/// @return The version of discovery's protocol; with numbered messages another one.
std::uint32_t protocolVersion() {
  const char* const statistics = std::getenv(gazebo::kStatistics.fortress);
  return statistics != nullptr && std::strcmp(statistics, "1") == 0 ? 110 : 10;
}

/// @return A packet of discovery, which begins with its length.
std::string packetOf(const ignition::msgs::Discovery& message) {
  const std::string body = message.SerializeAsString();
  const auto length = static_cast<std::uint16_t>(body.size());
  std::string packet(sizeof length, '\0');
  std::memcpy(packet.data(), &length, sizeof length);
  return packet + body;
}

}  // namespace

SubscriberList::SubscriberList(const std::string& address)
    : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)),
      address_(address),
      node_(ignition::transport::Uuid().ToString()) {
  const in_addr from{inet_addr(address.c_str())};
  setsockopt(socket_, IPPROTO_IP, IP_MULTICAST_IF, &from, sizeof from);
}

SubscriberList::~SubscriberList() {
  if (socket_ >= 0) ::close(socket_);
}

void SubscriberList::send(const std::vector<std::pair<std::string, std::string>>& subscriptions) const {
  const auto& shared = library();
  sockaddr_in group{};
  group.sin_family = AF_INET;
  group.sin_port = htons(static_cast<std::uint16_t>(shared.msgDiscPort));
  group.sin_addr.s_addr = inet_addr(shared.discoveryIP.c_str());
  for (const auto& [topic, type] : subscriptions) {
    const std::optional<std::string> name = wireName(topic);
    if (!name) continue;
    ignition::msgs::Discovery message;
    MessagePublisher(*name, shared.myAddress, "", shared.pUuid, node_, type, AdvertiseMessageOptions())
        .FillDiscovery(message);
    message.set_version(protocolVersion());
    message.set_process_uuid(shared.pUuid);
    message.set_type(static_cast<ignition::msgs::Discovery::Type>(kReply));
    const std::string packet = packetOf(message);
    // like all of discovery, an answer may be lost
    static_cast<void>(
        sendto(socket_, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&group), sizeof group));
  }
}

}  // namespace pongsim::ign
