#pragma once

#include <cstddef>
#include <span>

namespace pongsim::ros2 {

/// Makes requests for discovery data such that Fast DDS 2.9 answers them at once, in place.
///
/// Who meets a participant asks what its writers of discovery have by an ACKNACK that acknowledges nothing and wants a
/// heartbeat (RTPS 8.3.7.1). That of Cyclone DDS has the count 0, and Fast DDS drops what is not above the last one,
/// which is 0 at first; and it asks from number 1 on, which Fast DDS answers with its next heartbeat, up to a second
/// later. So the first request becomes one from 0 on, as Fast DDS sends it, and the counts of all are one more.
///
/// @param packet A message of RTPS, or any bytes.
/// @return How many first requests there were.
std::size_t hastenFirstAcknacks(std::span<unsigned char> packet);

}  // namespace pongsim::ros2
