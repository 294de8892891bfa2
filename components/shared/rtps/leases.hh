#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "shared/rtps/rtps_message.hh"

namespace pongsim::shared {

/// The leases of remote participants: a lease ends when no message of its participant has arrived for the announced
/// duration.
///
/// They are kept here because in Fast DDS 2.9 an assertion fails if a lease ends in one thread while another handles
/// the participant's end (`PDP::check_remote_participant_liveliness`). So Fast DDS gets announcements with infinite
/// leases. When a lease ends, the caller makes Fast DDS remove the participant by a message in its name; until it is
/// removed, its messages must not reach Fast DDS. Not thread-safe.
class Leases {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  struct Bounds {
    /// Announced durations are clamped to these.
    std::chrono::nanoseconds shortest, longest;
    /// Lease of a participant that has announced its end: the time in which Fast DDS has to remove it.
    std::chrono::nanoseconds afterGoodbye;
  };

  explicit Leases(const Bounds& bounds) : bounds_(bounds) {}

  /// Renews the leases of a message's senders, and records the leases that it announces.
  /// @param bytes Those of the message; the leases in it are changed to infinite ones.
  /// @return Whether to pass the message to Fast DDS: false if it is by, or about, a participant whose lease has ended.
  bool receive(const RtpsMessage& message, std::span<std::uint8_t> bytes, TimePoint now);

  /// Fast DDS has discovered or removed a participant.
  void discovered(const RtpsPrefix& prefix, TimePoint now);
  void removed(const RtpsPrefix& prefix) { participants_.erase(prefix); }

  /// Ends a lease now.
  void end(const RtpsPrefix& prefix);

  /// @return Whether the lease runs.
  bool runs(const RtpsPrefix& prefix) const;
  bool hasEnded(const RtpsPrefix& prefix) const;
  /// @return The number of known participants, including those whose lease has ended.
  std::size_t size() const { return participants_.size(); }

  struct Expired {
    RtpsPrefix prefix;
    /// For the message that makes Fast DDS remove it: higher than any that it has received from the participant.
    std::uint64_t sequence = 0;
  };
  /// @return Participants whose lease has ended. Each is returned once per second until it is `removed`, at most five
  /// times.
  std::vector<Expired> expired(TimePoint now);

  /// @return The time for the next call of `expired`, 10 ms to 1 s ahead.
  TimePoint nextCheck(TimePoint now) const;

 private:
  struct Participant {
    TimePoint lastMessage;
    std::chrono::nanoseconds lease{0};
    /// Of its last announcement.
    std::uint64_t sequence = 0;
    bool hasEnded = false;
    /// How often, and when last, `expired` has returned it.
    int reports = 0;
    TimePoint reportedAt;

    bool isOver(TimePoint now) const { return hasEnded || now - lastMessage > lease; }
  };

  Bounds bounds_;
  std::map<RtpsPrefix, Participant> participants_;
};

}  // namespace pongsim::shared
