#include "log/command/new_log.hh"

#include "log/command/log_file.hh"
#include "log/store/failure.hh"
#include "log/tlog/tlog_writer.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::log {

namespace fs = std::filesystem;

namespace {

void checkPlace(const fs::path& file, const McapOptions& options) {
  std::error_code error;
  if (!options.overwrites && fs::exists(fs::symlink_status(file, error))) {
    throw Failure("'" + file.string() + "' already exists", "use --force to overwrite it");
  }
  if (fs::is_directory(file, error)) throw Failure("'" + file.string() + "' is a folder");
}

}  // namespace

std::unique_ptr<Writer> newLog(const fs::path& file, const McapOptions& options, const Definitions& definitions) {
  const Format format = formatOf(file);
  checkPlace(file, options);
  if (format == Format::kMcap) return std::make_unique<McapWriter>(file, options, definitions);
  return std::make_unique<TlogWriter>(file);
}

void checkRos2Name(const fs::path& file) {
  if (formatOf(file) == Format::kTlog) {
    throw cli::UsageError("'" + file.string() + "' can't contain ROS messages: a tlog holds only Gazebo messages",
                          "with --ros2, the name must end in .mcap");
  }
}

std::unique_ptr<EncodedWriter> newRos2Log(const fs::path& file, const McapOptions& options, const Ros2Choice& ros2) {
  checkRos2Name(file);
  checkPlace(file, options);
  return std::make_unique<EncodedWriter>(file, options, ros2Encoder(ros2),
                                         [](const std::string& what) { cli::say("warning: " + what); });
}

void requireSomeOfRos2(const EncodedWriter& writer, bool hasLeftOut, const std::string& source) {
  if (writer.messages() > 0 || !hasLeftOut) return;
  throw Failure("no message of " + source + " can be written as a ROS message", "leave out --ros2");
}

}  // namespace pongsim::log
