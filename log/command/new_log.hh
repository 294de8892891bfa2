#pragma once

#include <filesystem>
#include <memory>

#include "log/mcap/mcap_writer.hh"
#include "log/store/writer.hh"

namespace pongsim::log {

/// @return A writer of the format that the file's name says.
/// @param options For MCAP; whether a file may be overwritten for both.
/// @throws Failure where the file is there already and is not to be overwritten, or can't be made; UsageError where its
/// name says no format.
std::unique_ptr<Writer> newLog(const std::filesystem::path& file, const McapOptions& options,
                               const Definitions& definitions);

}  // namespace pongsim::log
