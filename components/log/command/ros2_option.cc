#include "log/command/ros2_option.hh"

#include <CLI/App.hpp>

#include "log/store/failure.hh"
#include "shared/program/console.hh"

namespace pongsim::log {

namespace {

/// @return "bridge.yaml:3:5: MESSAGE", or the message alone if it has no position in a file.
std::string placed(const Diagnostic& diagnostic) {
  const SourcePosition& place = diagnostic.position;
  if (place.file == nullptr) return diagnostic.message;
  std::string text = *place.file + ":";
  if (place.line > 0) text += std::to_string(place.line) + ":" + std::to_string(place.column) + ":";
  return text + " " + diagnostic.message;
}

}  // namespace

void addRos2Options(CLI::App& action, Ros2Choice& ros2) {
  action.add_flag("--ros2", ros2.isWanted, "Write ROS 2 messages, for 'ros2 bag play'; MCAP only");
  action
      .add_option_function<std::string>(
          "--ros2-config",
          [&ros2](const std::string& file) {
            ros2.isWanted = true;
            ros2.configFile = file;
          },
          "... with the names and types of a ros_gz_bridge configuration")
      ->type_name("FILE");
}

std::unique_ptr<MessageEncoder> ros2Encoder(const Ros2Choice& ros2) {
  EncoderSettings settings;
  if (ros2.configFile) settings["config_file"] = *ros2.configFile;
  Diagnostics diagnostics;
  std::unique_ptr<MessageEncoder> encoder = makeMessageEncoder("ros2", settings, diagnostics);
  const Diagnostic* last = nullptr;
  for (const Diagnostic& each : diagnostics.all()) {
    if (each.severity == Severity::kWarning) {
      cli::say("warning: " + placed(each) + (each.hint.empty() ? "" : "\n  hint: " + each.hint));
      continue;
    }
    if (last != nullptr) cli::sayError(placed(*last), last->hint);
    last = &each;
  }
  if (last != nullptr) throw Failure(placed(*last), last->hint);
  return encoder;
}

}  // namespace pongsim::log
