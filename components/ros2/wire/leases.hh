#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "ros2/wire/announcements.hh"

namespace pongsim::ros2 {

/// The leases of a participant's neighbours: each ends when nothing has been heard of the neighbour for as long as it
/// announced. All that the participant receives goes through here.
///
/// Fast DDS 2.9 can't be trusted with them: it checks a lease in one thread and removes a participant that says goodbye
/// in another, and fails an assertion if both happen at once (`PDP::check_remote_participant_liveliness`). So it is
/// told of leases that don't end, and when one ends it hears a goodbye, in place of the neighbour's own. Announcements
/// and goodbyes are handed to it one at a time.
///
/// There is no limit to the neighbours that are known, as there is none in Fast DDS, which needs much more memory for
/// each. Any thread may use this.
class Leases {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  using HandOn = std::function<void(std::span<const unsigned char>)>;

  /// Hands a received message on to Fast DDS, with endless leases; or not, if `readPresence` refuses it, or if it tells
  /// of a neighbour whose lease is over. Such a neighbour is heard again after `end`.
  void receive(std::span<unsigned char> packet, TimePoint now, const HandOn& handOn);

  /// Ends the leases that are over.
  /// @param handOn Hands a message on as if it had been received where the participant hears announcements.
  /// @return When to ask again, in a second at the latest.
  TimePoint end(TimePoint now, const HandOn& handOn);

  std::size_t size() const;

 private:
  struct Neighbour {
    TimePoint heard;
    std::chrono::nanoseconds lease{0};

    bool isOver(TimePoint now) const { return now - heard > lease; }
  };

  bool note(const Presence& presence, TimePoint now);
  std::vector<std::vector<unsigned char>> takeEnded(TimePoint now);

  /// Held while Fast DDS handles an announcement; before `mutex_`.
  std::mutex turn_;
  mutable std::mutex mutex_;
  std::map<GuidPrefix, Neighbour> neighbours_;
  std::uint64_t goodbyes_ = 0;
};

}  // namespace pongsim::ros2
