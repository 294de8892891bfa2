#include "transport/network/network.hh"

#include <fastdds/rtps/RTPSDomain.h>
#include <fastdds/rtps/attributes/RTPSParticipantAttributes.h>
#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/participant/RTPSParticipant.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <unistd.h>
#include <fastdds/dds/log/Log.hpp>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

#include "base/parse_number.hh"
#include "transport/names/service_name.hh"
#include "transport/payload.hh"
#include "transport/scheduling.hh"
#include "transport/udp/domain.hh"
#include "transport/udp/gated_udp.hh"

namespace pongsim::transport {

namespace {

using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using eprosima::fastrtps::Duration_t;

constexpr const char* kLoopback = "127.0.0.1";
// Where participants are looked for on other machines (RTPS 9.6.1.1.3).
constexpr const char* kMulticastGroup = "239.255.0.1";

constexpr std::string_view kNamePrefix = "pongsim/";

// No topic's name, for it has no leading slash.
constexpr const char* kCensusTopic = "pongsim/census";
constexpr const char* kCensusType = "pongsim.Census";

// The kernel gives what net.core.rmem_max and wmem_max allow: an image needs room for all of its packets at once.
constexpr std::uint32_t kSocketBuffer = 4 << 20;

// How soon a process that died without a word is forgotten.
const Duration_t kLease{6, 0};
const Duration_t kAnnouncementPeriod{2, 0};

// How long nothing new must come before those who have not answered are given up: a participant that is being made says
// nothing for some milliseconds, one on a busy machine for a second. Of other machines nobody knows who should answer,
// and this is how long each look around takes.
constexpr std::chrono::milliseconds kSilence{2000};
constexpr std::chrono::milliseconds kSilenceOfOthers{500};
constexpr std::chrono::milliseconds kLookAgain{10};

// Less than the silence after which others give up a participant whose port is open.
constexpr std::chrono::seconds kAnnounceBy{1};

/// Settings that Fast DDS has once for the whole process.
void setUpLibrary() {
  static const bool once = [] {
    // what it has to say of its own goes to stdout, which is for our output
    eprosima::fastdds::dds::Log::ClearConsumers();
    // endpoints that call into each other across participants do so without care for one that is being destroyed
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
    return true;
  }();
  static_cast<void>(once);
}

rtps::Locator_t locatorOf(const std::string& address) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  rtps::IPLocator::setIPv4(locator, address);
  return locator;
}

std::shared_ptr<GatedUdp> udpOn(const std::string& address, GatedUdp::Side side, int domain,
                                const std::shared_ptr<UdpGate>& gate) {
  const auto udp = std::make_shared<UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {address};
  udp->sendBufferSize = kSocketBuffer;
  udp->receiveBufferSize = kSocketBuffer;
  udp->maxInitialPeersRange = discoveryPorts(domain).count;
  return std::make_shared<GatedUdp>(udp, side, domain, gate);
}

rtps::RTPSParticipantAttributes participantAttributes(int domain, const std::optional<NetworkInterface>& interface,
                                                      const std::optional<SecureIdentity>& identity,
                                                      const std::shared_ptr<UdpGate>& gate) {
  rtps::RTPSParticipantAttributes attributes;
  attributes.setName((std::string(kNamePrefix) + std::to_string(getpid())).c_str());
  attributes.useBuiltinTransports = false;
  attributes.userTransports.push_back(udpOn(kLoopback, GatedUdp::Side::kLoopback, domain, gate));
  attributes.sendSocketBufferSize = kSocketBuffer;
  attributes.listenSocketBufferSize = kSocketBuffer;

  // to listen at one port alone keeps the library from joining its multicast group
  const rtps::Locator_t own = locatorOf(interface ? interface->address : kLoopback);
  attributes.defaultUnicastLocatorList.push_back(own);
  attributes.builtin.metatrafficUnicastLocatorList.push_back(own);
  attributes.builtin.initialPeersList.push_back(locatorOf(kLoopback));
  if (interface) {
    attributes.userTransports.push_back(udpOn(interface->address, GatedUdp::Side::kBeyond, domain, gate));
    rtps::Locator_t group = locatorOf(kMulticastGroup);
    group.port = multicastPort(domain);
    attributes.builtin.metatrafficMulticastLocatorList.push_back(group);
    attributes.builtin.initialPeersList.push_back(group);
  }
  attributes.builtin.mutation_tries = discoveryPorts(domain).count;
  attributes.builtin.use_WriterLivelinessProtocol = false;
  attributes.builtin.discovery_config.leaseDuration = kLease;
  attributes.builtin.discovery_config.leaseDuration_announcementperiod = kAnnouncementPeriod;
  if (identity) {
    for (const auto& [name, value] : securityProperties(*identity)) {
      attributes.properties.properties().emplace_back(name, value);
    }
  }
  return attributes;
}

EndpointId endpointId(const rtps::GUID_t& guid) {
  EndpointId id{};
  std::copy_n(std::begin(guid.guidPrefix.value), 12, id.begin());
  std::copy_n(std::begin(guid.entityId.value), 4, id.begin() + 12);
  return id;
}

void removeParticipant(rtps::RTPSParticipant* participant) { rtps::RTPSDomain::removeRTPSParticipant(participant); }

/// @return The process of a participant of ours, 0 for another program's.
int processOf(std::string_view participantName) {
  if (!participantName.starts_with(kNamePrefix)) return 0;
  return static_cast<int>(base::parseInteger(participantName.substr(kNamePrefix.size())).value_or(0));
}

}  // namespace

