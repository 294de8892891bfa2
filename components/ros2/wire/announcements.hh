#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pongsim::ros2 {

/// The participant's part of a GUID (RTPS 2.3, 8.2.4).
using GuidPrefix = std::array<unsigned char, 12>;

/// A sample of the topic of participants (RTPS 2.3, 8.5.3), as far as it tells how long the participant is there.
struct Announcement {
  GuidPrefix participant{};
  /// How long it may be silent; unset: it says goodbye.
  std::optional<std::chrono::nanoseconds> lease;
};

/// What an RTPS message tells of who is there.
struct Presence {
  /// Whose submessages it has. One process may speak for several participants in one message.
  std::vector<GuidPrefix> senders;
  std::vector<Announcement> announcements;
};

/// Reads an RTPS message, and replaces each announced lease by one of 34 years.
/// @param packet Any bytes.
/// @return Nothing if Fast DDS must not see the message: it has an announcement whose lease Fast DDS would read and
/// this function can't (one in fragments, or malformed), or of a participant whose goodbye Fast DDS would not hear (its
/// endpoints don't include the writer of announcements, or sequence numbers exceed 2^48).
std::optional<Presence> readPresence(std::span<unsigned char> packet);

/// @param number Must be higher each time: Fast DDS drops what is not newer.
/// @return An RTPS message in which the participant says goodbye. It is newer than all that `readPresence` accepts.
std::vector<unsigned char> goodbye(const GuidPrefix& participant, std::uint64_t number);

}  // namespace pongsim::ros2
