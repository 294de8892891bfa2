#pragma once

#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <atomic>
#include <memory>

namespace pongsim::transport {

/// UDP whose way out can be shut.
///
/// Fast DDS 2.9 announces a new participant before it hands on what the participant's sockets receive. Whoever is there
/// answers at once and only once, and where the answer is quicker than the participant it is lost: the two meet at the
/// next periodic announcement, seconds later. So nothing may leave until the participant listens.
class GatedUdp : public eprosima::fastdds::rtps::ChainingTransportDescriptor {
 public:
  explicit GatedUdp(std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udp);

  /// Lets out what is sent from now on; what was sent before is lost.
  void open() { *isOpen_ = true; }

  eprosima::fastdds::rtps::TransportInterface* create_transport() const override;

 private:
  std::shared_ptr<std::atomic<bool>> isOpen_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace pongsim::transport
