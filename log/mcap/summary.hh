#pragma once

#include <optional>
#include <string>

#include "log/mcap/contents.hh"

namespace pongsim::log {

/// @return What the summary at the file's end says, but for the header; nothing where there is none that can be used,
/// and `why` says why where that is a fault.
std::optional<Contents> contentsBySummary(const InputFile& file, std::string& why);

}  // namespace pongsim::log
