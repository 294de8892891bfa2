#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "web/server/session.hh"

namespace pongsim::web {

// Format of a frame of poses, all numbers little endian:
//
//   0  u32  0x31465750, "PWF1"
//   4  u32  flags: 1, the frame contains all entities
//   8  u64  simulated time [ns]
//  16  u64  number of steps
//  24  f64  real-time factor over the last half second
//  32  u32  1 if the world is paused
//  36  u32  0
//  40  u32  revision: changes when entities are added or removed, so that the scene must be requested again
//  44  u32  number of entities that follow, 32 bytes each:
//           u32  its id
//           f32  position in the world x, y, z [m]
//           f32  rotation in the world x, y, z, w
//
// Entities are models, links and actors. A frame contains those that have moved since the client's previous frame; the
// first frame and the one after a new revision contain all.

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

/// Encodes a frame.
/// @param before The poses that the client has: as many, of the same entities; or empty, for a frame with all. Replaced
/// by `now`.
Payload encodeFrame(const FrameStatus& status, std::span<const FramePose> now, std::vector<FramePose>& before);

}  // namespace pongsim::web
