#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "shared/rtps/leases.hh"
#include "shared/rtps/rtps_message.hh"
#include "transport/udp/token_bucket.hh"

namespace pongsim::transport {

using shared::RtpsAcknowledgement;
using shared::RtpsAddress;
using shared::RtpsDiscovery;
using shared::RtpsEntity;
using shared::RtpsHeartbeat;
using shared::RtpsMessage;
using shared::RtpsPrefix;

/// Filters received RTPS messages before Fast DDS processes them, because Fast DDS trusts every sender: it keeps an
/// announced participant for whatever lease the announcement contains, and accepts messages in the name of others.
///
/// A participant becomes known by its first announcement, which must come from an open socket and contain an open
/// discovery port. From then on its messages must come from that socket, and these are limited per second: announced
/// endpoints, sequence numbers in GAP submessages, samples requested again. When the participant has been silent for
/// its lease, or has removed this one (`hasRediscovered`), Fast DDS is made to remove it.
///
/// Nodes of ROS in simulations, which share no topic with this participant, are never known.
///
/// Before Fast DDS removes a participant, it receives an acknowledgement of all discovery data in that participant's
/// name. Otherwise Fast DDS 2.9 deadlocks if the participant leaves while the end of an endpoint is being sent to it
/// again (docs/transport.md). Thread-safe: Fast DDS calls it on its receiving threads and on all that send.
class RtpsFilter {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  enum class Side {
    /// Received on loopback: from this machine, whose open sockets the system can list.
    kLoopback,
    /// Received on the interface for other machines.
    kNetwork
  };
  /// Queries of the open UDP sockets of this machine.
  struct Sockets {
    /// Whether a socket on 127.0.0.1 is bound to this discovery port of the domain.
    std::function<bool(std::uint32_t port)> isDiscovery;
    /// Whether a socket receives at this address.
    std::function<bool(const RtpsAddress& address)> isOpen;
  };

  struct Decision {
    /// Whether to pass the message to Fast DDS.
    bool isAccepted = false;
    /// A message to pass to Fast DDS before it; empty: none.
    std::vector<std::uint8_t> before;
  };

  explicit RtpsFilter(Sockets sockets);

  /// @param bytes The message. The lease in it is changed to an infinite one, see `shared::Leases`.
  /// @param from The sender's socket.
  Decision decide(std::span<std::uint8_t> bytes, const RtpsAddress& from, Side side, TimePoint now);

  /// Records the sequence numbers of discovery data in a message that this participant sends.
  void recordSent(const RtpsMessage& message);

  /// Fast DDS has discovered or removed a participant. Called from its listener.
  void discovered(const RtpsPrefix& prefix, TimePoint now);
  void removed(const RtpsPrefix& prefix);

  /// Drops all messages from another participant of this process, whose discovery port is given.
  void ignore(const RtpsPrefix& prefix, std::uint32_t port);

  /// @return Whether at least one participant of this machine has this discovery port, and all that have it have
  /// acknowledged the samples that the heartbeat announces; also true for the port of an ignored participant.
  bool isAcknowledged(std::uint32_t port, const RtpsHeartbeat& heartbeat);

  struct Expiry {
    /// Messages to pass to Fast DDS, in this order, so that it removes the participants whose lease has ended.
    std::vector<std::vector<std::uint8_t>> messages;
    TimePoint nextCheck;
  };
  Expiry expireLeases(TimePoint now);

 private:
  struct RemoteParticipant {
    /// The sockets from which its messages come, at most one per address.
    std::vector<RtpsAddress> sockets;
    /// The addresses in its announcement.
    std::vector<RtpsAddress> addresses;
    /// Its discovery port.
    std::uint32_t port = 0;
    Side side = Side::kLoopback;
    /// Whether Fast DDS has discovered it, and sequence number and time of the last announcement passed to Fast DDS.
    bool isDiscovered = false;
    std::uint64_t passedSequence = 0;
    TimePoint passedAt;
    /// Its last acknowledgement of this participant's discovery data, by writer.
    std::map<RtpsEntity, RtpsAcknowledgement> acknowledged;
    TokenBucket endpoints, endpointBytes, gaps, repeatRequests;

    RemoteParticipant();
    bool isWithinLimits(const RtpsMessage& message, TimePoint now);
    bool hasRediscovered(const RtpsMessage& message);
    bool isNewToDds(const RtpsMessage& message, TimePoint now);
  };

  RemoteParticipant* addParticipant(const RtpsMessage& message, const RtpsAddress& from, Side side, TimePoint now);
  bool isRoomFor(std::uint32_t port, const RtpsAddress& from, Side side);
  std::vector<std::uint8_t> lastAcknowledgement(const RtpsPrefix& prefix) const;
  static bool isItsSocket(RemoteParticipant& participant, const RtpsAddress& from);

  std::mutex mutex_;
  Sockets sockets_;
  /// Participants whose lease has not ended.
  std::map<RtpsPrefix, RemoteParticipant> participants_;
  /// The discovery port of each ignored participant of this process.
  std::map<RtpsPrefix, std::uint32_t> ignored_;
  /// The last sequence number sent by each of this participant's discovery writers.
  std::map<RtpsEntity, std::uint64_t> sent_;
  shared::Leases leases_;
  /// Limits the queries of the system's sockets.
  TokenBucket socketQueries_{300, 100};
};

}  // namespace pongsim::transport
