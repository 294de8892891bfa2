#pragma once

#include <fastdds/rtps/transport/TransportReceiverInterface.h>

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "pongsim/program/neighbour_leases.hh"
#include "ros2/wire/local_sockets.hh"

namespace pongsim::ros2 {

/// Hands what comes in at some sockets to Fast DDS, from a thread of its own: what `NeighbourLeases` admits, and where
/// the channel is told to, the ends of leases.
class LocalChannel {
 public:
  using Locator = eprosima::fastrtps::rtps::Locator_t;
  using Receiver = eprosima::fastdds::rtps::TransportReceiverInterface;

  /// @param at What Fast DDS knows the sockets by.
  /// @param endsLeases Whether the participant is to hear of leases' ends by this channel, which then is one of
  /// discovery.
  LocalChannel(std::vector<UdpSocket> sockets, const Locator& at, Receiver& receiver, NeighbourLeases& leases,
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
  NeighbourLeases& leases_;
  bool endsLeases_;
  /// When leases may end next.
  NeighbourLeases::TimePoint nextLook_;
  std::vector<unsigned char> packet_;
  int wake_;
  std::atomic<bool> isOver_ = false;
  std::thread thread_;
};

}  // namespace pongsim::ros2
