#include "transport/udp/gated_udp.hh"

#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastrtps/utils/IPLocator.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "transport/udp/domain.hh"
#include "transport/udp/udp_sockets.hh"

namespace pongsim::transport {

namespace {

namespace dds_rtps = eprosima::fastdds::rtps;
namespace rtps = eprosima::fastrtps::rtps;

constexpr const char* kLocalAddress = "127.0.0.1";

/// @return Whether sending to the locator is that side's business.
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

/// Whether the system tells of such a socket. One that does not tell of any has each.
bool isBound(const RtpsAddress& address) {
  const auto port = static_cast<std::uint16_t>(address.port);
  const auto sockets = boundUdpSockets({port, port});
  if (!sockets) return true;
  return std::ranges::any_of(
      *sockets, [&](const BoundUdp& each) { return each.address == address.address || each.address == 0; });
}

bool isAmong(const std::vector<OpenPort>& open, std::uint32_t port) {
  return std::ranges::find(open, port, &OpenPort::port) != open.end();
}

/// Which discovery ports of this machine somebody may listen at. Looks where it is asked for more than a few, as for an
/// announcement, so that what goes to one peer is not held up.
class Listeners {
 public:
  Listeners(int domain, UdpGate& gate) : domain_(domain), gate_(gate) {}

  bool mayHear(std::uint32_t port) {
    if (!discoveryPorts(domain_).contains(port)) return true;
    constexpr int kFew = 2;
    if (++asked_ <= kFew) return true;
    if (asked_ == kFew + 1) look();
    return !open_ || isOpen(port);
  }

 private:
  void look() {
    open_ = openDiscoveryPorts(domain_);
    // a system that has never known of the participant's own one does not tell
    const std::lock_guard lock(gate_.mutex);
    gate_.isTold |= std::ranges::any_of(gate_.ports, [this](std::uint32_t port) { return isOpen(port); });
    if (!gate_.isTold) open_.reset();
  }

  bool isOpen(std::uint32_t port) const { return open_ && isAmong(*open_, port); }

  int domain_;
  UdpGate& gate_;
  int asked_ = 0;
  std::optional<std::vector<OpenPort>> open_;
};

/// Those of other locators that are on one side, and where somebody may listen.
class OwnSide : public rtps::LocatorsIterator {
 public:
  OwnSide(GatedUdp::Side side, const Listeners& listeners, rtps::LocatorsIterator& all,
          const rtps::LocatorsIterator& end)
      : side_(side), listeners_(listeners), all_(all), end_(end) {
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
    return side_ == GatedUdp::Side::kBeyond || listeners_.mayHear(locator.port);
  }

  GatedUdp::Side side_;
  Listeners listeners_;
  rtps::LocatorsIterator& all_;
  const rtps::LocatorsIterator& end_;
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
      // the participant listens at its other address, of which this way does not know
      rtps::Locator_t local = locator;
      rtps::IPLocator::setIPv4(local, kLocalAddress);
      if (isMulticast || !ChainingTransport::OpenInputChannel(local, receiver, size)) return false;
      const std::lock_guard lock(gate_->mutex);
      gate_->ports.insert(locator.port);
      if (discoveryPorts(domain_).contains(locator.port)) {
        gate_->receiver = receiver;
        gate_->discoveryPort = local;
      }
      return true;
    }
    {
      const std::lock_guard lock(gate_->mutex);
      if (!isMulticast && !gate_->ports.contains(locator.port)) return false;
    }
    return ChainingTransport::OpenInputChannel(locator, receiver, size);
  }

  /// The addresses of this machine are all reached by 127.0.0.1, for whoever listens at another one listens there too.
  bool transform_remote_locator(const rtps::Locator_t& remote, rtps::Locator_t& result) const override {
    if (side_ == GatedUdp::Side::kBeyond) return ChainingTransport::transform_remote_locator(remote, result);
    if (!IsLocatorSupported(remote) || !is_local_locator(remote)) return false;
    result = remote;
    rtps::IPLocator::setIPv4(result, kLocalAddress);
    return true;
  }

  bool send(rtps::SenderResource* udp, const rtps::octet* bytes, std::uint32_t size, rtps::LocatorsIterator* begin,
            rtps::LocatorsIterator* end, const std::chrono::steady_clock::time_point& deadline) override {
    if (!gate_->isOpen) return true;
    OwnSide own(side_, Listeners(domain_, *gate_), *begin, *end);
    return own == *end || udp->send(bytes, size, &own, end, deadline);
  }

  void receive(dds_rtps::TransportReceiverInterface* receiver, const rtps::octet* bytes, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    const RtpsAddress from{addressOf(remote), remote.port};
    const auto side = side_ == GatedUdp::Side::kLoopback ? Doorkeeper::Side::kLoopback : Doorkeeper::Side::kBeyond;
    // it is the library's buffer, which it may change itself
    const std::span message(const_cast<rtps::octet*>(bytes), size);
    if (!gate_->doorkeeper.admits(message, from, side, std::chrono::steady_clock::now())) return;
    receiver->OnDataReceived(bytes, size, local, remote);
  }

 private:
  /// A plain copy, for Fast DDS to read limits from.
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

// A system that has never known of the participant's own sockets does not tell of others either.
UdpGate::UdpGate(int domain)
    : doorkeeper({[this, domain](std::uint32_t port) {
                    if (!discoveryPorts(domain).contains(port)) return false;
                    const auto open = openDiscoveryPorts(domain);
                    return !open || !tells() || isAmong(*open, port);
                  },
                  [this](const RtpsAddress& address) { return !tells() || isBound(address); }}) {}

void UdpGate::open() {
  isOpen = true;
  watch_.emplace([this] { return endLeases(); });
}

Watch::TimePoint UdpGate::endLeases() {
  Doorkeeper::Endings endings = doorkeeper.endings(std::chrono::steady_clock::now());
  for (const std::vector<std::uint8_t>& each : endings.messages) {
    receiver->OnDataReceived(each.data(), static_cast<std::uint32_t>(each.size()), discoveryPort, discoveryPort);
  }
  return endings.nextLook;
}

bool UdpGate::tells() {
  const std::lock_guard lock(mutex);
  return isTold;
}

GatedUdp::GatedUdp(std::shared_ptr<dds_rtps::UDPv4TransportDescriptor> udp, Side side, int domain,
                   std::shared_ptr<UdpGate> gate)
    : ChainingTransportDescriptor(std::move(udp)), side_(side), domain_(domain), gate_(std::move(gate)) {}

dds_rtps::TransportInterface* GatedUdp::create_transport() const {
  return new GatedUdpTransport(*this, side_, domain_, gate_);
}

}  // namespace pongsim::transport
