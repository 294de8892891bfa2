#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "shared/rtps/leases.hh"
#include "shared/rtps/rtps_message.hh"

namespace pongsim::transport {

using shared::RtpsAcknowledgement;
using shared::RtpsAddress;
using shared::RtpsDiscovery;
using shared::RtpsEntity;
using shared::RtpsHeartbeat;
using shared::RtpsMessage;
using shared::RtpsPrefix;

/// A token bucket: an amount at once, and then an amount per second.
class Allowance {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  Allowance(double most, double perSecond) : most_(most), perSecond_(perSecond), left_(most) {}

  /// @return Whether the amount was there; it is then taken.
  bool take(double amount, TimePoint now);

 private:
  double most_, perSecond_, left_;
  std::optional<TimePoint> last_;
};

/// Decides which received messages Fast DDS sees, because it trusts every sender: it keeps each announced participant
/// for the announced lease, whatever that is, and accepts messages in the name of others.
///
/// A participant becomes known by its first announcement, which must come from an existing socket and name an existing
/// discovery port. From then on its messages must come from that socket, and what they cost is limited per second:
/// announced endpoints, sequence numbers in gaps, samples requested again. When it has been silent for its lease, or
/// has forgotten this participant, the library is told to drop it.
///
/// Before the library drops a participant, it is told that the participant has acknowledged all discovery data of this
/// one. Otherwise Fast DDS 2.9 deadlocks if the participant leaves while the end of an endpoint is being sent to it
/// again (docs/transport.md). Thread-safe.
class Doorkeeper {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  enum class Side {
    /// From this machine, whose open sockets the system can list.
    kLoopback,
    /// From other machines.
    kBeyond
  };
  /// What is open on this machine.
  struct Sockets {
    /// Whether a process listens for participants at the port.
    std::function<bool(std::uint32_t port)> isDiscovery;
    /// Whether a socket has the address.
    std::function<bool(const RtpsAddress& address)> isOpen;
  };

  struct Admission {
    /// Whether the library may see the message.
    bool isAdmitted = false;
    /// A message to pass to it first; empty: none.
    std::vector<std::uint8_t> before;
  };

  explicit Doorkeeper(Sockets sockets);

  /// @param bytes A message; the lease in it becomes endless, see `shared::Leases`.
  /// @param from The socket that it comes from.
  Admission admits(std::span<std::uint8_t> bytes, const RtpsAddress& from, Side side, TimePoint now);

  /// Notes what a message that this participant sends says of its discovery data.
  void sends(const RtpsMessage& message);

  /// Notes that the library knows a participant, or no longer knows it.
  void discovered(const RtpsPrefix& prefix, TimePoint now);
  void removed(const RtpsPrefix& prefix);

  /// Refuses all messages of another participant of this process, which listens for others at that port.
  void ignore(const RtpsPrefix& prefix, std::uint32_t port);

  /// @return Whether known participants of this machine listen for others at this port, and all of them have
  /// acknowledged what the heartbeat announces; also true for the port of an ignored one.
  bool isAcknowledged(std::uint32_t port, const RtpsHeartbeat& heartbeat);

  struct Endings {
    /// Messages to pass to the library, in this order: it then drops the participants whose lease has ended.
    std::vector<std::vector<std::uint8_t>> messages;
    TimePoint nextLook;
  };
  Endings endings(TimePoint now);

 private:
  struct Known {
    /// The sockets that its messages come from, at most one per address.
    std::vector<RtpsAddress> sockets;
    /// Those of its announcement.
    std::vector<RtpsAddress> addresses;
    /// Where it listens for others.
    std::uint32_t port = 0;
    Side side = Side::kLoopback;
    /// Whether the library knows it, and the sequence number and time of the last announcement that the library saw.
    bool isDiscovered = false;
    std::uint64_t seen = 0;
    TimePoint seenAt;
    /// What it has acknowledged of this participant's discovery data, by writer.
    std::map<RtpsEntity, RtpsAcknowledgement> acknowledged;
    Allowance endpoints, endpointBytes, gaps, repeatRequests;

    Known();
    bool isWithinMeans(const RtpsMessage& message, TimePoint now);
    bool hasForgotten(const RtpsMessage& message);
    bool isNews(const RtpsMessage& message, TimePoint now);
  };

  Known* introduce(const RtpsMessage& message, const RtpsAddress& from, Side side, TimePoint now);
  bool isRoomFor(std::uint32_t port, const RtpsAddress& from, Side side);
  std::vector<std::uint8_t> lastAcknowledgement(const RtpsPrefix& prefix) const;
  static bool isFrom(Known& known, const RtpsAddress& from);

  std::mutex mutex_;
  Sockets sockets_;
  /// Participants whose lease has not ended.
  std::map<RtpsPrefix, Known> known_;
  /// The port of each ignored participant.
  std::map<RtpsPrefix, std::uint32_t> ignored_;
  /// The number of the last sample sent by each writer of this participant's discovery data.
  std::map<RtpsEntity, std::uint64_t> sent_;
  shared::Leases leases_;
  /// Queries of the system's sockets.
  Allowance looks_{300, 100};
};

}  // namespace pongsim::transport
