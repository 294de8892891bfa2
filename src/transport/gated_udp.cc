#include "transport/gated_udp.hh"

#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>

#include <utility>

namespace pongsim::transport {

namespace {

namespace dds_rtps = eprosima::fastdds::rtps;
namespace rtps = eprosima::fastrtps::rtps;

class GatedUdpTransport : public dds_rtps::ChainingTransport {
 public:
  GatedUdpTransport(const dds_rtps::ChainingTransportDescriptor& descriptor, std::shared_ptr<std::atomic<bool>> isOpen)
      : ChainingTransport(descriptor), descriptor_(descriptor), isOpen_(std::move(isOpen)) {}

  dds_rtps::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }

  bool send(rtps::SenderResource* udp, const rtps::octet* bytes, std::uint32_t size, rtps::LocatorsIterator* begin,
            rtps::LocatorsIterator* end, const std::chrono::steady_clock::time_point& deadline) override {
    return !*isOpen_ || udp->send(bytes, size, begin, end, deadline);
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
  std::shared_ptr<std::atomic<bool>> isOpen_;
};

}  // namespace

GatedUdp::GatedUdp(std::shared_ptr<dds_rtps::UDPv4TransportDescriptor> udp)
    : ChainingTransportDescriptor(std::move(udp)) {}

dds_rtps::TransportInterface* GatedUdp::create_transport() const { return new GatedUdpTransport(*this, isOpen_); }

}  // namespace pongsim::transport
