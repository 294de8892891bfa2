#pragma once

#include <optional>
#include <string>

#include "log/mcap/contents.hh"

namespace pongsim::log {

/// @return The contents given by the summary at the file's end, except for the header; nothing if there is no usable
/// summary. If that is a fault, `why` gets the reason.
std::optional<Contents> contentsBySummary(const InputFile& file, std::string& why);

}  // namespace pongsim::log
