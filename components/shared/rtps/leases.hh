#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "shared/rtps/rtps_message.hh"

namespace pongsim::shared {

/// The leases of a participant's neighbours: each ends when nothing has been heard of the neighbour for as long as it
/// announced.
///
/// They are kept here because Fast DDS 2.9 ends the process by a failed assertion where it ends a lease in one thread
/// and handles the participant's goodbye in another (`PDP::check_remote_participant_liveliness`). So the library is
/// told of leases that never end. When one does, a message is made up that lets the library drop the participant; until
/// it has, nothing more of the participant may reach it. Not thread-safe.
class Leases {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  struct Bounds {
    /// Of what is announced.
    std::chrono::nanoseconds shortest, longest;
    /// The lease of whoever says goodbye: how long the library has to drop it by itself.
    std::chrono::nanoseconds afterGoodbye;
  };

  explicit Leases(const Bounds& bounds) : bounds_(bounds) {}

  /// Notes who speaks and what leases they announce.
  /// @param bytes Those of the message; the leases in it become endless.
  /// @return Whether the library may see it: not if it is by, or about, a participant whose lease has ended.
  bool hear(const RtpsMessage& message, std::span<std::uint8_t> bytes, TimePoint now);

  /// Notes that the library knows a participant, or no longer knows it.
  void discovered(const RtpsPrefix& prefix, TimePoint now);
  void removed(const RtpsPrefix& prefix) { neighbours_.erase(prefix); }

  /// Lets a lease end now.
  void end(const RtpsPrefix& prefix);

  /// @return Whether the lease runs.
  bool runs(const RtpsPrefix& prefix) const;
  bool hasEnded(const RtpsPrefix& prefix) const;
  /// @return The number of known participants, including those whose lease has ended.
  std::size_t size() const { return neighbours_.size(); }

  struct Ending {
    RtpsPrefix prefix;
    /// For the message by which the library drops it: higher than all that it has seen of the participant.
    std::uint64_t sequence = 0;
  };
  /// @return Participants whose lease has ended. Each is returned again every second until `removed`, five times at
  /// most.
  std::vector<Ending> endings(TimePoint now);

  /// @return When to call `endings` next: in 10 ms to a second.
  TimePoint nextLook(TimePoint now) const;

 private:
  struct Neighbour {
    TimePoint heard;
    std::chrono::nanoseconds lease{0};
    /// Of its last announcement.
    std::uint64_t sequence = 0;
    bool hasEnded = false;
    int timesTold = 0;
    TimePoint told;

    bool isOver(TimePoint now) const { return hasEnded || now - heard > lease; }
  };

  Bounds bounds_;
  std::map<RtpsPrefix, Neighbour> neighbours_;
};

}  // namespace pongsim::shared
