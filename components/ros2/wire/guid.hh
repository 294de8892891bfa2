#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>

namespace pongsim::ros2 {

/// Identifies a participant, a writer or a reader: 12 bytes of the participant's prefix, 4 of the entity. All zeros:
/// none.
struct Guid {
  std::array<std::uint8_t, 16> bytes{};
  auto operator<=>(const Guid&) const = default;
  /// @return Whether both belong to the same participant.
  bool isOfSameParticipant(const Guid& other) const {
    return std::equal(bytes.begin(), bytes.begin() + 12, other.bytes.begin());
  }
};

/// Identifies a sample: its writer and its sequence number. Used to match requests and replies.
struct SampleId {
  Guid writer;
  std::int64_t number = 0;
  auto operator<=>(const SampleId&) const = default;
};

}  // namespace pongsim::ros2
