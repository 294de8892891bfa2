#pragma once

#include <cstdint>
#include <string>

#include "log/playback/played_files.hh"
#include "log/playback/recorded_state.hh"

namespace pongsim::log {

/// @param model Of the top level.
/// @return It in SDF, where it is in that state: as its recorder told it in one piece, else made of its components,
/// which have links, joints, shapes and materials.
/// @throws Failure where what its recorder told is no XML, or models are nested more than 100 deep.
std::string modelText(const RecordedState& state, std::uint64_t model, const PlayedFiles& files);

}  // namespace pongsim::log
