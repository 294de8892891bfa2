#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pongsim/export.hh"

namespace pongsim {

/// The leases of the neighbours of a Fast DDS participant whose transport is its owner's: a neighbour is dropped when
/// nothing has been heard of it for as long as it announced, 1 to 100 s.
///
/// Fast DDS 2.9 can't be trusted with them: a neighbour that says goodbye when its lease ends can end the process by a
/// failed assertion. So the transport passes each received RTPS message through `admits`, in which Fast DDS reads of
/// leases that never end, and hands it the messages of `endings`, by which it drops who has been silent. Messages that
/// no honest participant sends, some of which end the process too, are refused.
///
/// Who sends a message is not checked. At most 512 neighbours are known; further ones are not met. Any thread may use
/// this.
class PONGSIM_API NeighbourLeases {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  /// The participant's part of a GUID (RTPS 2.3, 8.2.4).
  using Prefix = std::array<std::uint8_t, 12>;
  struct Endings {
    /// RTPS messages for Fast DDS, as if received at the participant's discovery port.
    std::vector<std::vector<std::uint8_t>> messages;
    /// When to ask again; in a second at the latest.
    TimePoint nextLook;
  };

  NeighbourLeases();
  ~NeighbourLeases();
  NeighbourLeases(const NeighbourLeases&) = delete;
  NeighbourLeases& operator=(const NeighbourLeases&) = delete;

  /// @param message A received RTPS message, or any bytes; a lease in it becomes endless.
  /// @return Whether Fast DDS may have it: not if it is malformed or tells of other participants than its sender, nor
  /// from one that has been told to be dropped and is not yet; nor while memory is short.
  bool admits(std::span<std::uint8_t> message, TimePoint now);

  /// Says that Fast DDS knows a neighbour, or that it no longer does.
  void discovered(const Prefix& participant, TimePoint now);
  void removed(const Prefix& participant);

  /// Ends the leases that are over. While memory is short none, or not all.
  Endings endings(TimePoint now);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pongsim
