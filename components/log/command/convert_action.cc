#include <unistd.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "log/command/command.hh"
#include "log/command/log_file.hh"
#include "log/command/new_log.hh"
#include "log/command/ros2_option.hh"
#include "log/store/failure.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::log {

namespace {

namespace fs = std::filesystem;

struct ConvertCommandLine {
  std::string file, output;
  std::vector<std::string> topics;
  std::string compression = "zstd";
  bool overwrites = false;
  Ros2Choice ros2;
};

/// A temporary file beside the destination, which replaces it when it is complete.
class Draft {
 public:
  explicit Draft(fs::path target)
      : target_(std::move(target)),
        path_(target_.parent_path() /
              (target_.stem().string() + ".part" + std::to_string(getpid()) + target_.extension().string())) {}
  ~Draft() {
    std::error_code ignored;
    if (!isDone_) fs::remove(path_, ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const fs::path& path() const { return path_; }
  void finish() {
    std::error_code error;
    fs::rename(path_, target_, error);
    if (error) throw Failure("'" + target_.string() + "' can't be written: " + error.message());
    isDone_ = true;
  }

 private:
  fs::path target_, path_;
  bool isDone_ = false;
};

void checkTarget(const ConvertCommandLine& given) {
  std::error_code error;
  if (fs::equivalent(given.file, given.output, error)) {
    throw cli::UsageError("'" + given.output + "' is also the input", "choose another file with -o");
  }
  if (!given.overwrites && fs::exists(fs::symlink_status(given.output, error))) {
    throw Failure("'" + given.output + "' already exists", "use --force to overwrite it");
  }
}

/// A tlog holds only protobuf messages of named types.
void checkForTlog(const LogFile& log, const Selection& selection) {
  for (const Topic& topic : log.reader().topics()) {
    if (selection.topics && std::ranges::count(*selection.topics, topic.name) == 0) continue;
    const Definition definition = log.definition(topic.name, topic.type);
    if (definition.messageEncoding == "protobuf" && !topic.type.empty()) continue;
    throw Failure("'" + topic.name + "' can't be written to a tlog: its messages are " +
                      (topic.type.empty() ? "of no type" : topic.type) + " in '" + definition.messageEncoding + "'",
                  "a tlog needs protobuf; choose topics with --topic");
  }
}

/// @return Number of messages in the new log.
std::uint64_t copy(const LogFile& log, const Selection& selection, const fs::path& to, McapOptions options) {
  if (log.mcap() != nullptr) options.profile = log.mcap()->profile();
  const auto writer = newLog(
      to, options, [&log](std::string_view topic, std::string_view type) { return log.definition(topic, type); });
  std::uint64_t count = 0;
  log.reader().forEach(selection, [&](const Record& record) {
    writer->write(record);
    ++count;
    return true;
  });
  writer->close();
  return count;
}

/// Topics, with their types, whose messages are not in protobuf. Reports the selected ones among them.
std::set<std::pair<std::string, std::string>, std::less<>> topicsOfOthers(const LogFile& log,
                                                                          const Selection& selection) {
  std::set<std::pair<std::string, std::string>, std::less<>> found;
  for (const Topic& topic : log.reader().topics()) {
    const std::string encoding = log.definition(topic.name, topic.type).messageEncoding;
    if (encoding == "protobuf") continue;
    found.emplace(topic.name, topic.type);
    if (selection.topics && std::ranges::count(*selection.topics, topic.name) == 0) continue;
    cli::say("warning: '" + topic.name + "' is left out: its messages are in '" + encoding + "', not in 'protobuf'");
  }
  return found;
}

/// Like `copy`, with ROS messages.
std::uint64_t copyForRos2(const LogFile& log, const Selection& selection, const fs::path& to,
                          const McapOptions& options, const ConvertCommandLine& given) {
  const auto writer = newRos2Log(to, options, given.ros2);
  const auto others = topicsOfOthers(log, selection);
  bool hasOthers = false;
  log.reader().forEach(selection, [&](const Record& record) {
    const bool isOther =
        !others.empty() && others.contains(std::pair(std::string(record.topic), std::string(record.type)));
    hasOthers |= isOther;
    if (!isOther) writer->write(record);
    return true;
  });
  writer->close();
  requireSomeOfRos2(*writer, hasOthers || writer->hasLeftOut(), "'" + given.file + "'");
  return writer->messages();
}

int convert(const ConvertCommandLine& given) {
  const Format format = formatOf(given.output);
  const McapOptions options{.overwrites = true, .compression = compressionFrom(given.compression)};
  if (given.ros2.isWanted) checkRos2Name(given.output);
  checkTarget(given);
  const LogFile log(given.file);
  Selection selection;
  if (!given.topics.empty()) {
    selection.topics.emplace();
    for (const std::string& topic : given.topics) {
      selection.topics->push_back(requireTopic(log.reader(), given.file, topic));
    }
  }
  if (format == Format::kTlog) checkForTlog(log, selection);

  Draft draft(given.output);
  const std::uint64_t count = given.ros2.isWanted ? copyForRos2(log, selection, draft.path(), options, given)
                                                  : copy(log, selection, draft.path(), options);
  draft.finish();
  if (const auto torn = log.reader().torn()) cli::say("warning: " + *torn);
  cli::say(std::to_string(count) + (count == 1 ? " message" : " messages") + " in " + given.output);
  return cli::kDone;
}

}  // namespace

void addConvertAction(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<ConvertCommandLine>();
  CLI::App* action =
      program.add_subcommand("convert", "Convert a log: to the other format, another compression, or fewer topics");
  action->add_option("FILE", given->file, "The log, .mcap or .tlog; a truncated one is converted as far as it goes")
      ->type_name("")
      ->required();
  action->add_option("-o,--output", given->output, "The new log, .mcap or .tlog")->type_name("FILE")->required();
  action->add_flag("--force", given->overwrites, "Overwrite an existing file");
  action->add_option("--topic", given->topics, "Only this topic; repeatable")
      ->type_name("TOPIC")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  action->add_option("--compression", given->compression, "Compression of MCAP: zstd, lz4 or none (zstd)")
      ->type_name("NAME");
  addRos2Options(*action, given->ros2);
  action->footer(
      "Examples:\n"
      "  pongsim log convert state.tlog -o state.mcap\n"
      "  pongsim log convert run.mcap -o odometry.mcap --topic /odom\n"
      "  pongsim log convert run.mcap -o bag.mcap --ros2");
  action->callback([given, &work] { work = [given] { return convert(*given); }; });
}

}  // namespace pongsim::log
