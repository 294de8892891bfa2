#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace pongsim::cli {

enum class WorldAction { kPause, kPlay, kStep, kReset, kStats, kInfo };

struct WorldOptions {
  WorldAction action = WorldAction::kStats;
  /// The world's name; empty: the only running one.
  std::string world;
  /// For `kStep`.
  std::uint32_t steps = 1;
  /// For `kReset`: the new seed of all random numbers; unset: the old one.
  std::optional<std::uint32_t> seed;
  /// For `kStats` and `kInfo`.
  bool json = false;
  /// For `kStats`: stop after this many lines.
  std::optional<std::uint64_t> lines;
  /// For finding the world, and for its answer.
  std::chrono::nanoseconds timeout = std::chrono::seconds(1);
};

/// Implements `pongsim world`.
/// @return The exit code.
int controlWorld(const WorldOptions& options);

}  // namespace pongsim::cli
