#include "transport/gated_udp.hh"

#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastrtps/utils/IPLocator.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "transport/domain.hh"

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

  bool isOpen(std::uint32_t port) const {
    return open_ && std::ranges::find(*open_, port, &OpenPort::port) != open_->end();
  }

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

GatedUdp::GatedUdp(std::shared_ptr<dds_rtps::UDPv4TransportDescriptor> udp, Side side, int domain,
                   std::shared_ptr<UdpGate> gate)
    : ChainingTransportDescriptor(std::move(udp)), side_(side), domain_(domain), gate_(std::move(gate)) {}

dds_rtps::TransportInterface* GatedUdp::create_transport() const {
  return new GatedUdpTransport(*this, side_, domain_, gate_);
}

}  // namespace pongsim::transport
