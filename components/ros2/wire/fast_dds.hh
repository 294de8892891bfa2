#pragma once

#include <fastdds/rtps/common/Guid.h>
#include <fastdds/rtps/common/SampleIdentity.h>
#include <fastrtps/attributes/TopicAttributes.h>
#include <fastdds/dds/core/policy/QosPolicies.hpp>

#include <algorithm>
#include <string>

#include "ros2/wire/endpoint.hh"

/// Conversions between types of Fast DDS and ours; only for the sources in this folder.
namespace pongsim::ros2 {

inline Guid guidOf(const eprosima::fastrtps::rtps::GUID_t& from) {
  Guid guid;
  std::copy_n(std::begin(from.guidPrefix.value), 12, guid.bytes.begin());
  std::copy_n(std::begin(from.entityId.value), 4, guid.bytes.begin() + 12);
  return guid;
}

inline eprosima::fastrtps::rtps::GUID_t guidOf(const Guid& from) {
  eprosima::fastrtps::rtps::GUID_t guid;
  std::copy_n(from.bytes.begin(), 12, std::begin(guid.guidPrefix.value));
  std::copy_n(from.bytes.begin() + 12, 4, std::begin(guid.entityId.value));
  return guid;
}

inline SampleId sampleIdOf(const eprosima::fastrtps::rtps::SampleIdentity& from) {
  if (from.writer_guid() == eprosima::fastrtps::rtps::c_Guid_Unknown) return {};
  const auto& number = from.sequence_number();
  return {guidOf(from.writer_guid()), (static_cast<std::int64_t>(number.high) << 32) | number.low};
}

inline eprosima::fastrtps::TopicAttributes topicAttributesOf(const Contract& contract) {
  eprosima::fastrtps::TopicAttributes attributes(contract.topic.c_str(), contract.type.c_str(),
                                                 eprosima::fastrtps::rtps::NO_KEY);
  attributes.auto_fill_type_object = false;
  attributes.auto_fill_type_information = false;
  attributes.historyQos.kind = eprosima::fastrtps::KEEP_LAST_HISTORY_QOS;
  attributes.historyQos.depth = static_cast<std::int32_t>(contract.qos.depth);
  return attributes;
}

/// In the form used by rmw_fastrtps: "typehash=RIHS01_...;", without a terminating zero.
template <class EndpointQos>
EndpointQos endpointQosOf(const Contract& contract) {
  namespace dds = eprosima::fastdds::dds;
  EndpointQos qos;
  qos.m_reliability.kind = contract.qos.isReliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.m_durability.kind =
      contract.qos.isTransientLocal ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  if (contract.qos.lifespan)
    qos.m_lifespan.duration.seconds = static_cast<std::int32_t>(contract.qos.lifespan->count());
  if (!contract.typeHash.empty()) {
    const std::string text = "typehash=" + contract.typeHash + ";";
    qos.m_userData.assign(text.begin(), text.end());
  }
  return qos;
}

inline eprosima::fastrtps::rtps::DurabilityKind_t durabilityOf(const Contract& contract) {
  return contract.qos.isTransientLocal ? eprosima::fastrtps::rtps::TRANSIENT_LOCAL : eprosima::fastrtps::rtps::VOLATILE;
}

inline eprosima::fastrtps::rtps::ReliabilityKind_t reliabilityOf(const Contract& contract) {
  return contract.qos.isReliable ? eprosima::fastrtps::rtps::RELIABLE : eprosima::fastrtps::rtps::BEST_EFFORT;
}

// Fast DDS's default is 3 s. On one machine a packet is lost only if a socket of the receiver is full, as happens with
// images and default settings, and is then repaired immediately.
inline const eprosima::fastrtps::Duration_t kHeartbeatPeriod{0, 3'000'000};
inline const eprosima::fastrtps::Duration_t kAtOnce{0, 0};

}  // namespace pongsim::ros2
