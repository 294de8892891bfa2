#pragma once

#include <filesystem>
#include <memory>

#include "log/command/ros2_option.hh"
#include "log/mcap/encoded_writer.hh"
#include "log/mcap/mcap_writer.hh"
#include "log/store/writer.hh"

namespace pongsim::log {

/// @return A writer for the format given by the file's name.
/// @param options For MCAP; whether a file may be overwritten applies to both formats.
/// @throws Failure if the file exists and must not be overwritten, or can't be created; UsageError if its name gives no
/// format.
std::unique_ptr<Writer> newLog(const std::filesystem::path& file, const McapOptions& options,
                               const Definitions& definitions);

/// @throws UsageError if the file's name is that of a tlog, which can't contain ROS messages.
void checkRos2Name(const std::filesystem::path& file);

/// @return A writer for ROS messages, which reports what it leaves out.
/// @throws Like `newLog`, `checkRos2Name` and `ros2Encoder`.
std::unique_ptr<EncodedWriter> newRos2Log(const std::filesystem::path& file, const McapOptions& options,
                                          const Ros2Choice& ros2);

/// Call at the end of such a log.
/// @param hasLeftOut Whether some messages were left out.
/// @param source What it was made from, for the message: "'run.tlog'".
/// @throws Failure if there were messages but the log contains none.
void requireSomeOfRos2(const EncodedWriter& writer, bool hasLeftOut, const std::string& source);

}  // namespace pongsim::log
