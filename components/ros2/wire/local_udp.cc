#include "ros2/wire/local_udp.hh"

#include <arpa/inet.h>
#include <fastdds/rtps/attributes/PropertyPolicy.h>
#include <fastdds/rtps/common/PortParameters.h>
#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/TransportInterface.h>
#include <fastrtps/utils/IPLocator.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <fastdds/rtps/common/LocatorSelector.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "ros2/wire/burst_limit.hh"
#include "ros2/wire/discovery_guard.hh"
#include "ros2/wire/local_channel.hh"

namespace pongsim::ros2 {

namespace {

namespace dds_rtps = eprosima::fastdds::rtps;
namespace rtps = eprosima::fastrtps::rtps;
using rtps::Locator_t;

// The ports for discovery (RTPS 9.6.1.1.3).
constexpr std::uint32_t kGroup = 0xefff0001;
// Number of participants on this machine that are looked for at their unicast ports, in case they do not receive
// multicast.
constexpr std::uint32_t kParticipantsSought = 32;
constexpr std::size_t kLargestPacket = 65536;

std::uint32_t addressOf(const Locator_t& locator) {
  std::uint32_t address = 0;
  std::memcpy(&address, &locator.address[12], sizeof address);
  return address;
}

Locator_t locatorOf(std::uint32_t address, std::uint32_t port) {
  Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  locator.port = port;
  std::memcpy(&locator.address[12], &address, sizeof address);
  return locator;
}

bool isLoopback(std::uint32_t address) { return (ntohl(address) >> 24) == 127; }
bool isMulticast(const Locator_t& locator) { return (ntohl(addressOf(locator)) >> 28) == 0xe; }

/// @return Whether it is a port for announcements rather than for data (RTPS 9.6.1.1).
bool isDiscoveryPort(std::uint32_t port) { return port % 2 == 0; }

class LocalUdpTransport;

/// The output channel, opened once.
class LocalSender final : public rtps::SenderResource {
 public:
  explicit LocalSender(LocalUdpTransport& transport);
};

class LocalUdpTransport final : public dds_rtps::TransportInterface {
 public:
  LocalUdpTransport(const LocalUdp& descriptor, const Reach& reach, std::shared_ptr<std::atomic<bool>> isOpen)
      : TransportInterface(LOCATOR_KIND_UDPv4), descriptor_(descriptor), reach_(reach), isOpen_(std::move(isOpen)) {}

  bool init(const rtps::PropertyPolicy*) override;
  void shutdown() override;

  bool IsInputChannelOpen(const Locator_t& locator) const override;
  bool OpenInputChannel(const Locator_t& locator, dds_rtps::TransportReceiverInterface* receiver,
                        std::uint32_t) override;
  bool CloseInputChannel(const Locator_t& locator) override;
  bool OpenOutputChannel(dds_rtps::SendResourceList& senders, const Locator_t& locator) override;
  bool send(const rtps::octet* bytes, std::uint32_t size, rtps::LocatorsIterator& begin,
            const rtps::LocatorsIterator& end);

  bool IsLocatorSupported(const Locator_t& locator) const override { return locator.kind == LOCATOR_KIND_UDPv4; }
  bool is_locator_allowed(const Locator_t& locator) const override {
    return IsLocatorSupported(locator) && (isMulticast(locator) || reach_.mayReach(addressOf(locator)));
  }
  bool is_local_locator(const Locator_t& locator) const override {
    return IsLocatorSupported(locator) && isOwn(addressOf(locator));
  }
  bool transform_remote_locator(const Locator_t& remote, Locator_t& result) const override {
    if (!is_locator_allowed(remote)) return false;
    result = remote;
    return true;
  }
  bool DoInputLocatorsMatch(const Locator_t& a, const Locator_t& b) const override { return keyOf(a) == keyOf(b); }
  Locator_t RemoteToMainLocal(const Locator_t& remote) const override {
    return IsLocatorSupported(remote) ? locatorOf(INADDR_ANY, remote.port) : Locator_t();
  }
  rtps::LocatorList_t NormalizeLocator(const Locator_t& locator) override;
  void select_locators(rtps::LocatorSelector& selector) const override;

