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

/// Installs the filter for `senders` as a program of the kernel's classic packet filter (socket(7), SO_ATTACH_FILTER).
/// @return Whether it is in force; not if there are more than `kMostAddresses`.
bool limitSenders(int socket, const Senders& senders);

/// Lets a socket receive nothing, as `limitSenders` does.
bool refuseSenders(int socket);

}  // namespace pongsim::shared
