#pragma once

#include "log/mcap/contents.hh"

namespace pongsim::log {

/// Reads the file from front to back, up to its end or to where it is truncated or damaged.
/// @return Its contents up to there, except for the header.
Contents contentsByScan(const InputFile& file);

}  // namespace pongsim::log
