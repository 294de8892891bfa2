#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace pongsim::ros2 {

/// Modifies requests for discovery data so that Fast DDS 2.9 answers them immediately. Works in place.
///
/// A participant that discovers another one asks for the data of its discovery writers with an ACKNACK that
/// acknowledges nothing and requests a heartbeat (RTPS 8.3.7.1). Cyclone DDS's first one has the count 0, and Fast DDS
/// drops counts that do not exceed the last one, which is initially 0. It also asks from number 1 on, which Fast DDS
/// answers only with its next heartbeat, up to a second later. So the first request is changed to ask from 0 on, as
/// Fast DDS does, and all counts are increased by one.
///
/// @param packet An RTPS message, or any bytes.
/// @return The number of first requests found.
std::size_t hastenFirstAcknacks(std::span<std::uint8_t> packet);

}  // namespace pongsim::ros2
