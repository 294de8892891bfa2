#pragma once

#include <fastdds/rtps/participant/RTPSParticipantListener.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/program/keystore.hh"
#include "shared/threads/outbox.hh"
#include "transport/locks.hh"
#include "transport/network/directory.hh"
#include "transport/network/endpoint.hh"
#include "transport/network/participant.hh"
#include "transport/network/traffic_reporter.hh"

namespace pongsim::transport {

/// Endpoints in a DDS domain: over UDP on 127.0.0.1 only, unless it also communicates with other machines over one
/// network interface.
///
/// Each participant listens on one of the domain's known ports and announces itself to all of them, so that nothing is
/// multicast on this machine. One participant has all endpoints, unless they are many: then there are more of them,
/// which do not know of each other and name the first.
///
/// Beside its topics, a network publishes its number of endpoints (census). Discovery compares the open ports of this
/// machine with the participants that have answered, and their endpoints with their census, and so knows when it is
/// complete.
class Network : private rtps::RTPSParticipantListener {
 public:
  /// @param interface Name or address of the interface for other machines, as for `chosenInterface`.
  /// @throws std::runtime_error if the network can't be opened, std::invalid_argument for an invalid domain or
  /// interface, KeystoreError if the identity in PONGSIM_SECURITY can't be used.
  /// @param announceLater Others do not learn of it before `announce`, or for a second.
  explicit Network(std::optional<int> domain, const std::optional<std::string>& interface = std::nullopt,
                   bool announceLater = false);
  ~Network() override;
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  /// Lets others learn of this network, if they have not yet. Everything that waits for them calls it. Thread-safe.
  void announce();

  Directory& directory() { return directory_; }
  /// @return The network interface for other machines, if any.
  const std::optional<NetworkInterface>& interface() const { return settings_.interface; }

  /// @throws KeystoreError if the identity may not use the topic in this way.
  void requirePermission(TopicUse use, const std::string& topic) const;

  /// @param at The participant of an endpoint that it belongs together with; nothing: any.
  /// @throws KeystoreError like `requirePermission`; std::runtime_error if DDS refuses.
  std::unique_ptr<Writer> makeWriter(const std::string& topic, const std::string& type,
                                     std::function<void()> readersChanged,
                                     const std::optional<ParticipantId>& at = std::nullopt,
                                     Content content = Content::kMessages);
  std::unique_ptr<Reader> makeReader(const std::string& topic, const std::string& type, Reader::Received received,
                                     Reader::WriterGone writerGone = {},
                                     const std::optional<ParticipantId>& at = std::nullopt);
  void end(std::unique_ptr<Writer> writer);
  void end(std::unique_ptr<Reader> reader);

  /// Waits until all participants on this machine have announced their endpoints, at most `timeout`. A silent one (it
  /// may be suspended) is not waited for once the others have been silent for a while too.
  /// @return Whether all of them have; true where that can't be said: other machines take part, or the timeout is
  /// shorter than a busy process may be silent.
  bool discover(std::chrono::nanoseconds timeout);
  /// @return What `discover` last returned; true before.
  bool heardAll() const { return heardAll_; }

  /// @param source Reports this process's traffic when others ask. It is not called any more after another one was set.
  void reportTraffic(std::function<TrafficReport()> source) { reporter_.setSource(std::move(source)); }

  /// Asks others for their traffic for `duration`, for the directory.
  void watchTraffic(std::chrono::nanoseconds duration);

 private:
  void onParticipantDiscovery(rtps::RTPSParticipant* participant, rtps::ParticipantDiscoveryInfo&& info) override;
  void onReaderDiscovery(rtps::RTPSParticipant* participant, rtps::ReaderDiscoveryInfo&& info) override;
  void onWriterDiscovery(rtps::RTPSParticipant* participant, rtps::WriterDiscoveryInfo&& info) override;

  /// A participant and how many endpoints it has.
  struct Place {
    Participant* participant = nullptr;
    std::size_t endpoints = 0;

    const ParticipantId& id() const { return participant->id(); }
  };

  template <class Make>
  auto make(const std::optional<ParticipantId>& at, Make makeIn);
  template <class Each>
  void remove(std::unique_ptr<Each> endpoint);
  Participant& enter(const std::optional<ParticipantId>& at);
  void leave(const ParticipantId& at);
  void openAnother() REQUIRES(mutex_);
  bool isOwnPort(std::uint32_t port) const;
  template <class ProxyData>
  void endpointChanged(const rtps::RTPSParticipant& own, const ProxyData& data, Role role, bool removed);
  void changeCensus(int endpoints);
  bool waitForAll(std::chrono::nanoseconds timeout);
  Contract contract(const std::string& topic, const std::string& type, Content content = Content::kMessages) const {
    return {topic, type, partition_, false, content};
  }

  Participant::Settings settings_;
  std::string partition_;
  Directory directory_;
  std::unique_ptr<Participant> first_;
  mutable Mutex mutex_;
  std::vector<std::unique_ptr<Participant>> more_ GUARDED_BY(mutex_);
  /// The first and the others.
  std::vector<Place> participants_ GUARDED_BY(mutex_);
  bool isFull_ GUARDED_BY(mutex_) = false;
  /// Of all participants.
  std::uint32_t endpoints_ GUARDED_BY(mutex_) = 0;
  std::atomic<bool> heardAll_ = true;
  shared::Outbox outbox_{shared::Outbox::Limits{}};
  TrafficReporter reporter_;
  std::unique_ptr<Writer> censusWriter_;
  std::unique_ptr<Reader> censusReader_;
};

}  // namespace pongsim::transport
