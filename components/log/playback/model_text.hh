#pragma once

#include <cstdint>
#include <string>

#include "log/playback/played_files.hh"
#include "log/playback/recorded_state.hh"

namespace pongsim::log {

/// @param model A top-level model.
/// @return The model in SDF, as in that state: either the text that its recorder wrote, or built from its components,
/// which cover links, joints, shapes and materials.
/// @throws Failure if the recorder's text is not XML, or models are nested more than 100 deep.
std::string modelText(const RecordedState& state, std::uint64_t model, const PlayedFiles& files);

}  // namespace pongsim::log
