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

#include "transport/udp/announcements.hh"
#include "transport/udp/doorkeeper.hh"
#include "transport/udp/heartbeats.hh"
#include "transport/watch.hh"

namespace pongsim::transport {

/// What the ways out and in of a participant share.
struct UdpGate {
  explicit UdpGate(int domain);

  /// Lets leases end from now on, and calls `open` if the gate is not open by `openBy`.
  /// @throws std::system_error where the system gives no thread.
  void watch(Watch::TimePoint openBy, std::function<void()> open);
  /// Ends no more leases, and does not open by itself any more. To be called before the participant is removed.
  void close() { watch_.reset(); }
  /// @return Whether the system says who listens.
  bool tells();

  /// What is sent or received before is lost.
  std::atomic<bool> isOpen = false;
  std::mutex mutex;
  /// Ports that are open on loopback. Its capacity does not change.
  std::vector<std::uint32_t> ports;
  /// Who takes what comes in at the discovery port, and where that is.
  eprosima::fastdds::rtps::TransportReceiverInterface* receiver = nullptr;
  eprosima::fastrtps::rtps::Locator_t discoveryPort;
  /// Whether the system has once told of one of them, when asked who listens.
  bool isTold = false;
  /// Say where these go on this machine.
  Announcements announcements;
  Heartbeats heartbeats;
  /// Says what may come in.
  Doorkeeper doorkeeper;

 private:
  /// @return The domain's discovery ports that are open on this machine; nothing if the system does not report them.
  std::optional<std::vector<std::uint32_t>> listeners(int domain);

  /// @return When leases may end next.
  Watch::TimePoint endLeases();

  std::optional<Watch> watch_;
};

/// UDP whose way out can be shut, and whose way in is guarded.
///
/// Fast DDS 2.9 announces a new participant before it hands on what the participant's sockets receive. Whoever is there
/// answers at once and only once, and where the answer is quicker than the participant it is lost: the two meet at the
/// next periodic announcement, seconds later. So nothing may leave until the participant listens.
///
/// Announcements go to all participants that there could be. `Announcements` picks those to whom one is news, and
/// `Heartbeats` does so for heartbeats.
///
/// What comes in goes by a `Doorkeeper`, for the library trusts whoever speaks to it.
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
