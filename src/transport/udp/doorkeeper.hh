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

/// So much a second, and so much at once.
class Allowance {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  Allowance(double most, double perSecond) : most_(most), perSecond_(perSecond), left_(most) {}

  /// @return Whether there is as much, which then is taken.
  bool take(double amount, TimePoint now);

 private:
  double most_, perSecond_, left_;
  std::optional<TimePoint> last_;
};

/// Decides which messages a participant's library gets to see, for it trusts everybody: whoever says to be a
/// participant is kept in mind for as long as he says, and whoever speaks in another's name is believed.
///
/// A participant is introduced by its first announcement. That must come from a socket, and lead to a port, that there
/// are. From then on its messages come from that socket and no other, and what can be asked of its reader is bounded
/// by time: endpoints that it tells of, numbers that it skips, samples that it wants again. When it has been silent for
/// its lease, or has forgotten this participant, the library is told to drop it.
///
/// Before the library drops a participant, it is told that the participant has received all of this one's discovery.
/// Fast DDS 2.9 otherwise waits for itself for ever, with the participant's locks, where one leaves that is just being
/// sent again what tells of an endpoint's end (docs/transport.md). Any thread may use this.
class Doorkeeper {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  enum class Side {
    /// This machine, whose sockets can be looked at.
    kLoopback,
    /// Others.
    kBeyond
  };
  /// What is open on this machine.
  struct Sockets {
    /// Whether somebody listens for participants at the port.
    std::function<bool(std::uint32_t port)> isDiscovery;
    /// Whether there is that socket.
    std::function<bool(const RtpsAddress& address)> isOpen;
  };

  struct Admission {
    /// Whether the library may see the message.
    bool isAdmitted = false;
    /// A message that it must see before; empty: none.
    std::vector<std::uint8_t> before;
  };

  explicit Doorkeeper(Sockets sockets);

  /// @param bytes A message; the lease in it becomes endless, see `shared::Leases`.
  /// @param from The socket that it comes from.
  Admission admits(std::span<std::uint8_t> bytes, const RtpsAddress& from, Side side, TimePoint now);

  /// Takes note of a message that this participant sends.
  void sends(const RtpsMessage& message);

  /// Takes note of whom the library knows, and of whom it does no longer.
  void discovered(const RtpsPrefix& prefix, TimePoint now);
  void removed(const RtpsPrefix& prefix);

  /// Lets nothing in of a participant of the same process, which listens for others at that port.
  void ignore(const RtpsPrefix& prefix, std::uint32_t port);

  /// @return Whether somebody known listens for others at this port of this machine, and all who do have acknowledged
  /// what the heartbeat announces. True where it is the port of one who is ignored.
  bool isAcknowledged(std::uint32_t port, const RtpsHeartbeat& heartbeat);

  struct Endings {
    /// Messages for the library, in this order. It then drops those who have been silent for their lease.
    std::vector<std::vector<std::uint8_t>> messages;
    TimePoint nextLook;
  };
  Endings endings(TimePoint now);

 private:
  struct Known {
    /// One at most of each address.
    std::vector<RtpsAddress> sockets;
    /// Those of its announcement.
    std::vector<RtpsAddress> addresses;
    /// Where it listens for others.
    std::uint32_t port = 0;
    Side side = Side::kLoopback;
    /// Whether the library knows it, and the announcement that the library has seen last.
    bool isDiscovered = false;
    std::uint64_t seen = 0;
    TimePoint seenAt;
    /// What it has received of the participant's own discovery, by writer.
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
  /// Those whose lease runs.
  std::map<RtpsPrefix, Known> known_;
  /// By participant, the port.
  std::map<RtpsPrefix, std::uint32_t> ignored_;
  /// By writer of this participant's own discovery, the number of its last sample that was sent.
  std::map<RtpsEntity, std::uint64_t> sent_;
  shared::Leases leases_;
  /// Looks at the system's sockets.
  Allowance looks_{300, 100};
};

}  // namespace pongsim::transport
