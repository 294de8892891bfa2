#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

#include "shared/rtps/rtps_message.hh"
#include "shared/rtps/submessages.hh"

namespace pongsim::ros2 {

/// Modifies requests for discovery data (ACKNACK, RTPS 8.3.7.1) so that Fast DDS 2.9 answers them, and immediately.
///
/// A participant that discovers another one asks for the data of its discovery writers with an ACKNACK that
/// acknowledges nothing and requests a heartbeat. Cyclone DDS asks from number 1 on, which Fast DDS answers only with
/// its next heartbeat, up to a second later: it is changed to ask from 0 on, as Fast DDS does.
///
/// A participant that forgot this one while this one's process was suspended asks anew for what it has acknowledged,
/// which Fast DDS ignores, unless it asks from 0 on: it is changed so, too.
///
/// Fast DDS ignores counts that do not exceed the last one, initially 0. Cyclone's first one is 0, and who has
/// forgotten this participant may count anew: all are replaced by those of one series.
///
/// Not thread-safe.
class DiscoveryAcknacks {
 public:
  /// Modifies a message in place.
  /// @param source Its sender.
  /// @param packet An RTPS message, or any bytes.
  /// @return The number of requests that ask from 0 on now.
  std::size_t modify(const shared::RtpsPrefix& source, std::span<std::uint8_t> packet);

  /// Forgets what a participant has acknowledged.
  void forget(const shared::RtpsPrefix& source) { acknowledged_.erase(source); }

 private:
  bool modify(std::uint64_t& acknowledged, const shared::Submessage& part, std::span<std::uint8_t> content);

  /// For each participant, up to which number it has acknowledged publications and subscriptions.
  std::map<shared::RtpsPrefix, std::array<std::uint64_t, 2>> acknowledged_;
  std::uint32_t count_ = 0;
};

}  // namespace pongsim::ros2