Network::Network(std::optional<int> domain, const std::optional<std::string>& interface, bool announceLater)
    : domain_(chosenDomain(domain)),
      partition_(chosenPartition()),
      interface_(chosenInterface(interface)),
      identity_(chosenIdentity(domain_)),
      gate_(std::make_shared<UdpGate>(domain_)),
      participant_(nullptr, removeParticipant),
      reporter_([this](std::function<void()> readersChanged) {
        const Contract contract{TrafficReporter::kTrafficTopic, TrafficReporter::kTrafficType, "", false};
        return std::make_unique<Writer>(*participant_, outbox_, contract, std::move(readersChanged));
      }) {
  setUpLibrary();
  for (const char* topic : {kCensusTopic, TrafficReporter::kTrafficTopic}) {
    for (const TopicUse use : {TopicUse::kPublish, TopicUse::kSubscribe}) requirePermission(use, topic);
  }
  const auto domainId = static_cast<std::uint32_t>(domain_);
  // with DDS's threads
  const GivesWay givesWay;
  participant_.reset(rtps::RTPSDomain::createParticipant(
      domainId, false, participantAttributes(domain_, interface_, identity_, gate_), this));
  if (participant_ == nullptr) {
    throw std::runtime_error("cannot open DDS domain " + std::to_string(domain_) + " on 127.0.0.1" +
                             (interface_ ? " and " + interface_->address : "") +
                             (identity_ ? " as identity '" + identity_->name + "' of " + identity_->folder : ""));
  }
  own_ = participantId(participant_->getGuid().guidPrefix);
  ownPort_ = participant_->getRTPSParticipantAttributes().builtin.metatrafficUnicastLocatorList.begin()->port;
  participant_->enable();
  gate_->watch(deadlineAfter(kAnnounceBy), [this] { announce(); });
  if (!announceLater) announce();
  censusWriter_ =
      std::make_unique<Writer>(*participant_, outbox_, Contract{kCensusTopic, kCensusType, "", true}, nullptr);
  changeCensus(0);
}

Network::~Network() {
  participant_->set_listener(nullptr);
  reporter_.stop();
  censusReader_.reset();
  censusWriter_.reset();
  gate_->close();
  participant_.reset();
}

void Network::announce() {
  if (gate_->isOpen.exchange(true)) return;
  participant_->announceRTPSParticipantState();
}

void Network::requirePermission(TopicUse use, const std::string& topic) const {
  if (!identity_ || isPermitted(*identity_, domain_, use, topic)) return;
  throw KeystoreError("identity '" + identity_->name + "' may not " +
                          (use == TopicUse::kPublish ? "publish" : "subscribe to") + " topic '" + topic +
                          "': its permissions in " + identity_->folder + " do not allow it",
                      "'pongsim security list' shows what they allow");
}

std::unique_ptr<Writer> Network::makeWriter(const std::string& topic, const std::string& type,
                                            std::function<void()> readersChanged) {
  requirePermission(TopicUse::kPublish, topic);
  auto writer = std::make_unique<Writer>(*participant_, outbox_, contract(topic, type), std::move(readersChanged));
  changeCensus(1);
  return writer;
}

