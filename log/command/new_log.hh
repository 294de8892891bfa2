#pragma once

#include <filesystem>
#include <memory>

#include "log/command/ros2_option.hh"
#include "log/mcap/encoded_writer.hh"
#include "log/mcap/mcap_writer.hh"
#include "log/store/writer.hh"

namespace pongsim::log {

/// @return A writer of the format that the file's name says.
/// @param options For MCAP; whether a file may be overwritten for both.
/// @throws Failure where the file is there already and is not to be overwritten, or can't be made; UsageError where its
/// name says no format.
std::unique_ptr<Writer> newLog(const std::filesystem::path& file, const McapOptions& options,
                               const Definitions& definitions);

/// @throws UsageError where the file's name is that of a tlog, which can't have messages of ROS.
void checkRos2Name(const std::filesystem::path& file);

/// @return A writer of messages of ROS, which says what it leaves out.
/// @throws As `newLog`, `checkRos2Name` and `ros2Encoder`.
std::unique_ptr<EncodedWriter> newRos2Log(const std::filesystem::path& file, const McapOptions& options,
                                          const Ros2Wish& wish);

/// To be called at the end of such a log.
/// @param hasLeftOut Whether there was something that is not in it.
/// @param source What it is made of, for the message: "'run.tlog'".
/// @throws Failure where there was something, and nothing is in the log.
void requireSomeOfRos2(const EncodedWriter& writer, bool hasLeftOut, const std::string& source);

}  // namespace pongsim::log
