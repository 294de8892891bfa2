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

/// What the messages of an attack have in common. All of them are well formed, or nearly.
enum class Attack {
  /// Participants with fresh GUIDs: odd leases, locators of others, of third parties, of groups, of port 0.
  kParticipants,
  /// The same, each from a socket of its own.
  kSockets,
  /// Messages in the name of participants that are there: their end, their endpoints' end, other addresses for them.
  kForgedParticipants,
  /// A participant with endless endpoints, enormous names, other types for known topics.
  kEndpoints,
  /// Endpoints whose parameters have wrong lengths, no end, come twice or are unknown.
  kParameters,
  /// Samples in the name of writers that are there, of numbers far ahead.
  kForgedData,
  /// A publisher whose samples are of gigabytes, in few fragments that overlap.
  kFragments,
  /// Heartbeats and gaps in the name of writers, over all numbers there are.
  kHeartbeats,
  /// Readers, forged and the attacker's own, that want everything again.
  kAckNacks,
  /// Changes of source, destination and time within a message, and submessages of DDS-Security.
  kInterpreter,
  /// Participants that say that they end at the moment at which their lease does.
  kLeases
};

/// @return All attacks by their names.
std::span<const std::pair<std::string_view, Attack>> attacks();
std::optional<Attack> attackOf(std::string_view name);

/// Strikes at all participants of a domain of this machine. The same seed and neighbours make the same messages.
class Attacker {
 public:
  Attacker(int domain, std::uint64_t seed);

  /// Looks for participants, for up to `atMost`.
  /// @return How many are known.
  std::size_t look(std::chrono::milliseconds atMost);

  /// Sends one message.
  void strike(Attack attack);

  std::uint64_t sent() const { return sent_; }

 private:
  /// @return A number from 0 to `end`, without it.
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
  /// Participants that have been announced, and when they end.
  std::deque<std::pair<Prefix, std::chrono::steady_clock::time_point>> ends_;
};

}  // namespace pongsim::hostile