std::unique_ptr<Reader> Network::makeReader(const std::string& topic, const std::string& type,
                                            Reader::Received received, Reader::WriterGone writerGone) {
  requirePermission(TopicUse::kSubscribe, topic);
  auto reader =
      std::make_unique<Reader>(*participant_, contract(topic, type), std::move(received), std::move(writerGone));
  changeCensus(1);
  return reader;
}

void Network::end(std::unique_ptr<Writer> writer) {
  changeCensus(-1);
  writer.reset();
}

void Network::end(std::unique_ptr<Reader> reader) {
  changeCensus(-1);
  reader.reset();
}

void Network::changeCensus(int endpoints) {
  const std::lock_guard lock(censusMutex_);
  endpoints_ += static_cast<std::uint32_t>(endpoints);
  const auto bytes = std::as_bytes(std::span(&endpoints_, 1));
  censusWriter_->write(bytes.size(), [&](std::span<std::byte> place) { std::ranges::copy(bytes, place.begin()); });
}

bool Network::discover(std::chrono::nanoseconds timeout) {
  announce();
  if (!censusReader_) {
    const auto received = [this](const ParticipantId& sender, const Buffer& sample) {
      const auto message = messageInPayload(sample.bytes);
      std::uint32_t endpoints = 0;
      if (!message || message->size() != sizeof(endpoints)) return;
      std::memcpy(&endpoints, message->data(), sizeof(endpoints));
      directory_.setCensus(sender, endpoints);
    };
    censusReader_ = std::make_unique<Reader>(*participant_, Contract{kCensusTopic, kCensusType, "", true}, received);
  }

  const TimePoint deadline = deadlineAfter(timeout);
  const auto silence = interface_ ? kSilenceOfOthers : kSilence;
  std::uint64_t version = directory_.version();
  TimePoint silentUntil = deadlineAfter(silence);
  for (TimePoint now = std::chrono::steady_clock::now(); now < std::min(deadline, silentUntil);
       now = std::chrono::steady_clock::now()) {
    // where nobody tells who is there, as for other machines, the silence alone must do
    const auto open = interface_ ? std::nullopt : openDiscoveryPorts(domain_);
    std::vector<std::uint32_t> ports;
    if (!open) ports.push_back(0);
    for (const OpenPort& each : open.value_or(std::vector<OpenPort>())) {
      if (each.isOnLoopbackAlone && each.port != ownPort_) ports.push_back(each.port);
    }
    if (directory_.waitForAll(ports, std::min(deadline, now + kLookAgain))) return true;
    if (const std::uint64_t newVersion = directory_.version(); newVersion != version) {
      version = newVersion;
      silentUntil = deadlineAfter(silence);
    }
  }
  // of other machines nobody knows who should have answered, and who looks for so short a time will look again
  return interface_ || timeout < silence;
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
  const Reader reader(*participant_, contract, received);
  std::this_thread::sleep_until(deadlineAfter(duration));
}

void Network::onParticipantDiscovery(rtps::RTPSParticipant*, rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  const ParticipantId id = participantId(info.info.m_guid.guidPrefix);
  if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT) {
    directory_.removeParticipant(id);
    gate_->doorkeeper.removed(id);
    return;
  }
  gate_->doorkeeper.discovered(id, std::chrono::steady_clock::now());
  std::vector<std::uint32_t> ports;
  for (const rtps::Locator_t& locator : info.info.metatraffic_locators.unicast) {
    ports.push_back(locator.port);
    // it gets an announcement in return when this call is over
    if (info.status == Info::DISCOVERED_PARTICIPANT) gate_->announcements.met(locator.port);
  }
  directory_.addParticipant(id, processOf(info.info.m_participantName.c_str()), std::move(ports));
}

template <class ProxyData>
void Network::endpointChanged(const ProxyData& data, Role role, bool removed) {
  if (participantId(data.guid().guidPrefix) == own_) return;
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

void Network::onReaderDiscovery(rtps::RTPSParticipant*, rtps::ReaderDiscoveryInfo&& info) {
  endpointChanged(info.info, Role::kSubscriber, info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER);
}

void Network::onWriterDiscovery(rtps::RTPSParticipant*, rtps::WriterDiscoveryInfo&& info) {
  endpointChanged(info.info, Role::kPublisher, info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER);
}

}  // namespace pongsim::transport
