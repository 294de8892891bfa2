#pragma once

#include <fastdds/rtps/transport/TransportReceiverInterface.h>

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "ros2/wire/discovery_guard.hh"
#include "ros2/wire/local_sockets.hh"

namespace pongsim::ros2 {

/// Hands what comes in at some sockets to Fast DDS, by way of a `DiscoveryGuard`, from a thread of its own.
class LocalChannel {
 public:
  using Locator = eprosima::fastrtps::rtps::Locator_t;
  using Receiver = eprosima::fastdds::rtps::TransportReceiverInterface;

  /// @param at What Fast DDS knows the sockets by.
  /// @param endsLeases Whether leases are to end by this channel, which then must be one where announcements are heard.
  LocalChannel(std::vector<UdpSocket> sockets, const Locator& at, Receiver& receiver, DiscoveryGuard& guard,
               bool endsLeases, std::size_t largest);
  /// `receiver` is not called from then on.
  ~LocalChannel();
  LocalChannel(const LocalChannel&) = delete;
  LocalChannel& operator=(const LocalChannel&) = delete;

 private:
  void run();
  /// @return Milliseconds until leases may end next; -1: not here.
  int endLeases();
  void drain(const UdpSocket& socket);

  std::vector<UdpSocket> sockets_;
  Locator at_;
  Receiver& receiver_;
  DiscoveryGuard& guard_;
  bool endsLeases_;
  /// When leases may end next.
  DiscoveryGuard::TimePoint nextCheck_;
  std::vector<std::uint8_t> packet_;
  int wake_;
  std::atomic<bool> isOver_ = false;
  std::thread thread_;
};

}  // namespace pongsim::ros2
