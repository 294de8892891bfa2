#include "transport/udp/gated_udp.hh"

#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastrtps/utils/IPLocator.h>
#include <netinet/in.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "transport/udp/domain.hh"
#include "transport/udp/udp_sockets.hh"

namespace pongsim::transport {

namespace {

namespace dds_rtps = eprosima::fastdds::rtps;
namespace rtps = eprosima::fastrtps::rtps;

constexpr const char* kLocalAddress = "127.0.0.1";

// Capacity of the list of open ports, above the number that a participant opens.
constexpr std::size_t kMostPorts = 64;

/// @return Whether the transport of that side sends to this locator.
bool isOn(GatedUdp::Side side, const rtps::Locator_t& locator) {
  constexpr rtps::octet kLoopbackNet = 127;
  return (rtps::IPLocator::getIPv4(locator)[0] == kLoopbackNet) == (side == GatedUdp::Side::kLoopback);
}

std::uint32_t addressOf(const rtps::Locator_t& locator) {
  const rtps::octet* bytes = rtps::IPLocator::getIPv4(locator);
  std::uint32_t address = 0;
  for (int i = 0; i < 4; ++i) address = address << 8 | bytes[i];
  return address;
}

/// The locators of a message to which the transport of one side sends it, skipping those that `Announcements` or
/// `Heartbeats` exclude.
class OwnSide : public rtps::LocatorsIterator {
 public:
  OwnSide(GatedUdp::Side side, int domain, std::span<const rtps::octet> message, UdpGate& gate,
          rtps::LocatorsIterator& all, const rtps::LocatorsIterator& end)
      : side_(side), domain_(domain), message_(message), gate_(gate), all_(all), end_(end) {
    skipOthers();
  }

  rtps::LocatorsIterator& operator++() override {
    ++all_;
    skipOthers();
    return *this;
  }
  bool operator==(const rtps::LocatorsIterator& other) const override { return all_ == other; }
  bool operator!=(const rtps::LocatorsIterator& other) const override { return all_ != other; }
  const rtps::Locator_t& operator*() const override { return *all_; }

 private:
  void skipOthers() {
    while (all_ != end_ && !isWanted(*all_)) ++all_;
  }
  bool isWanted(const rtps::Locator_t& locator) {
    if (!isOn(side_, locator)) return false;
    if (!discoveryPorts(domain_).contains(locator.port)) return true;
    if (!isRead_) read();
    if (!read_ || side_ == GatedUdp::Side::kNetwork) return true;
    const auto now = std::chrono::steady_clock::now();
    if (read_->isAnnouncement())
      return gate_.announcements.goesTo(locator.port, read_->discovery.front().sequence, now);
    return !read_->isHeartbeatToAll() || gate_.heartbeats.goTo(locator.port, read_->heartbeats, now);
  }

  void read() {
    isRead_ = true;
    read_ = shared::readRtpsMessage(message_);
    if (read_) gate_.filter.recordSent(*read_);
  }

  GatedUdp::Side side_;
  int domain_;
  std::span<const rtps::octet> message_;
  UdpGate& gate_;
  rtps::LocatorsIterator& all_;
  const rtps::LocatorsIterator& end_;
  bool isRead_ = false;
  std::optional<RtpsMessage> read_;
};

class GatedUdpTransport : public dds_rtps::ChainingTransport {
 public:
  GatedUdpTransport(const dds_rtps::ChainingTransportDescriptor& descriptor, GatedUdp::Side side, int domain,
                    std::shared_ptr<UdpGate> gate)
      : ChainingTransport(descriptor), descriptor_(descriptor), side_(side), domain_(domain), gate_(std::move(gate)) {}

  dds_rtps::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }

  bool OpenInputChannel(const rtps::Locator_t& locator, dds_rtps::TransportReceiverInterface* receiver,
                        std::uint32_t size) override {
    const bool isMulticast = rtps::IPLocator::isMulticast(locator);
    if (side_ == GatedUdp::Side::kLoopback) {
      // Fast DDS passes the locator with the interface's address; this transport listens on 127.0.0.1 instead
      rtps::Locator_t local = locator;
      rtps::IPLocator::setIPv4(local, kLocalAddress);
      if (isMulticast || !ChainingTransport::OpenInputChannel(local, receiver, size)) return false;
      const std::lock_guard lock(gate_->mutex);
      // no reallocation, because Fast DDS does not survive an exception here while another port is open
      if (gate_->ports.size() < gate_->ports.capacity()) gate_->ports.push_back(locator.port);
      if (discoveryPorts(domain_).contains(locator.port)) {
        gate_->receiver = receiver;
        gate_->discoveryPort = local;
      }
      return true;
    }
    {
      const std::lock_guard lock(gate_->mutex);
      if (!isMulticast && std::ranges::count(gate_->ports, locator.port) == 0) return false;
    }
    return ChainingTransport::OpenInputChannel(locator, receiver, size);
  }