  dds_rtps::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }
  std::uint32_t max_recv_buffer_size() const override { return descriptor_.max_message_size(); }

  void AddDefaultOutputLocator(rtps::LocatorList_t& list) override { list.push_back(locatorOf(htonl(kGroup), 0)); }
  bool getDefaultMetatrafficMulticastLocators(rtps::LocatorList_t& list, std::uint32_t port) const override {
    list.push_back(locatorOf(htonl(kGroup), port));
    return true;
  }
  bool getDefaultMetatrafficUnicastLocators(rtps::LocatorList_t& list, std::uint32_t port) const override {
    // the library announces these addresses, and peers of ours do not send to 0.0.0.0
    for (const Locator_t& each : announced(port)) list.push_back(each);
    return true;
  }
  bool getDefaultUnicastLocators(rtps::LocatorList_t& list, std::uint32_t port) const override {
    return getDefaultMetatrafficUnicastLocators(list, port);
  }
  bool fillMetatrafficMulticastLocator(Locator_t& locator, std::uint32_t port) const override {
    if (locator.port == 0) locator.port = port;
    return true;
  }
  bool fillMetatrafficUnicastLocator(Locator_t& locator, std::uint32_t port) const override {
    return fillMetatrafficMulticastLocator(locator, port);
  }
  bool fillUnicastLocator(Locator_t& locator, std::uint32_t port) const override {
    return fillMetatrafficMulticastLocator(locator, port);
  }
  bool configureInitialPeerLocator(Locator_t& locator, const rtps::PortParameters& ports, std::uint32_t domain,
                                   rtps::LocatorList_t& list) const override;

 private:
  /// A channel receives everything at one port, multicast or from this machine.
  using Key = std::pair<bool, std::uint32_t>;
  static Key keyOf(const Locator_t& locator) { return {isMulticast(locator), locator.port}; }

  rtps::LocatorList_t announced(std::uint32_t port) const;
  bool isOwn(std::uint32_t address) const {
    return isLoopback(address) || std::ranges::count(reach_.addresses, address, &LocalAddress::address) > 0;
  }
  bool isOpenBy(const LocalAddress& each) const { return reach_.open && reach_.open->address == each.address; }
  std::vector<UdpSocket> socketsFor(const Locator_t& locator) const;
  static void sendBy(const UdpSocket& socket, const rtps::octet* bytes, std::uint32_t size, const Locator_t& to);

