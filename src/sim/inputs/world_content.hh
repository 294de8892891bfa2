#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/inputs/recording.hh"

namespace pongsim::sim {

/// What a world file consists of.
struct WorldContent {
  /// As in `RunStart`.
  std::string sdf;
  std::vector<RunStart::File> files;
  bool operator==(const WorldContent&) const = default;
};

/// @return Nothing if the file can't be read.
std::optional<WorldContent> contentOf(const std::filesystem::path& file);

/// @return Where two worlds differ first: "model 'box', link 'link', inertial, mass: 1 and 2", or a file; empty if
/// nowhere.
std::string firstDifference(const WorldContent& a, const WorldContent& b);

}  // namespace pongsim::sim
