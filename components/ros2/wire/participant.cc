#include "ros2/wire/participant.hh"

#include <fastdds/rtps/RTPSDomain.h>
#include <fastdds/rtps/attributes/RTPSParticipantAttributes.h>
#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/participant/RTPSParticipant.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <fastrtps/utils/IPLocator.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string_view>

#include "ros2/wire/fast_dds.hh"
#include "ros2/wire/local_udp.hh"
#include "ros2/wire/security.hh"
#include "shared/rtps/rtps_message.hh"
#include "shared/wire/create_participant.hh"

namespace pongsim::ros2 {

namespace {

using eprosima::fastrtps::Duration_t;

// Time after which a process that died silently is removed.
const Duration_t kLease{10, 0};
// Announcements are repeated often, because Fast DDS answers a new participant only once, and the answer may be lost.
const Duration_t kAnnouncementPeriod{0, 500'000'000};
// Maximum number of participants on this machine that can find a port.
constexpr std::uint32_t kParticipants = 115;

rtps::Locator_t locatorOf(const char* address) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  locator.port = 0;
  rtps::IPLocator::setIPv4(locator, address);
  return locator;
}

rtps::RTPSParticipantAttributes attributesOf(const ParticipantOptions& options,
                                             const std::optional<SecureIdentity>& identity,
                                             const std::shared_ptr<std::atomic<bool>>& isOpen) {
  rtps::RTPSParticipantAttributes attributes;
  attributes.useBuiltinTransports = false;
  Reach reach = reachOf(options.isLoopbackOnly, options.interface);
  reach.isNobody = options.isAlone;
  attributes.userTransports.push_back(std::make_shared<LocalUdp>(reach, isOpen));
  // participants that do not receive multicast are looked for on 127.0.0.1
  attributes.builtin.initialPeersList.push_back(locatorOf("239.255.0.1"));
  attributes.builtin.initialPeersList.push_back(locatorOf("127.0.0.1"));
  for (const std::string& peer : options.staticPeers) {
    const auto addresses = rtps::IPLocator::resolveNameDNS(peer).first;
    if (!addresses.empty()) attributes.builtin.initialPeersList.push_back(locatorOf(addresses.begin()->c_str()));
  }
  attributes.builtin.mutation_tries = kParticipants;
  // rmw names participants by their enclave
  const std::string enclave = identity ? identity->name : "/";
  attributes.setName(enclave.c_str());
  // identifies a ROS participant to peers; the terminating zero is part of it
  const std::string userData = "enclave=" + enclave + ";" + std::string(shared::kPongsimRosMark) + '\0';
  attributes.userData.assign(userData.begin(), userData.end());
  if (identity) {
    for (const auto& [name, value] : securityProperties(*identity)) {
      attributes.properties.properties().emplace_back(name, value);
    }
  }
  attributes.builtin.use_WriterLivelinessProtocol = true;
  attributes.builtin.discovery_config.leaseDuration = kLease;
  attributes.builtin.discovery_config.leaseDuration_announcementperiod = kAnnouncementPeriod;
  attributes.builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  attributes.builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  return attributes;
}

/// @return The value of a key in user data such as "typehash=RIHS01_...;clientid=1.2;", or empty.
std::string valueIn(std::string_view userData, std::string_view key) {
  while (!userData.empty()) {
    const std::string_view entry = userData.substr(0, userData.find(';'));
    if (entry.starts_with(key) && entry.substr(key.size()).starts_with('=')) {
      return std::string(entry.substr(key.size() + 1));
    }
    userData.remove_prefix(std::min(entry.size() + 1, userData.size()));
  }
  return {};
}

}  // namespace

Participant::Participant(const ParticipantOptions& options) : options_(options) {
  if (options.domain < 0 || options.domain > kLastDomain) {
    throw std::invalid_argument("ROS_DOMAIN_ID is " + std::to_string(options.domain) + ", not between 0 and 232");
  }
  const std::optional<SecureIdentity> identity = securityOfEnvironment(options.domain).identity;
  const auto isOpen = std::make_shared<std::atomic<bool>>(false);
  participant_ = shared::createParticipant(static_cast<std::uint32_t>(options.domain),
                                           attributesOf(options, identity, isOpen), this, kParticipants);
  if (participant_ == nullptr) {
    throw std::runtime_error("can't open the ROS domain " + std::to_string(options.domain) +
                             (identity ? " as identity '" + identity->name + "'" : ""));
  }
  id_ = guidOf(participant_->getGuid());
  participant_->enable();
  *isOpen = true;
  participant_->announceRTPSParticipantState();
}

Participant::~Participant() {
  participant_->set_listener(nullptr);
  rtps::RTPSDomain::removeRTPSParticipant(participant_);
}

std::unique_ptr<Writer> Participant::makeWriter(const Contract& contract, std::function<void()> readersChanged,
                                                Writer::IsFor isFor) {
  return std::make_unique<Writer>(*participant_, outbox_, contract, std::move(readersChanged), std::move(isFor));
}

std::unique_ptr<Reader> Participant::makeReader(const Contract& contract, Reader::Received received) {
  return std::make_unique<Reader>(*participant_, contract, std::move(received));
}

void Participant::onParticipantDiscovery(rtps::RTPSParticipant*, rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  const Guid id = guidOf(info.info.m_guid);
  if (info.status == Info::REMOVED_PARTICIPANT || info.status == Info::DROPPED_PARTICIPANT) {
    graph_.removeParticipant(id);
  } else {
    graph_.addParticipant(id);
  }
}

template <class ProxyData>
void Participant::endpointChanged(const ProxyData& data, Graph::Role role, bool isRemoved) {
  namespace dds = eprosima::fastdds::dds;
  const Guid id = guidOf(data.guid());
  if (id.isOfSameParticipant(id_)) return;
  if (isRemoved) {
    graph_.remove(id);
    return;
  }
  Contract contract;
  contract.topic = data.topicName().c_str();
  contract.type = data.typeName().c_str();
  contract.qos.isReliable = data.m_qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  contract.qos.isTransientLocal = data.m_qos.m_durability.kind == dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  contract.hasDeadline = data.m_qos.m_deadline.period != eprosima::fastrtps::c_TimeInfinite;
  contract.hasLiveliness = data.m_qos.m_liveliness.kind != dds::AUTOMATIC_LIVELINESS_QOS ||
                           data.m_qos.m_liveliness.lease_duration != eprosima::fastrtps::c_TimeInfinite;
  const auto& userData = data.m_qos.m_userData;
  const std::string text(userData.begin(), userData.end());
  contract.typeHash = valueIn(text, "typehash");
  contract.cycloneId = valueIn(text, "clientid") + valueIn(text, "serviceid");
  graph_.add({id, role, std::move(contract)});
}

void Participant::onReaderDiscovery(rtps::RTPSParticipant*, rtps::ReaderDiscoveryInfo&& info) {
  endpointChanged(info.info, Graph::Role::kReader, info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER);
}

void Participant::onWriterDiscovery(rtps::RTPSParticipant*, rtps::WriterDiscoveryInfo&& info) {
  endpointChanged(info.info, Graph::Role::kWriter, info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER);
}

}  // namespace pongsim::ros2
