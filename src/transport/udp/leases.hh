#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "transport/udp/rtps_message.hh"

namespace pongsim::transport {

/// The leases of a participant's neighbours: each ends when nothing has been heard of the neighbour for as long as it
/// announced.
///
/// They are kept here since Fast DDS 2.9 ends the process by a failed assertion where a lease ends while the
/// participant is being removed for its goodbye. It is told of leases that never end. When one does, it is told of a
/// new one without any time, and then drops the participant as it always does; until it has, it hears nothing more of
/// it. Not to be used from two threads at once.
class Leases {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  /// Of what is announced.
  struct Bounds {
    std::chrono::nanoseconds shortest, longest;
  };

  explicit Leases(const Bounds& bounds) : bounds_(bounds) {}

  /// Takes note of who speaks. Whoever says goodbye is known until the library has heard it.
  /// @param bytes Of the message; the leases in it become endless.
  /// @return Whether the library may see it.
  bool hear(const RtpsMessage& message, std::span<std::uint8_t> bytes, TimePoint now);

  /// Takes note of whom the library knows, and of whom it does no longer.
  void discovered(const RtpsPrefix& prefix, TimePoint now);
  void removed(const RtpsPrefix& prefix) { neighbours_.erase(prefix); }

  /// Lets a lease end now.
  void end(const RtpsPrefix& prefix);

  /// @return Whether the lease runs.
  bool runs(const RtpsPrefix& prefix) const;
  bool hasEnded(const RtpsPrefix& prefix) const;
  /// @return How many are known, those whose lease has ended among them.
  std::size_t size() const { return neighbours_.size(); }

  struct Ending {
    RtpsPrefix prefix;
    std::vector<std::uint8_t> message;
  };
  /// @return Messages by which the library drops those whose lease has ended, one for each. They are told again every
  /// second, a few times, until it has.
  std::vector<Ending> endings(TimePoint now);

  /// @return When `endings` is to be asked next, in a second at the latest.
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
  };

  std::chrono::nanoseconds makeEndless(std::span<std::uint8_t> bytes, const RtpsDiscovery& announcement) const;

  Bounds bounds_;
  std::map<RtpsPrefix, Neighbour> neighbours_;
};

}  // namespace pongsim::transport