  LocalUdp descriptor_;
  Reach reach_;
  std::shared_ptr<std::atomic<bool>> isOpen_;
  UdpSocket sender_;
  /// One per interface.
  std::vector<UdpSocket> groupSenders_;
  BurstLimit bursts_;
  DiscoveryGuard guard_;
  mutable std::mutex mutex_;
  std::map<Key, std::unique_ptr<LocalChannel>> channels_;
};

LocalSender::LocalSender(LocalUdpTransport& transport) : SenderResource(LOCATOR_KIND_UDPv4) {
  send_lambda_ = [&transport](const rtps::octet* bytes, std::uint32_t size, rtps::LocatorsIterator* begin,
                              rtps::LocatorsIterator* end, const std::chrono::steady_clock::time_point&) {
    return transport.send(bytes, size, *begin, *end);
  };
}

bool LocalUdpTransport::init(const rtps::PropertyPolicy*) {
  sender_ = openSender();
  for (const LocalAddress& each : reach_.addresses) {
    // interfaces without multicast are skipped
    if (UdpSocket socket = openGroupSender(each.address, isOpenBy(each) ? 1 : 0)) {
      groupSenders_.push_back(std::move(socket));
    }
  }
  return static_cast<bool>(sender_);
}

void LocalUdpTransport::shutdown() {
  std::map<Key, std::unique_ptr<LocalChannel>> channels;
  {
    const std::lock_guard lock(mutex_);
    channels.swap(channels_);
  }
}

bool LocalUdpTransport::IsInputChannelOpen(const Locator_t& locator) const {
  const std::lock_guard lock(mutex_);
  return channels_.contains(keyOf(locator));
}

std::vector<UdpSocket> LocalUdpTransport::socketsFor(const Locator_t& locator) const {
  const auto port = static_cast<std::uint16_t>(locator.port);
  std::vector<UdpSocket> sockets;
  if (!isMulticast(locator)) {
    if (UdpSocket socket = openUnicast(port, reach_.senders())) sockets.push_back(std::move(socket));
    return sockets;
  }
  for (const LocalAddress& each : reach_.addresses) {
    shared::Senders senders = reach_.senders();
    senders.isAnybody = isOpenBy(each);
    if (UdpSocket socket = openMulticast(addressOf(locator), port, each.address, senders)) {
      sockets.push_back(std::move(socket));
    }
  }
  return sockets;
}

bool LocalUdpTransport::OpenInputChannel(const Locator_t& locator, dds_rtps::TransportReceiverInterface* receiver,
                                         std::uint32_t) {
  if (!IsLocatorSupported(locator)) return false;
  const std::lock_guard lock(mutex_);
  if (channels_.contains(keyOf(locator))) return true;
  std::vector<UdpSocket> sockets = socketsFor(locator);
  if (sockets.empty()) return false;
  for (const UdpSocket& socket : sockets) {
    if (reach_.isNobody && !shared::refuseSenders(socket.handle())) return false;
  }
  // there is one such port
  const bool endsLeases = !isMulticast(locator) && isDiscoveryPort(locator.port);
  channels_[keyOf(locator)] =
      std::make_unique<LocalChannel>(std::move(sockets), locator, *receiver, guard_, endsLeases, kLargestPacket);
  return true;
}

bool LocalUdpTransport::CloseInputChannel(const Locator_t& locator) {
  std::unique_ptr<LocalChannel> channel;
  {
    const std::lock_guard lock(mutex_);
    const auto found = channels_.find(keyOf(locator));
    if (found == channels_.end()) return false;
    channel = std::move(found->second);
    channels_.erase(found);
  }
  return true;
}

bool LocalUdpTransport::OpenOutputChannel(dds_rtps::SendResourceList& senders, const Locator_t& locator) {
  if (!IsLocatorSupported(locator)) return false;
  const bool isThere = std::ranges::any_of(
      senders, [](const auto& each) { return dynamic_cast<const LocalSender*>(each.get()) != nullptr; });
  if (!isThere) senders.push_back(std::make_unique<LocalSender>(*this));
  return true;
}

void LocalUdpTransport::sendBy(const UdpSocket& socket, const rtps::octet* bytes, std::uint32_t size,
                               const Locator_t& to) {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(static_cast<std::uint16_t>(to.port));
  name.sin_addr.s_addr = addressOf(to);
  const auto* const address = reinterpret_cast<const sockaddr*>(&name);
  // A full buffer empties within this machine. An ICMP error due to an earlier packet is reported once, instead of
  // sending this one.
  for (int i = 0; i < 3; ++i) {
    if (sendto(socket.handle(), bytes, size, 0, address, sizeof name) >= 0) return;
    if (errno == EAGAIN || errno == EWOULDBLOCK) {
      pollfd room{socket.handle(), POLLOUT, 0};
      poll(&room, 1, 10);
    }
  }
}

bool LocalUdpTransport::send(const rtps::octet* bytes, std::uint32_t size, rtps::LocatorsIterator& begin,
                             const rtps::LocatorsIterator& end) {
  if (!*isOpen_ || reach_.isNobody) return true;
  for (; begin != end; ++begin) {
    const Locator_t& to = *begin;
    if (!is_locator_allowed(to)) continue;
    if (!isMulticast(to)) {
      if (isOwn(addressOf(to))) bursts_.awaitRoom(addressOf(to), static_cast<std::uint16_t>(to.port), size);
      sendBy(sender_, bytes, size, to);
      continue;
    }
    for (const UdpSocket& socket : groupSenders_) sendBy(socket, bytes, size, to);
  }
  return true;
}

/// Peers are told the addresses of the interfaces, which those with default settings can reach. Not 127.0.0.1 as well:
/// they would send everything twice.
rtps::LocatorList_t LocalUdpTransport::announced(std::uint32_t port) const {
  rtps::LocatorList_t list;
  for (const LocalAddress& each : reach_.addresses) {
    if (each.isLoopback == reach_.announcesLoopback) list.push_back(locatorOf(each.address, port));
  }
  if (list.empty()) list.push_back(locatorOf(htonl(INADDR_LOOPBACK), port));
  return list;
}

rtps::LocatorList_t LocalUdpTransport::NormalizeLocator(const Locator_t& locator) {
  if (addressOf(locator) == INADDR_ANY) return announced(locator.port);
  rtps::LocatorList_t list;
  list.push_back(locator);
  return list;
}

/// One of the addresses of a peer on this machine is enough.
void LocalUdpTransport::select_locators(rtps::LocatorSelector& selector) const {
  auto& entries = selector.transport_starts();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    rtps::LocatorSelectorEntry& entry = *entries[i];
    if (!entry.transport_should_process) continue;
    bool isSelected = false;
    const auto take = [&](const auto& locators, auto& state, std::size_t j) {
      if (!is_locator_allowed(locators[j]) || selector.is_selected(locators[j])) return false;
      state.push_back(j);
      return isSelected = true;
    };
    bool isReached = false;
    for (std::size_t j = 0; j < entry.unicast.size() && !isReached; ++j) {
      // or for another endpoint of the peer
      isReached = is_local_locator(entry.unicast[j]);
      take(entry.unicast, entry.state.unicast, j);
    }
    for (std::size_t j = 0; !isReached && !isSelected && j < entry.multicast.size(); ++j) {
      take(entry.multicast, entry.state.multicast, j);
    }
    if (isSelected) selector.select(i);
  }
}

