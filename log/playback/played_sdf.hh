#pragma once

#include <string>
#include <string_view>

#include "log/playback/played_files.hh"

namespace pongsim::log {

/// Makes of a recorded world or model one to be played: without the systems that would act, or tell of what a log does
/// not have, and with the recording's copies of files.
/// @param sdf A `<sdf>`, `<world>` or `<model>`, of any text around it.
/// @param world Of a file's several worlds the one to be played, by its name as topics have it; where there is none of
/// that name, all stay.
/// @return It as a whole file of SDF.
/// @throws Failure where it is no XML.
std::string playedSdf(const std::string& sdf, const PlayedFiles& files, std::string_view world = {});

/// @param filename Of a `<plugin>`.
/// @return Whether a system of that name only looks at what a log has, as SceneBroadcaster and cameras do.
bool isOfUseInPlayback(std::string_view filename);

}  // namespace pongsim::log
