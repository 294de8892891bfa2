#pragma once

#include "log/mcap/contents.hh"

namespace pongsim::log {

/// Reads the file from front to back, up to its end or to where it is cut off or damaged.
/// @return What it has up to there, but for the header.
Contents contentsByScan(const InputFile& file);

}  // namespace pongsim::log
