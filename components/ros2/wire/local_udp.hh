#pragma once

#include <fastdds/rtps/transport/TransportDescriptorInterface.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ros2/wire/local_sockets.hh"

namespace pongsim::ros2 {

/// Whom the participant meets.
struct Reach {
  /// Addresses of this machine by which it speaks, never empty.
  std::vector<LocalAddress> addresses;
  /// The one of them by which it speaks to other machines, too.
  std::optional<LocalAddress> open;
  /// Whether nodes are told 127.0.0.1 instead of the other addresses.
  bool announcesLoopback = false;
  /// Whether nothing is sent or received.
  bool isNobody = false;

  shared::Senders senders() const;
  /// @return Whether what is for that address, in the network's byte order, may be sent.
  bool mayReach(std::uint32_t address) const;
};

/// @param isLoopbackOnly It announces 127.0.0.1, since nodes of Humble and of Cyclone DDS then listen nowhere else.
/// Those of Jazzy and later announce the addresses of the interfaces, which it speaks to, too.
/// @param interface Name or address of the interface for other machines; unset: for none.
/// @throws std::invalid_argument where there is none of that name.
Reach reachOf(bool isLoopbackOnly, const std::optional<std::string>& interface);

/// UDP for Fast DDS that meets the nodes of this machine, whatever they are set up with, and lets in no packet of
/// another machine: the library's own either is open to everybody, or speaks on 127.0.0.1, where nodes with default
/// settings are not.
///
/// - What is sent to this machine at its ports is heard by any of its addresses; a filter in the kernel drops what does
///   not come from this machine.
/// - The group of discovery is joined by each interface, and sent to with a time to live of 0, so that it reaches the
///   members on this machine and never leaves it.
/// - Nothing is sent to an address that is not this machine's.
///
/// It may be shut at first: Fast DDS 2.9 announces a new participant before that hands on what its sockets receive, and
/// who is there answers at once and once only.
class LocalUdp final : public eprosima::fastdds::rtps::TransportDescriptorInterface {
 public:
  LocalUdp(const Reach& reach, std::shared_ptr<std::atomic<bool>> isOpen);

  eprosima::fastdds::rtps::TransportInterface* create_transport() const override;
  std::uint32_t min_send_buffer_size() const override { return maxMessageSize; }

 private:
  Reach reach_;
  std::shared_ptr<std::atomic<bool>> isOpen_;
};

}  // namespace pongsim::ros2
