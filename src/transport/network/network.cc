#include "transport/network/network.hh"

#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/participant/RTPSParticipant.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

#include "transport/names/service_name.hh"
#include "transport/payload.hh"
#include "transport/udp/domain.hh"

namespace pongsim::transport {

namespace {

// Not a topic name, since it has no leading slash.
constexpr const char* kCensusTopic = "pongsim/census";
constexpr const char* kCensusType = "pongsim.Census";

// Fast DDS 2.9 compares each new endpoint of a participant with all that it has, which takes 0.2 us each. So the
// thousandth endpoint costs 0.2 ms, and one more participant 3 ms.
constexpr std::size_t kMostEndpoints = 1000;

// `discover` gives up participants that have not answered after this time without any announcement: a new participant
// is silent for some milliseconds, on a busy machine for a second. With other machines, where nobody knows who should
// answer, each call of `discover` lasts this long.
constexpr std::chrono::milliseconds kSilence{2000};
constexpr std::chrono::milliseconds kSilenceOfOthers{500};
constexpr std::chrono::milliseconds kLookAgain{10};

EndpointId endpointId(const rtps::GUID_t& guid) {
  EndpointId id{};
  std::copy_n(std::begin(guid.guidPrefix.value), 12, id.begin());
  std::copy_n(std::begin(guid.entityId.value), 4, id.begin() + 12);
  return id;
}

Participant::Settings chosenSettings(std::optional<int> domain, const std::optional<std::string>& interface) {
  Participant::Settings settings;
  settings.domain = chosenDomain(domain);
  settings.interface = chosenInterface(interface);
  settings.identity = chosenIdentity(settings.domain);
  return settings;
}

}  // namespace

Network::Network(std::optional<int> domain, const std::optional<std::string>& interface, bool announceLater)
    : settings_(chosenSettings(domain, interface)),
      partition_(chosenPartition()),
      reporter_([this](std::function<void()> readersChanged) {
        const Contract contract{TrafficReporter::kTrafficTopic, TrafficReporter::kTrafficType, "", false};
        return std::make_unique<Writer>(first_->rtps(), outbox_, contract, std::move(readersChanged));
      }) {
  for (const char* topic : {kCensusTopic, TrafficReporter::kTrafficTopic}) {
    for (const TopicUse use : {TopicUse::kPublish, TopicUse::kSubscribe}) requirePermission(use, topic);
  }
  rtps::RTPSParticipantListener* const listener = this;
  first_ = std::make_unique<Participant>(settings_, std::nullopt, listener);
  participants_.push_back({first_.get()});
  if (!announceLater) announce();
  censusWriter_ =
      std::make_unique<Writer>(first_->rtps(), outbox_, Contract{kCensusTopic, kCensusType, "", true}, nullptr);
  changeCensus(0);
}

Network::~Network() {
  first_->endListening();
  reporter_.stop();
  more_.clear();
  censusReader_.reset();
  censusWriter_.reset();
  first_.reset();
}

void Network::announce() {
  const Lock lock(mutex_);
  for (const Place& each : participants_) each.participant->announce();
}

void Network::requirePermission(TopicUse use, const std::string& topic) const {
  const std::optional<SecureIdentity>& identity = settings_.identity;
  if (!identity || isPermitted(*identity, settings_.domain, use, topic)) return;
  throw KeystoreError("identity '" + identity->name + "' may not " +
                          (use == TopicUse::kPublish ? "publish" : "subscribe to") + " topic '" + topic +
                          "': its permissions in " + identity->folder + " do not allow it",
                      "'pongsim security list' shows what they allow");
}

template <class Make>
auto Network::make(const std::optional<ParticipantId>& at, Make makeIn) {
  Participant& participant = enter(at);
  try {
    auto endpoint = makeIn(participant.rtps());
    changeCensus(1);
    return endpoint;
  } catch (...) {
    leave(participant.id());
    throw;
  }
}

std::unique_ptr<Writer> Network::makeWriter(const std::string& topic, const std::string& type,
                                            std::function<void()> readersChanged,
                                            const std::optional<ParticipantId>& at, Content content) {
  requirePermission(TopicUse::kPublish, topic);
  return make(at, [&](rtps::RTPSParticipant& participant) {
    return std::make_unique<Writer>(participant, outbox_, contract(topic, type, content), std::move(readersChanged));
  });
}

std::unique_ptr<Reader> Network::makeReader(const std::string& topic, const std::string& type,
                                            Reader::Received received, Reader::WriterGone writerGone,
                                            const std::optional<ParticipantId>& at) {
  requirePermission(TopicUse::kSubscribe, topic);
  return make(at, [&](rtps::RTPSParticipant& participant) {
    return std::make_unique<Reader>(participant, contract(topic, type), std::move(received), std::move(writerGone));
  });
}

void Network::end(std::unique_ptr<Writer> writer) { remove(std::move(writer)); }

void Network::end(std::unique_ptr<Reader> reader) { remove(std::move(reader)); }

template <class Each>
void Network::remove(std::unique_ptr<Each> endpoint) {
  const ParticipantId at = endpoint->participant();
  // this first, since it can't throw
  leave(at);
  changeCensus(-1);
  endpoint.reset();
}

/// @return That participant, or one that has few endpoints. It counts one more.
Participant& Network::enter(const std::optional<ParticipantId>& at) {
  const Lock lock(mutex_);
  auto place =
      at ? std::ranges::find(participants_, *at, &Place::id)
         : std::ranges::find_if(participants_, [](const Place& each) { return each.endpoints < kMostEndpoints; });
  if (place == participants_.end()) {
    openAnother();
    place = std::ranges::min_element(participants_, {}, &Place::endpoints);
  }
  ++place->endpoints;
  return *place->participant;
}

void Network::leave(const ParticipantId& at) {
  const Lock lock(mutex_);
  --std::ranges::find(participants_, at, &Place::id)->endpoints;
}

/// Unless there is no room for it on this machine. Finding each other then takes longer, and nothing else is lost.
void Network::openAnother() {
  if (isFull_) return;
  try {
    auto another = std::make_unique<Participant>(settings_, first_->id(), nullptr);
    for (const Place& each : participants_) {
      each.participant->ignore(*another);
      another->ignore(*each.participant);
    }
    participants_.reserve(participants_.size() + 1);
    more_.push_back(std::move(another));
  } catch (const std::exception&) {
    isFull_ = true;
    return;
  }
  participants_.push_back({more_.back().get()});
  if (first_->isAnnounced()) more_.back()->announce();
}

void Network::changeCensus(int endpoints) {
  const Lock lock(mutex_);
  endpoints_ += static_cast<std::uint32_t>(endpoints);
  const auto bytes = std::as_bytes(std::span(&endpoints_, 1));
  try {
    censusWriter_->write(bytes.size(), [&](std::span<std::byte> place) { std::ranges::copy(bytes, place.begin()); });
  } catch (...) {
    // without a census the new endpoint is given up by the caller; one that has ended stays ended
    if (endpoints > 0) endpoints_ -= static_cast<std::uint32_t>(endpoints);
    throw;
  }
}

bool Network::discover(std::chrono::nanoseconds timeout) { return heardAll_ = waitForAll(timeout); }

bool Network::waitForAll(std::chrono::nanoseconds timeout) {
  announce();
  if (!censusReader_) {
    const auto received = [this](const ParticipantId& sender, const Buffer& sample) {
      const auto message = messageInPayload(sample.bytes);
      std::uint32_t endpoints = 0;
      if (!message || message->size() != sizeof(endpoints)) return;
      std::memcpy(&endpoints, message->data(), sizeof(endpoints));
      directory_.setCensus(sender, endpoints);
    };
    censusReader_ = std::make_unique<Reader>(first_->rtps(), Contract{kCensusTopic, kCensusType, "", true}, received);
  }

  const TimePoint deadline = deadlineAfter(timeout);
  const auto silence = settings_.interface ? kSilenceOfOthers : kSilence;
  std::uint64_t version = directory_.version();
  TimePoint silentUntil = deadlineAfter(silence);
  for (TimePoint now = std::chrono::steady_clock::now(); now < std::min(deadline, silentUntil);
       now = std::chrono::steady_clock::now()) {
    // unknown with other machines, or if the system does not list ports: then only the silence ends the wait
    const auto open = settings_.interface ? std::nullopt : openDiscoveryPorts(settings_.domain);
    std::vector<std::uint32_t> ports;
    if (!open) ports.push_back(0);
    for (const OpenPort& each : open.value_or(std::vector<OpenPort>())) {
      if (each.isOnLoopbackAlone && !isOwnPort(each.port)) ports.push_back(each.port);
    }
    if (directory_.waitForAll(ports, std::min(deadline, now + kLookAgain))) return true;
    if (const std::uint64_t newVersion = directory_.version(); newVersion != version) {
      version = newVersion;
      silentUntil = deadlineAfter(silence);
    }
  }
  // unknown with other machines; a caller with such a short timeout will call again
  return settings_.interface || timeout < silence;
}

void Network::watchTraffic(std::chrono::nanoseconds duration) {
  announce();
  directory_.forgetTraffic();
  const auto received = [this](const ParticipantId& sender, const Buffer& sample) {
    const auto message = messageInPayload(sample.bytes);
    std::optional<TrafficReport> report = message ? readTraffic(*message) : std::nullopt;
    if (report) directory_.setTraffic(sender, *std::move(report));
  };
  const Contract contract{TrafficReporter::kTrafficTopic, TrafficReporter::kTrafficType, "", false};
  const Reader reader(first_->rtps(), contract, received);
  std::this_thread::sleep_until(deadlineAfter(duration));
}

bool Network::isOwnPort(std::uint32_t port) const {
  const Lock lock(mutex_);
  return std::ranges::any_of(participants_, [port](const Place& each) { return each.participant->port() == port; });
}

void Network::onParticipantDiscovery(rtps::RTPSParticipant*, rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  const ParticipantId id = participantId(info.info.m_guid.guidPrefix);
  if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT) {
    directory_.removeParticipant(id);
    return;
  }
  std::vector<std::uint32_t> ports;
  for (const rtps::Locator_t& locator : info.info.metatraffic_locators.unicast) ports.push_back(locator.port);
  const ParticipantName name = readParticipantName(info.info.m_participantName.c_str());
  directory_.addParticipant(id, name.pid, std::move(ports), name.first);
}

