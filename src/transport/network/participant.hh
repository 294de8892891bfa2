#pragma once

#include <fastdds/rtps/participant/RTPSParticipant.h>
#include <fastdds/rtps/participant/RTPSParticipantListener.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/program/keystore.hh"
#include "transport/network/endpoint.hh"
#include "transport/udp/gated_udp.hh"
#include "transport/udp/interfaces.hh"

namespace pongsim::transport {

/// What participants announce as their name.
struct ParticipantName {
  /// Process id; 0 for another program's.
  int pid = 0;
  /// The first participant of the same `Network`, where it is not the first itself.
  std::optional<ParticipantId> first;

  bool operator==(const ParticipantName&) const = default;
};
std::string textOf(const ParticipantName& name);
ParticipantName readParticipantName(std::string_view text);

/// A participant in a DDS domain, over UDP on 127.0.0.1 and perhaps one network interface for other machines.
class Participant : private rtps::RTPSParticipantListener {
 public:
  struct Settings {
    int domain = 0;
    std::optional<NetworkInterface> interface;
    std::optional<SecureIdentity> identity;
  };

  /// Others do not learn of it before `announce`, or for a second.
  /// @param first The first participant of the same `Network`, if there is one.
  /// @param listener Is told of others, on DDS's threads; null: nobody.
  /// @throws std::runtime_error if the domain can't be opened.
  Participant(const Settings& settings, const std::optional<ParticipantId>& first,
              rtps::RTPSParticipantListener* listener);
  ~Participant() override;
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// Lets others learn of this participant, if they have not yet. Thread-safe.
  void announce();
  bool isAnnounced() const { return gate_->isOpen; }

  /// Neither hears the other from now on, nor speaks to it.
  void ignore(const Participant& other);

  /// Tells the listener nothing any more.
  void endListening();

  const ParticipantId& id() const { return id_; }
  /// @return The port at which others find it.
  std::uint32_t port() const { return port_; }
  rtps::RTPSParticipant& rtps() { return *participant_; }

 private:
  void onParticipantDiscovery(rtps::RTPSParticipant* participant, rtps::ParticipantDiscoveryInfo&& info) override;
  void onReaderDiscovery(rtps::RTPSParticipant* participant, rtps::ReaderDiscoveryInfo&& info) override;
  void onWriterDiscovery(rtps::RTPSParticipant* participant, rtps::WriterDiscoveryInfo&& info) override;

  rtps::RTPSParticipantListener* listener_;
  std::shared_ptr<UdpGate> gate_;
  std::unique_ptr<rtps::RTPSParticipant, void (*)(rtps::RTPSParticipant*)> participant_;
  ParticipantId id_{};
  std::uint32_t port_ = 0;
};

}  // namespace pongsim::transport
