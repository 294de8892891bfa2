#pragma once

#include <string>
#include <string_view>

#include "log/playback/played_files.hh"

namespace pongsim::log {

/// Converts a recorded world or model for playback: removes systems that would act on it or publish what a log does not
/// contain, and uses the recording's copies of files.
/// @param sdf An `<sdf>`, `<world>` or `<model>`, with any text around it.
/// @param world If the file has several worlds, the name of the one to play, as used in topics; if none has this name,
/// all are kept.
/// @return A complete SDF file.
/// @throws Failure if it is not XML.
std::string playedSdf(const std::string& sdf, const PlayedFiles& files, std::string_view world = {});

/// @param filename From a `<plugin>`.
/// @return Whether a system with this name only reads what a log contains, like SceneBroadcaster and cameras.
bool isOfUseInPlayback(std::string_view filename);

}  // namespace pongsim::log
