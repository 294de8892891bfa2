#pragma once

#include <fastdds/rtps/participant/RTPSParticipantListener.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "pongsim/program/keystore.hh"
#include "transport/network/directory.hh"
#include "transport/network/endpoint.hh"
#include "transport/network/outbox.hh"
#include "transport/network/traffic_reporter.hh"
#include "transport/udp/gated_udp.hh"
#include "transport/udp/interfaces.hh"

namespace pongsim::transport {

/// A participant in a DDS domain: over UDP on 127.0.0.1 only, unless it also communicates with other machines over one
/// network interface.
///
/// Each participant listens on one of the domain's known ports and announces itself to all of them, so that nothing is
/// multicast on this machine. Beside its topics, each publishes its number of endpoints (census). Discovery compares
/// the open ports of this machine with the participants that have answered, and their endpoints with their census, and
/// so knows when it is complete.
class Network : private rtps::RTPSParticipantListener {
 public:
  /// @param interface Name or address of the interface for other machines, as for `chosenInterface`.
  /// @throws std::runtime_error if the network can't be opened, std::invalid_argument for an invalid domain or
  /// interface, KeystoreError if the identity in PONGSIM_SECURITY can't be used.
  /// @param announceLater Others do not learn of this participant before `announce`, or for a second.
  explicit Network(std::optional<int> domain, const std::optional<std::string>& interface = std::nullopt,
                   bool announceLater = false);
  ~Network() override;
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// Lets others learn of this participant, if they have not yet. Everything that waits for them calls it. Thread-safe.
  void announce();

  Directory& directory() { return directory_; }
  const ParticipantId& id() const { return own_; }
  /// @return The network interface for other machines, if any.
  const std::optional<NetworkInterface>& interface() const { return interface_; }

  /// @throws KeystoreError if the identity may not use the topic in this way.
  void requirePermission(TopicUse use, const std::string& topic) const;

  /// @throws KeystoreError like `requirePermission`; std::runtime_error if DDS refuses.
  std::unique_ptr<Writer> makeWriter(const std::string& topic, const std::string& type,
                                     std::function<void()> readersChanged);
  std::unique_ptr<Reader> makeReader(const std::string& topic, const std::string& type, Reader::Received received,
                                     Reader::WriterGone writerGone = {});
  void end(std::unique_ptr<Writer> writer);
  void end(std::unique_ptr<Reader> reader);

  /// Waits until all participants on this machine have announced their endpoints, at most `timeout`. A silent one (it
  /// may be suspended) is not waited for once the others have been silent for a while too.
  /// @return Whether all of them have; true where that can't be said: other machines take part, or the timeout is
  /// shorter than a busy process may be silent.
  bool discover(std::chrono::nanoseconds timeout);

  /// @param source Reports this process's traffic when others ask. It is not called any more after another one was set.
  void reportTraffic(std::function<TrafficReport()> source) { reporter_.setSource(std::move(source)); }

  /// Asks others for their traffic for `duration`, for the directory.
  void watchTraffic(std::chrono::nanoseconds duration);

 private:
  void onParticipantDiscovery(rtps::RTPSParticipant* participant, rtps::ParticipantDiscoveryInfo&& info) override;
  void onReaderDiscovery(rtps::RTPSParticipant* participant, rtps::ReaderDiscoveryInfo&& info) override;
  void onWriterDiscovery(rtps::RTPSParticipant* participant, rtps::WriterDiscoveryInfo&& info) override;

  template <class ProxyData>
  void endpointChanged(const ProxyData& data, Role role, bool removed);
  void changeCensus(int endpoints);
  Contract contract(const std::string& topic, const std::string& type) const { return {topic, type, partition_}; }

  int domain_;
  std::string partition_;
  std::optional<NetworkInterface> interface_;
  std::optional<SecureIdentity> identity_;
  Directory directory_;
  std::shared_ptr<UdpGate> gate_;
  std::unique_ptr<rtps::RTPSParticipant, void (*)(rtps::RTPSParticipant*)> participant_;
  ParticipantId own_{};
  std::uint32_t ownPort_ = 0;
  Outbox outbox_;
  TrafficReporter reporter_;
  std::mutex censusMutex_;
  std::uint32_t endpoints_ = 0;
  std::unique_ptr<Writer> censusWriter_;
  std::unique_ptr<Reader> censusReader_;
};

}  // namespace pongsim::transport
