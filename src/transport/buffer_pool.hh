#pragma once

#include <array>
#include <cstdint>

#include "shared/threads/buffer_pool.hh"

namespace pongsim::transport {

/// A process's place in the DDS domain: the prefix of its GUIDs. All zeros for this one's own.
using ParticipantId = std::array<std::uint8_t, 12>;
inline constexpr ParticipantId kThisProcess{};

using shared::Buffer;
using shared::BufferPool;

}  // namespace pongsim::transport