bool LocalUdpTransport::configureInitialPeerLocator(Locator_t& locator, const rtps::PortParameters& ports,
                                                    std::uint32_t domain, rtps::LocatorList_t& list) const {
  if (locator.port != 0) {
    list.push_back(locator);
  } else if (isMulticast(locator)) {
    list.push_back(locatorOf(addressOf(locator), ports.getMulticastPort(domain)));
  } else {
    for (std::uint32_t i = 0; i < kParticipantsSought; ++i) {
      const std::uint32_t port = ports.getUnicastPort(domain, i);
      if (port <= 65535) list.push_back(locatorOf(addressOf(locator), port));
    }
  }
  return true;
}

}  // namespace

shared::Senders Reach::senders() const {
  shared::Senders senders;
  if (open) senders.openAddress = open->address;
  for (const LocalAddress& each : addresses) {
    if (!each.isLoopback) senders.addresses.push_back(each.address);
  }
  return senders;
}

bool Reach::mayReach(std::uint32_t address) const {
  return open || isLoopback(address) || std::ranges::count(addresses, address, &LocalAddress::address) > 0;
}

Reach reachOf(bool isLoopbackOnly, const std::optional<std::string>& interface) {
  Reach reach;
  reach.addresses = localAddresses();
  if (interface && !isLoopbackOnly) {
    const auto found = std::ranges::find_if(reach.addresses, [&](const LocalAddress& each) {
      return each.interface == *interface || textOf(each.address) == *interface;
    });
    if (found == reach.addresses.end()) {
      throw std::invalid_argument("this machine has no network interface '" + *interface + "'");
    }
    if (!found->isLoopback) reach.open = *found;
  }
  reach.announcesLoopback = isLoopbackOnly;
  if (reach.addresses.empty()) reach.addresses.push_back({"lo", htonl(INADDR_LOOPBACK), true});
  return reach;
}

LocalUdp::LocalUdp(const Reach& reach, std::shared_ptr<std::atomic<bool>> isOpen)
    : TransportDescriptorInterface(dds_rtps::s_maximumMessageSize, kParticipantsSought),
      reach_(reach),
      isOpen_(std::move(isOpen)) {}

dds_rtps::TransportInterface* LocalUdp::create_transport() const {
  return new LocalUdpTransport(*this, reach_, isOpen_);
}

}  // namespace pongsim::ros2
