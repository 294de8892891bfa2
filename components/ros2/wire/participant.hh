#pragma once

#include <fastdds/rtps/participant/RTPSParticipantListener.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ros2/wire/endpoint.hh"
#include "ros2/wire/graph.hh"
#include "ros2/wire/reader.hh"
#include "ros2/wire/writer.hh"

namespace pongsim::ros2 {

/// The last domain that leaves participants ports below 65536 (RTPS 9.6.1.1).
inline constexpr int kLastDomain = 232;

struct ParticipantOptions {
  /// 0 to `kLastDomain`.
  int domain = 0;
  /// Whether the nodes keep to this machine, and may listen at 127.0.0.1 alone (ROS_LOCALHOST_ONLY).
  bool isLoopbackOnly = false;
  /// Whether nobody is met (ROS_AUTOMATIC_DISCOVERY_RANGE=OFF).
  bool isAlone = false;
  /// Addresses of machines that are asked for nodes although they may not receive multicast (ROS_STATIC_PEERS); those
  /// that can't be reached are skipped.
  std::vector<std::string> staticPeers = {};
  /// Name or address of the network interface by which other machines are talked to; unset: none is.
  std::optional<std::string> interface = std::nullopt;
};

/// One participant of a DDS domain.
class Participant final : private rtps::RTPSParticipantListener {
 public:
  /// @throws std::runtime_error where the network can't be had, std::invalid_argument for a bad domain or interface.
  explicit Participant(const ParticipantOptions& options);
  ~Participant() override;
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  const Guid& id() const { return id_; }
  /// What the others offer.
  const Graph& graph() const { return graph_; }

  /// @param readersChanged Called from a DDS thread when a reader comes or goes.
  /// @param isFor See `Writer`.
  std::unique_ptr<Writer> makeWriter(const Contract& contract, std::function<void()> readersChanged = {},
                                     Writer::IsFor isFor = {});
  std::unique_ptr<Reader> makeReader(const Contract& contract, Reader::Received received);

 private:
  void onParticipantDiscovery(rtps::RTPSParticipant* participant, rtps::ParticipantDiscoveryInfo&& info) override;
  void onReaderDiscovery(rtps::RTPSParticipant* participant, rtps::ReaderDiscoveryInfo&& info) override;
  void onWriterDiscovery(rtps::RTPSParticipant* participant, rtps::WriterDiscoveryInfo&& info) override;
  template <class ProxyData>
  void endpointChanged(const ProxyData& data, Graph::Role role, bool isRemoved);

  ParticipantOptions options_;
  Graph graph_;
  /// Each writer has its own limit.
  shared::Outbox outbox_{{shared::Outbox::kUnlimited, shared::Outbox::kUnlimited}};
  Guid id_;
  rtps::RTPSParticipant* participant_ = nullptr;
};

}  // namespace pongsim::ros2
