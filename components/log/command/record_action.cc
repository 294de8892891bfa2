#include <CLI/App.hpp>
#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "log/command/command.hh"
#include "log/command/log_file.hh"
#include "log/command/new_log.hh"
#include "log/command/recording.hh"
#include "log/command/ros2_option.hh"
#include "log/command/times.hh"
#include "log/command/topic_choice.hh"
#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "pongsim/program/keystore.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"
#include "shared/program/stop_signal.hh"

namespace pongsim::log {

namespace {

using Clock = std::chrono::steady_clock;

struct RecordCommandLine {
  std::vector<std::string> topics;
  std::optional<std::string> output, pattern, duration, network;
  std::string compression = "zstd";
  bool overwrites = false;
  Ros2Choice ros2;
};

/// The name that `ign log record` uses, except for the extension.
std::string defaultName(const Ros2Choice& ros2) {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  std::array<char, 40> name{};
  std::strftime(name.data(), name.size(), "%Y%m%d_%H%M%S", &parts);
  return name.data() + std::string(ros2.isWanted ? ".mcap" : ".tlog");
}

std::string counted(std::uint64_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void warnOfSilentTopics(const Recording& recording, const TopicChoice& choice) {
  for (const std::string& topic : choice.names()) {
    if (!recording.hasHeard(topic)) cli::say("warning: no messages on '" + topic + "'");
  }
  if (recording.messages() == 0) cli::say("warning: the log is empty; pongsim topic -l lists the topics");
}

void sayLost(const Recording& recording) {
  std::uint64_t sum = 0;
  for (const auto& [topic, count] : recording.lost()) {
    sum += count;
    cli::say("warning: " + counted(count, "message") + " of '" + topic + "' lost");
  }
  if (sum > 0) cli::say("warning: this process or the disk was too slow: record fewer topics");
}

/// Records until the user stops it or the time is over.
void recordWhile(Recording& recording, const std::string& file, std::chrono::nanoseconds duration) {
  const Clock::time_point start = Clock::now();
  cli::say("recording to " + file + "; Ctrl-C ends it");
  while (!cli::isStopped() && Clock::now() - start < duration) recording.goOn();
}

void sayWritten(std::uint64_t messages, std::size_t topics, const std::string& file) {
  cli::say(counted(messages, "message") + " of " + counted(topics, "topic") + " in " + file);
}

/// Removes the file of an empty recording; otherwise repeating the command would be refused.
void removeEmpty(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error)))
    std::filesystem::remove(file, error);
}

int record(RecordCommandLine& given) {
  if (given.pattern) given.topics.push_back(*given.pattern);
  const TopicChoice choice(given.topics);
  const std::chrono::nanoseconds duration(given.duration ? timeFrom("--duration", *given.duration)
                                                         : std::numeric_limits<std::int64_t>::max() / 2);
  const std::string file = given.output.value_or(defaultName(given.ros2));
  const McapOptions options{.overwrites = given.overwrites, .compression = compressionFrom(given.compression)};

  cli::takeStopSignals();
  TransportOptions where;
  if (given.network) where.interface = *given.network;
  Transport transport(where);
  if (given.ros2.isWanted) {
    const std::unique_ptr<EncodedWriter> writer = newRos2Log(file, options, given.ros2);
    Recording recording(transport, *writer, choice, [&writer](std::string_view topic, std::string_view type) {
      return writer->takes(topic, type);
    });
    recordWhile(recording, file, duration);
    writer->close();
    sayLost(recording);
    if (writer->messages() == 0 && writer->hasLeftOut()) removeEmpty(file);
    requireSomeOfRos2(*writer, writer->hasLeftOut(), "the recorded topics");
    sayWritten(writer->messages(), writer->topics(), file);
    warnOfSilentTopics(recording, choice);
    return cli::kDone;
  }
  const std::unique_ptr<Writer> writer =
      newLog(file, options, [](std::string_view, std::string_view type) { return protobufDefinition(type); });
  Recording recording(transport, *writer, choice);
  recordWhile(recording, file, duration);
  writer->close();
  sayLost(recording);
  sayWritten(recording.messages(), recording.topics(), file);
  warnOfSilentTopics(recording, choice);
  return cli::kDone;
}

}  // namespace

void addRecordAction(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<RecordCommandLine>();
  CLI::App* action = program.add_subcommand("record", "Record topics of running worlds, until Ctrl-C");
  action
      ->add_option("TOPIC", given->topics,
                   "Topics such as /odom, or regular expressions for whole names such as '/model/.*' (all)")
      ->type_name("");
  const auto text = [action](const char* names, std::optional<std::string>& to, const char* value, const char* help) {
    action
        ->add_option_function<std::string>(
            names, [&to](const std::string& word) { to = word; }, help)
        ->type_name(value);
  };
  text("-o,--output,--file", given->output, "FILE",
       "The log, .mcap or .tlog (DATE_TIME.tlog, like ign; with --ros2 DATE_TIME.mcap)");
  action->add_flag("--force", given->overwrites, "Overwrite an existing file");
  text("--pattern", given->pattern, "REGEX", "Another regular expression, like 'ign log record'");
  text("--duration", given->duration, "S", "Exit after S seconds");
  action->add_option("--compression", given->compression, "Compression of MCAP: zstd, lz4 or none (zstd)")
      ->type_name("NAME");
  action
      ->add_option_function<std::string>(
          "-v,--verbose",
          [](const std::string& level) {
            if (level.size() != 1 || level[0] < '0' || level[0] > '4') {
              throw cli::UsageError("option '-v' takes a level from 0 to 4, not '" + level + "'");
            }
            setLogLevel(static_cast<LogLevel>(level[0] - '0'));
          },
          "Verbosity: 1 errors, 2 warnings, 3 and 4 more (2)")
      ->type_name("LEVEL");
  addRos2Options(*action, given->ros2);
  text("--network", given->network, "INTERFACE",
       "Also record from machines on this network interface (name or address)");
  action
      ->add_option_function<std::string>(
          "--secure",
          [](const std::string& place) {
            // an empty one would mean: not secured
            if (place.empty()) {
              throw cli::UsageError("option '--secure' takes a keystore, or KEYSTORE/NAME, not ''");
            }
            secureBy(place);
          },
          "Take part as an identity of this keystore, like PONGSIM_SECURITY")
      ->type_name("KEYSTORE[/NAME]");
  action->footer(
      "Examples:\n"
      "  pongsim log record -o run.mcap\n"
      "  pongsim log record -o run.mcap /odom '/model/.*'\n"
      "  pongsim log record -o bag.mcap --ros2\n"
      "  pongsim log record --file state.tlog --pattern '/world/.*'");
  action->callback([given, &work] { work = [given] { return record(*given); }; });
}

}  // namespace pongsim::log
