#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "web/server/session.hh"

namespace pongsim::web {

// A frame of poses on the wire, all numbers with the lowest byte first:
//
//   0  u32  0x31465750, "PWF1"
//   4  u32  flags: 1, all that there is is in it
//   8  u64  simulated time [ns]
//  16  u64  steps made
//  24  f64  simulated seconds a second, over the last half second
//  32  u32  1 where the world is paused
//  36  u32  0
//  40  u32  revision: another one where any of these have come or gone, so that the scene is to be asked for again
//  44  u32  how many entities follow, 32 bytes each:
//           u32  its id
//           f32  position in the world x, y, z [m]
//           f32  rotation in the world x, y, z, w
//
// Of models, links and actors; those are in it that have moved since the frame that this client got before, and all in
// its first one and after a new revision.

inline constexpr std::uint32_t kFrameMagic = 0x31465750;
inline constexpr std::uint32_t kFrameHasAll = 1;
inline constexpr std::size_t kFrameHead = 48;
inline constexpr std::size_t kFrameEntry = 32;

/// An entity and its pose in the world: position [m], rotation x, y, z, w.
struct FramePose {
  using Numbers = std::array<float, 7>;
  std::uint32_t entity = 0;
  Numbers pose{};
  bool operator==(const FramePose&) const = default;
};
static_assert(sizeof(FramePose) == kFrameEntry);

struct FrameStatus {
  std::uint64_t timeNs = 0;
  std::uint64_t iterations = 0;
  double realTimeFactor = 0;
  bool isPaused = false;
  std::uint32_t revision = 0;
  bool operator==(const FrameStatus&) const = default;
};

/// Writes a frame.
/// @param before What the client has got: as many poses of the same entities, or none, for one with all. Replaced by
/// `now`.
Payload encodeFrame(const FrameStatus& status, std::span<const FramePose> now, std::vector<FramePose>& before);

}  // namespace pongsim::web
