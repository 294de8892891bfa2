#pragma once

#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <set>

namespace pongsim::transport {

/// What the ways out of a participant share.
struct UdpGate {
  /// Lets out what is sent from now on; what was sent before is lost.
  void open() { isOpen = true; }

  std::atomic<bool> isOpen = false;
  std::mutex mutex;
  /// Ports that are open on loopback.
  std::set<std::uint32_t> ports;
  /// Whether the system has once told of one of them, when asked who listens.
  bool isTold = false;
};

/// UDP whose way out can be shut.
///
/// Fast DDS 2.9 announces a new participant before it hands on what the participant's sockets receive. Whoever is there
/// answers at once and only once, and where the answer is quicker than the participant it is lost: the two meet at the
/// next periodic announcement, seconds later. So nothing may leave until the participant listens.
///
/// And an announcement, which goes to the discovery ports of all participants that there could be, goes to those that
/// are open: the kernel's answer that nobody listens costs more than the message. Whoever opens one later announces
/// itself to the others.
///
/// A participant that talks to other machines too has two of them, loopback first. Each sends only what is for its
/// side, where the library sends everything from each socket; and the second listens at a port only where the first
/// does, for otherwise a participant could be deaf for its own machine.
class GatedUdp : public eprosima::fastdds::rtps::ChainingTransportDescriptor {
 public:
  enum class Side {
    /// This machine: what is for 127.0.0.0/8, and no multicast.
    kLoopback,
    /// All else.
    kBeyond
  };

  GatedUdp(std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udp, Side side, int domain,
           std::shared_ptr<UdpGate> gate);

  eprosima::fastdds::rtps::TransportInterface* create_transport() const override;

 private:
  Side side_;
  int domain_;
  std::shared_ptr<UdpGate> gate_;
};

}  // namespace pongsim::transport