template <class ProxyData>
void Network::endpointChanged(const rtps::RTPSParticipant& own, const ProxyData& data, Role role, bool removed) {
  if (data.guid().guidPrefix == own.getGuid().guidPrefix) return;
  const EndpointId id = endpointId(data.guid());
  if (removed) {
    directory_.removeEndpoint(id);
    return;
  }
  const std::string topic = data.topicName().c_str();
  if (topic == kCensusTopic) return;
  if (topic == TrafficReporter::kTrafficTopic) {
    if (role == Role::kSubscriber) reporter_.ask();
    return;
  }
  const std::vector<std::string> partitions = data.m_qos.m_partition.getNames();
  const bool samePartition = partition_.empty() ? partitions.empty() : std::ranges::count(partitions, partition_) > 0;
  directory_.addEndpoint(id, {topic, data.typeName().c_str(), role,
                              samePartition && (topic.starts_with('/') || serviceOfRequestTopic(topic))});
}

void Network::onReaderDiscovery(rtps::RTPSParticipant* own, rtps::ReaderDiscoveryInfo&& info) {
  endpointChanged(*own, info.info, Role::kSubscriber, info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER);
}

void Network::onWriterDiscovery(rtps::RTPSParticipant* own, rtps::WriterDiscoveryInfo&& info) {
  endpointChanged(*own, info.info, Role::kPublisher, info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER);
}

}  // namespace pongsim::transport
