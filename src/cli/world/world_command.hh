#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace pongsim::cli {

enum class WorldAction { kPause, kPlay, kStep, kReset, kStats, kInfo };

struct WorldOptions {
  WorldAction action = WorldAction::kStats;
  /// The world's name; empty: the only one that runs.
  std::string world;
  /// Of `kStep`.
  std::uint32_t steps = 1;
  /// Of `kReset`: where all random numbers come from then; unset: from where they did.
  std::optional<std::uint32_t> seed;
  /// Of `kStats` and `kInfo`.
  bool json = false;
  /// Of `kStats`: end after that many lines.
  std::optional<std::uint64_t> lines;
  /// For finding the world, and for its answer.
  std::chrono::nanoseconds timeout = std::chrono::seconds(1);
};

/// What `pongsim world` does.
/// @return The exit code.
int controlWorld(const WorldOptions& options);

}  // namespace pongsim::cli