  /// Maps all addresses of this machine to 127.0.0.1: a participant that listens at another one listens there, too.
  bool transform_remote_locator(const rtps::Locator_t& remote, rtps::Locator_t& result) const override {
    if (side_ == GatedUdp::Side::kNetwork) return ChainingTransport::transform_remote_locator(remote, result);
    if (!IsLocatorSupported(remote) || !is_local_locator(remote)) return false;
    result = remote;
    rtps::IPLocator::setIPv4(result, kLocalAddress);
    return true;
  }

  bool send(rtps::SenderResource* udp, const rtps::octet* bytes, std::uint32_t size, rtps::LocatorsIterator* begin,
            rtps::LocatorsIterator* end, const std::chrono::steady_clock::time_point& deadline) override {
    if (!gate_->isOpen) return true;
    OwnSide own(side_, domain_, std::span(bytes, size), *gate_, *begin, *end);
    return own == *end || udp->send(bytes, size, &own, end, deadline);
  }

  void receive(dds_rtps::TransportReceiverInterface* receiver, const rtps::octet* bytes, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    if (!gate_->isOpen) return;
    const RtpsAddress from{addressOf(remote), remote.port};
    // the buffer belongs to Fast DDS, which itself modifies it
    const std::span message(const_cast<rtps::octet*>(bytes), size);
    const auto [isAccepted, before] = gate_->filter.decide(message, from, side_, std::chrono::steady_clock::now());
    if (!isAccepted) return;
    if (!before.empty()) {
      receiver->OnDataReceived(before.data(), static_cast<std::uint32_t>(before.size()), local, remote);
    }
    receiver->OnDataReceived(bytes, size, local, remote);
  }

 private:
  /// A plain copy, from which Fast DDS reads its limits.
  class Descriptor : public dds_rtps::ChainingTransportDescriptor {
   public:
    using ChainingTransportDescriptor::ChainingTransportDescriptor;
    explicit Descriptor(const dds_rtps::ChainingTransportDescriptor& other) : ChainingTransportDescriptor(other) {}
    dds_rtps::TransportInterface* create_transport() const override { return nullptr; }
  };

  Descriptor descriptor_;
  GatedUdp::Side side_;
  int domain_;
  std::shared_ptr<UdpGate> gate_;
};

}  // namespace

// Where the system has never listed the participant's own sockets, its lists are not trusted for others either.
UdpGate::UdpGate(int domain)
    : announcements([this, domain] { return listeners(domain); }),
      heartbeats([this](std::uint32_t port, const RtpsHeartbeat& heartbeat) {
        return filter.isAcknowledged(port, heartbeat);
      }),
      filter({[this, domain](std::uint32_t port) {
                return discoveryPorts(domain).contains(port) &&
                       (!listsAreComplete() || isUdpOpen({INADDR_LOOPBACK, port}).value_or(true));
              },
              [this](const RtpsAddress& address) {
                return !listsAreComplete() || isUdpOpen({address.address, address.port}).value_or(true);
              }}) {
  ports.reserve(kMostPorts);
}

std::optional<std::vector<std::uint32_t>> UdpGate::listeners(int domain) {
  const auto open = openDiscoveryPorts(domain);
  if (!open) return std::nullopt;
  std::vector<std::uint32_t> listening;
  for (const OpenPort& each : *open) listening.push_back(each.port);
  const std::lock_guard lock(mutex);
  hasOwnSocketsListed |=
      std::ranges::any_of(ports, [&](std::uint32_t port) { return std::ranges::count(listening, port) > 0; });
  return hasOwnSocketsListed ? std::optional(std::move(listening)) : std::nullopt;
}

void UdpGate::startThread(TimerThread::TimePoint openBy, std::function<void()> open) {
  thread_.emplace([this, openBy, open = std::move(open)] {
    if (!isOpen && std::chrono::steady_clock::now() >= openBy) open();
    const TimerThread::TimePoint nextCheck = endLeases();
    return isOpen ? nextCheck : std::min(nextCheck, openBy);
  });
}

TimerThread::TimePoint UdpGate::endLeases() {
  RtpsFilter::Expiry expiry = filter.expireLeases(std::chrono::steady_clock::now());
  for (const std::vector<std::uint8_t>& each : expiry.messages) {
    receiver->OnDataReceived(each.data(), static_cast<std::uint32_t>(each.size()), discoveryPort, discoveryPort);
  }
  return expiry.nextCheck;
}

bool UdpGate::listsAreComplete() {
  const std::lock_guard lock(mutex);
  return hasOwnSocketsListed;
}

GatedUdp::GatedUdp(std::shared_ptr<dds_rtps::UDPv4TransportDescriptor> udp, Side side, int domain,
                   std::shared_ptr<UdpGate> gate)
    : ChainingTransportDescriptor(std::move(udp)), side_(side), domain_(domain), gate_(std::move(gate)) {}

dds_rtps::TransportInterface* GatedUdp::create_transport() const {
  return new GatedUdpTransport(*this, side_, domain_, gate_);
}

}  // namespace pongsim::transport
