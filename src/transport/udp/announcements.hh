#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

namespace pongsim::transport {

/// Decides which discovery ports of this machine a participant's announcements go to.
///
/// Fast DDS 2.9 announces a participant twice each time, and to all participants whenever it meets one. A hundred that
/// start at once would send a million announcements, where ten thousand suffice. So a port gets the same announcement
/// once per second at most, and again only when the participant there has just been met.
///
/// Ports that are closed get nothing, because the kernel's answer that nobody listens costs more than the message.
/// Whoever opens one later announces itself, and then has been met. Thread-safe.
class Announcements {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  /// @return The ports at which somebody may listen; nothing if the system does not report them.
  using Look = std::function<std::optional<std::vector<std::uint32_t>>()>;

  explicit Announcements(Look look) : look_(std::move(look)) {}

  /// @param sequence The announcement's sequence number.
  /// @return Whether to send the announcement to this port; it then counts as sent.
  bool goesTo(std::uint32_t port, std::uint64_t sequence, TimePoint now);

  /// Lets none go to this port, at which a participant of the same process listens.
  void ignore(std::uint32_t port);

  /// Lets a participant that has just been met have the next announcement.
  void met(std::uint32_t port);

 private:
  struct Sent {
    std::uint64_t sequence = 0;
    TimePoint at;
  };

  bool isOpen(std::uint32_t port, TimePoint now);

  Look look_;
  std::mutex mutex_;
  std::set<std::uint32_t> ignored_;
  /// Without a time where somebody has been met since.
  std::map<std::uint32_t, std::optional<Sent>> sent_;
  std::optional<TimePoint> looked_;
  std::optional<std::vector<std::uint32_t>> open_;
};

}  // namespace pongsim::transport
