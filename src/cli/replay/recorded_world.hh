#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/simulation.hh"
#include "sim/inputs/recording.hh"
#include "sim/inputs/world_content.hh"

namespace pongsim::cli {

using Worlds = std::vector<std::unique_ptr<Simulation>>;

/// The world of a run without a world file.
inline constexpr const char* kEmptyWorld = "<sdf version='1.9'><world name='default'/></sdf>";

/// How the worlds of a recording are loaded.
struct WorldLoading {
  int threads = 1;
  /// Null: nothing from outside, and no systems that connect with it.
  Transport* transport = nullptr;
};

/// Loads the worlds of a recorded run from a file as it is now, with the options of that run.
Worlds loadFile(const std::filesystem::path& file, const sim::RunStart& start, const WorldLoading& loading,
                Diagnostics& diagnostics);

/// Loads them from the text in the recording.
Worlds loadRecorded(const sim::RunStart& start, const WorldLoading& loading, Diagnostics& diagnostics);

/// Prints the diagnostics, warnings only if they are wanted.
/// @throws Failure if there are errors, or no worlds.
void checkLoaded(const Worlds& worlds, const Diagnostics& diagnostics, bool warns);

/// @return What the recording says of the world.
sim::WorldContent contentOf(const sim::RunStart& start);

/// @return "step 1234 (1.234 s)"
std::string placeOf(std::uint64_t steps, const Simulation& simulation);

/// @return "state hash 0123456789abcdef"
std::string hashText(std::uint64_t hash);

}  // namespace pongsim::cli
