#include "transport/network/participant.hh"

#include <fastdds/rtps/RTPSDomain.h>
#include <fastdds/rtps/attributes/RTPSParticipantAttributes.h>
#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <fastrtps/utils/IPLocator.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "base/parse_number.hh"
#include "shared/rtps/rtps_message.hh"
#include "shared/threads/scheduling.hh"
#include "shared/wire/create_participant.hh"
#include "transport/deadline.hh"
#include "transport/udp/domain.hh"

namespace pongsim::transport {

namespace {

using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using eprosima::fastrtps::Duration_t;

constexpr const char* kLoopback = "127.0.0.1";
// Where participants are looked for on other machines (RTPS 9.6.1.1.3).
constexpr const char* kMulticastGroup = "239.255.0.1";

constexpr std::string_view kNamePrefix = shared::kPongsimName;
constexpr std::string_view kHexDigits = "0123456789abcdef";

// The kernel gives what net.core.rmem_max and wmem_max allow: an image needs room for all of its packets at once.
constexpr std::uint32_t kSocketBuffer = 4 << 20;

// How long a process that died without a goodbye stays known.
const Duration_t kLease{6, 0};
const Duration_t kAnnouncementPeriod{2, 0};

// Less than the silence after which others give up a participant whose port is open (`Network::discover`).
constexpr std::chrono::seconds kAnnounceBy{1};

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

rtps::RTPSParticipantAttributes participantAttributes(const Participant::Settings& settings, const std::string& name,
                                                      const std::shared_ptr<UdpGate>& gate) {
  const auto& [domain, interface, identity] = settings;
  rtps::RTPSParticipantAttributes attributes;
  attributes.setName(name.c_str());
  attributes.useBuiltinTransports = false;
  attributes.userTransports.push_back(udpOn(kLoopback, GatedUdp::Side::kLoopback, domain, gate));
  attributes.sendSocketBufferSize = kSocketBuffer;
  attributes.listenSocketBufferSize = kSocketBuffer;

  // with a single port to listen at, the library joins no multicast group
  const rtps::Locator_t own = locatorOf(interface ? interface->address : kLoopback);
  attributes.defaultUnicastLocatorList.push_back(own);
  attributes.builtin.metatrafficUnicastLocatorList.push_back(own);
  attributes.builtin.initialPeersList.push_back(locatorOf(kLoopback));
  if (interface) {
    attributes.userTransports.push_back(udpOn(interface->address, GatedUdp::Side::kNetwork, domain, gate));
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
    for (const auto& [property, value] : securityProperties(*identity)) {
      attributes.properties.properties().emplace_back(property, value);
    }
  }
  return attributes;
}

void removeParticipant(rtps::RTPSParticipant* participant) { rtps::RTPSDomain::removeRTPSParticipant(participant); }

}  // namespace

std::string textOf(const ParticipantName& name) {
  std::string text = std::string(kNamePrefix) + std::to_string(name.pid);
  if (!name.first) return text;
  text += '/';
  for (const std::uint8_t byte : *name.first) {
    text += kHexDigits[byte >> 4];
    text += kHexDigits[byte & 15];
  }
  return text;
}

ParticipantName readParticipantName(std::string_view text) {
  if (!text.starts_with(kNamePrefix)) return {};
  text.remove_prefix(kNamePrefix.size());
  ParticipantName name;
  const std::size_t slash = text.find('/');
  name.pid = static_cast<int>(base::parseInteger(text.substr(0, slash)).value_or(0));
  if (slash == std::string_view::npos) return name;
  text.remove_prefix(slash + 1);
  ParticipantId first{};
  if (text.size() != 2 * first.size()) return {};
  for (std::size_t i = 0; i < first.size(); ++i) {
    const char* const digits = text.data() + 2 * i;
    const auto [end, error] = std::from_chars(digits, digits + 2, first[i], 16);
    if (error != std::errc() || end != digits + 2) return {};
  }
  name.first = first;
  return name;
}

Participant::Participant(const Settings& settings, const std::optional<ParticipantId>& first,
                         rtps::RTPSParticipantListener* listener)
    : listener_(listener), gate_(std::make_shared<UdpGate>(settings.domain)), participant_(nullptr, removeParticipant) {
  // with DDS's threads
  const shared::BatchScheduling scheduling;
  participant_.reset(shared::createParticipant(static_cast<std::uint32_t>(settings.domain),
                                               participantAttributes(settings, textOf({getpid(), first}), gate_), this,
                                               discoveryPorts(settings.domain).count));
  if (participant_ == nullptr) {
    throw std::runtime_error(
        "can't open DDS domain " + std::to_string(settings.domain) + " on 127.0.0.1" +
        (settings.interface ? " and " + settings.interface->address : "") +
        (settings.identity ? " as identity '" + settings.identity->name + "' of " + settings.identity->folder : ""));
  }
  id_ = participantId(participant_->getGuid().guidPrefix);
  port_ = participant_->getRTPSParticipantAttributes().builtin.metatrafficUnicastLocatorList.begin()->port;
  participant_->enable();
  gate_->startThread(deadlineAfter(kAnnounceBy), [this] { announce(); });
}

Participant::~Participant() {
  endListening();
  gate_->close();
}

void Participant::announce() {
  if (gate_->isOpen.exchange(true)) return;
  participant_->announceRTPSParticipantState();
}

void Participant::ignore(const Participant& other) {
  gate_->filter.ignore(other.id_, other.port_);
  gate_->announcements.ignore(other.port_);
}

void Participant::endListening() { participant_->set_listener(nullptr); }

void Participant::onParticipantDiscovery(rtps::RTPSParticipant* participant, rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  const ParticipantId id = participantId(info.info.m_guid.guidPrefix);
  if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT) {
    gate_->filter.removed(id);
  } else {
    gate_->filter.discovered(id, std::chrono::steady_clock::now());
  }
  if (info.status == Info::DISCOVERED_PARTICIPANT) {
    for (const rtps::Locator_t& locator : info.info.metatraffic_locators.unicast) {
      // the library answers it with an announcement after this call
      gate_->announcements.discovered(locator.port);
    }
  }
  if (listener_ != nullptr) listener_->onParticipantDiscovery(participant, std::move(info));
}

void Participant::onReaderDiscovery(rtps::RTPSParticipant* participant, rtps::ReaderDiscoveryInfo&& info) {
  if (listener_ != nullptr) listener_->onReaderDiscovery(participant, std::move(info));
}

void Participant::onWriterDiscovery(rtps::RTPSParticipant* participant, rtps::WriterDiscoveryInfo&& info) {
  if (listener_ != nullptr) listener_->onWriterDiscovery(participant, std::move(info));
}

}  // namespace pongsim::transport
