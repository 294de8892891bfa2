#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pongsim::shared {

/// The senders from which a socket receives; the kernel drops the packets of all others. IPv4 addresses in network byte
/// order.
struct Senders {
  /// The most addresses that a filter of the kernel can compare with.
  static constexpr std::size_t kMostAddresses = 200;

  /// This machine, by these addresses and those of 127.0.0.0/8. The kernel itself drops packets from elsewhere with
  /// such a sender.
  std::vector<std::uint32_t> addresses;
  /// Others too, where they send to this address of the machine.
  std::optional<std::uint32_t> openAddress = std::nullopt;
  /// Or everybody.
  bool isAnybody = false;
};

/// UDP packets that a socket does not receive either, whoever sends them.
struct RefusedKind {
  /// Where in the packet's content its kind is.
  std::uint32_t offset = 0;
  /// The byte there, such as the tag of protobuf's field.
  std::uint8_t tag = 0;
  /// The least value of the byte after it that is refused.
  std::uint8_t least = 0;
};

/// Installs the filter as a program of the kernel's classic packet filter (socket(7), SO_ATTACH_FILTER).
/// @return Whether it is in force; not if there are more than `kMostAddresses`.
bool limitSenders(int socket, const Senders& senders, const std::optional<RefusedKind>& refused = std::nullopt);

/// Lets a socket receive nothing, as `limitSenders` does.
bool refuseSenders(int socket);

}  // namespace pongsim::shared
