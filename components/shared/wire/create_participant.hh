#pragma once

#include <fastdds/rtps/RTPSDomain.h>
#include <fastdds/rtps/attributes/RTPSParticipantAttributes.h>
#include <fastdds/rtps/participant/RTPSParticipant.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <fastdds/dds/log/Log.hpp>

#include <atomic>
#include <cstdint>

namespace pongsim::shared {

/// Settings that Fast DDS has once for the whole process.
inline void setUpFastDds() {
  static const bool once = [] {
    // Fast DDS logs to stdout, which is for our output
    eprosima::fastdds::dds::Log::ClearConsumers();
    // intraprocess delivery calls endpoints of other participants while these may be being destroyed
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
    return true;
  }();
  static_cast<void>(once);
}

/// Creates a participant of a domain whose discovery port is one at which others look for it.
///
/// Fast DDS 2.9 numbers the participants of a process on and on, and derives their ports from the numbers (RTPS
/// 9.6.1.1), so that after a hundred or so they would leave those of the domain. Here numbers begin anew; that of an
/// ended participant comes back last, for its GUID does, too.
///
/// @param count Participants of the domain on this machine.
/// @return Null where Fast DDS refuses.
inline eprosima::fastrtps::rtps::RTPSParticipant* createParticipant(
    std::uint32_t domain, eprosima::fastrtps::rtps::RTPSParticipantAttributes attributes,
    eprosima::fastrtps::rtps::RTPSParticipantListener* listener, std::uint32_t count) {
  using eprosima::fastrtps::rtps::RTPSDomain;
  setUpFastDds();
  static std::atomic<std::uint32_t> next = 0;
  const std::uint32_t end = attributes.port.getUnicastPort(domain, count);
  for (std::uint32_t i = 0; i < count; ++i) {
    // refused where one has this number
    attributes.participantID = static_cast<std::int32_t>(next++ % count);
    auto* const participant = RTPSDomain::createParticipant(domain, false, attributes, listener);
    if (participant == nullptr) continue;
    const auto& builtin = participant->getRTPSParticipantAttributes().builtin;
    if (builtin.metatrafficUnicastLocatorList.begin()->port < end) return participant;
    // others have the ports from this number on
    RTPSDomain::removeRTPSParticipant(participant);
  }
  return nullptr;
}

}  // namespace pongsim::shared
