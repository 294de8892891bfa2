#pragma once

#include <fastdds/rtps/participant/RTPSParticipantListener.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "transport/directory.hh"
#include "transport/endpoint.hh"
#include "transport/interfaces.hh"
#include "transport/outbox.hh"
#include "transport/traffic_reporter.hh"

namespace pongsim::transport {

/// This transport among the others of a DDS domain: over UDP on 127.0.0.1 and by no other way, unless it is to talk to
/// other machines by one of this machine's network interfaces.
///
/// Each participant listens at one of the domain's known ports and announces itself at all of them, so that nothing
/// is multicast on this machine. Beside the topics, each one publishes how many endpoints it has (its census): who
/// looks for topics compares the ports that are open on this machine with the participants that have answered, and the
/// endpoints that they have told of with their census, and so knows when it has them all.
class Network : private rtps::RTPSParticipantListener {
 public:
  /// @param interface Name or address of the interface for other machines, as `chosenInterface` has it.
  /// @throws std::runtime_error where the network can't be had, std::invalid_argument for a bad domain or interface.
  explicit Network(std::optional<int> domain, const std::optional<std::string>& interface = std::nullopt);
  ~Network() override;
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  Directory& directory() { return directory_; }
  const ParticipantId& id() const { return own_; }
  /// @return Where it talks to other machines; nothing: nowhere.
  const std::optional<NetworkInterface>& interface() const { return interface_; }

  std::unique_ptr<Writer> makeWriter(const std::string& topic, const std::string& type,
                                     std::function<void()> readersChanged);
  std::unique_ptr<Reader> makeReader(const std::string& topic, const std::string& type, Reader::Received received,
                                     Reader::WriterGone writerGone = {});
  void end(std::unique_ptr<Writer> writer);
  void end(std::unique_ptr<Reader> reader);

  /// Waits until all participants of this machine have told of their endpoints, and no longer than `timeout`. One that
  /// stays silent (it may be stopped) is not waited for when the others have been silent for a while too.
  void discover(std::chrono::nanoseconds timeout);

  /// @param source Says what passes through the topics here, when others ask. It is not called any more when another
  /// one has been set.
  void reportTraffic(std::function<TrafficReport()> source) { reporter_.setSource(std::move(source)); }

  /// Asks the others for so long, for the directory.
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
  Directory directory_;
  rtps::RTPSParticipant* participant_ = nullptr;
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
