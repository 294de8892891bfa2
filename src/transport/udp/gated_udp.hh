#pragma once

#include <fastdds/rtps/common/Locator.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/TransportReceiverInterface.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "transport/timer_thread.hh"
#include "transport/udp/announcements.hh"
#include "transport/udp/heartbeats.hh"
#include "transport/udp/rtps_filter.hh"

namespace pongsim::transport {

/// State shared by the UDP transports of a participant, one for each `GatedUdp::Side`.
struct UdpGate {
  explicit UdpGate(int domain);

  /// Starts the thread that ends leases, and that calls `open` if `isOpen` is still false at `openBy`.
  /// @throws std::system_error if the thread can't be started.
  void startThread(TimerThread::TimePoint openBy, std::function<void()> open);
  /// Ends that thread. Must be called before the participant is removed.
  void close() { thread_.reset(); }
  /// @return `hasOwnSocketsListed`, locked.
  bool listsAreComplete();

  /// While false, everything sent or received is discarded.
  std::atomic<bool> isOpen = false;
  std::mutex mutex;
  /// Local ports opened on loopback. Capacity is reserved: `OpenInputChannel` never reallocates.
  std::vector<std::uint32_t> ports;
  /// Fast DDS's receiver for the discovery port, and the port's locator. Set when the port is opened.
  eprosima::fastdds::rtps::TransportReceiverInterface* receiver = nullptr;
  eprosima::fastrtps::rtps::Locator_t discoveryPort;
  /// Whether a list of the system's sockets has contained one of `ports`. Until then the lists are not used: a system
  /// that does not list these does not list others either.
  bool hasOwnSocketsListed = false;
  /// These two filter what is sent to discovery ports of this machine.
  Announcements announcements;
  Heartbeats heartbeats;
  /// Filters what is received.
  RtpsFilter filter;

 private:
  /// @return The domain's discovery ports that are open on this machine; nothing if the system does not report them.
  std::optional<std::vector<std::uint32_t>> listeners(int domain);

  /// Makes Fast DDS remove the participants whose lease has ended.
  /// @return The time of the next call.
  TimerThread::TimePoint endLeases();

  std::optional<TimerThread> thread_;
};

/// A UDP transport of Fast DDS that discards everything until it is opened, and filters what it sends and receives.
///
/// Fast DDS 2.9 announces a new participant before it processes what the participant's sockets receive. Other
/// participants answer an announcement at once and only once. If the answer arrives too early it is lost, and the two
/// discover each other only at the next periodic announcement, seconds later. So nothing is sent until the participant
/// can receive.
///
/// Fast DDS sends announcements to all possible discovery ports. `Announcements` selects the ports to which one is
/// sent, and `Heartbeats` does so for heartbeats. Received messages pass the `RtpsFilter`, because Fast DDS trusts
/// every sender.
///
/// A participant that also communicates with other machines has two such transports, loopback first. Each sends only to
/// the locators of its side, whereas Fast DDS alone would send to all from each socket. The second opens a port only if
/// the first has opened it: otherwise the participant could not receive from its own machine.
class GatedUdp : public eprosima::fastdds::rtps::ChainingTransportDescriptor {
 public:
  /// kLoopback: locators in 127.0.0.0/8, no multicast; kNetwork: all others.
  using Side = RtpsFilter::Side;

  GatedUdp(std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udp, Side side, int domain,
           std::shared_ptr<UdpGate> gate);

  eprosima::fastdds::rtps::TransportInterface* create_transport() const override;

 private:
  Side side_;
  int domain_;
  std::shared_ptr<UdpGate> gate_;
};

}  // namespace pongsim::transport
