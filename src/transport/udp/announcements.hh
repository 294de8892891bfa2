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

/// Filters a participant's SPDP announcements: decides for each discovery port of this machine whether one is sent.
///
/// Fast DDS 2.9 sends each announcement twice, and sends it to all participants whenever it discovers one. A hundred
/// participants that start together would send a million announcements, where ten thousand suffice. So a port gets the
/// same announcement (sequence number) at most once per second, and earlier only if its participant has just been
/// discovered.
///
/// Closed ports get nothing: the kernel answers with an ICMP error, which costs more than the message. A participant
/// that opens such a port later announces itself, which calls `discovered`. Thread-safe.
class Announcements {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  /// @return The open discovery ports of this machine; nothing if the system does not report them.
  using ListOpenPorts = std::function<std::optional<std::vector<std::uint32_t>>()>;

  explicit Announcements(ListOpenPorts listOpenPorts) : listOpenPorts_(std::move(listOpenPorts)) {}

  /// @param sequence The announcement's sequence number.
  /// @return Whether to send the announcement to this port; if so, it is recorded as sent.
  bool goesTo(std::uint32_t port, std::uint64_t sequence, TimePoint now);

  /// Sends no more announcements to this port, which belongs to another participant of this process.
  void ignore(std::uint32_t port);

  /// Records that the participant at this port has just been discovered: the next announcement is sent to it.
  void discovered(std::uint32_t port);

 private:
  struct Sent {
    std::uint64_t sequence = 0;
    TimePoint at;
  };

  bool isOpen(std::uint32_t port, TimePoint now);

  ListOpenPorts listOpenPorts_;
  std::mutex mutex_;
  std::set<std::uint32_t> ignored_;
  /// The last announcement sent to each port; empty if the port's participant has been discovered since.
  std::map<std::uint32_t, std::optional<Sent>> sent_;
  std::optional<TimePoint> listedAt_;
  std::optional<std::vector<std::uint32_t>> open_;
};

}  // namespace pongsim::transport
