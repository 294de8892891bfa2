#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hostile/neighbour.hh"
#include "hostile/packet.hh"

namespace pongsim::hostile {

/// Kinds of attack. All messages are well formed, or nearly.
enum class Attack {
  /// Participants with new GUIDs, odd leases, and locators of other participants, other hosts, groups or port 0.
  kParticipants,
  /// The same, each sent from a new socket.
  kSockets,
  /// Messages with the GUIDs of existing participants: that they or their endpoints have gone, or other addresses.
  kForgedParticipants,
  /// A participant with ever more endpoints, enormous names, and other types for known topics.
  kEndpoints,
  /// Endpoints with parameters that are repeated, unknown, not terminated or of wrong length.
  kParameters,
  /// Samples with the GUIDs of existing writers, and sequence numbers far ahead.
  kForgedData,
  /// A publisher of samples that claim gigabytes, in few and overlapping fragments.
  kFragments,
  /// Heartbeats and gaps with the GUIDs of existing writers, over the whole range of sequence numbers.
  kHeartbeats,
  /// Readers, forged and the attacker's own, that request all samples again.
  kAckNacks,
  /// Messages with many changes of source, destination and time, and submessages of DDS-Security.
  kInterpreter,
  /// Participants that say goodbye at the moment when their lease ends.
  kLeases
};

/// @return All attacks with their names.
std::span<const std::pair<std::string_view, Attack>> attacks();
std::optional<Attack> attackOf(std::string_view name);

/// Attacks all participants of a domain on this machine. The same seed and neighbours give the same messages.
class Attacker {
 public:
  Attacker(int domain, std::uint64_t seed);

  /// Discovers participants, for up to `atMost`.
  /// @return Their number.
  std::size_t look(std::chrono::milliseconds atMost);

  /// Sends one message.
  void strike(Attack attack);

  std::uint64_t sent() const { return sent_; }

 private:
  /// @return A number from 0 to `end` - 1.
  std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
  bool oneIn(std::uint32_t chances) { return below(chances) == 0; }
  Prefix freshPrefix();
  EntityId guessedEndpoint(bool isWriter);
  std::int64_t oddSequence();
  std::string enormousName();

  Packet participant(const Prefix& prefix, bool isHonest, std::uint32_t lease = 20);
  void addOddLocators(Packet& packet);
  Packet forgedParticipant();
  Packet endpoint(const Prefix& prefix, EntityId id, std::string_view topic, std::string_view type);
  Packet floodOfEndpoints();
  Packet brokenParameters();
  Packet forgedData();
  Packet fragment();
  Packet heartbeatOrGap();
  Packet wantAgain();
  Packet interpreter();
  void endOnTime();

  void send(const Packet& packet, std::uint16_t port);

  int domain_;
  std::mt19937_64 random_;
  Foothold foothold_;
  Prefix own_;
  std::vector<Neighbour> neighbours_;
  Neighbour target_;
  std::uint64_t sent_ = 0;
  std::uint32_t count_ = 0;
  /// Announced participants, and when they say goodbye.
  std::deque<std::pair<Prefix, std::chrono::steady_clock::time_point>> ends_;
};

}  // namespace pongsim::hostile
