#include <CLI/App.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "log/command/command.hh"
#include "log/record/topic_expression.hh"
#include "log/store/failure.hh"
#include "log/tlog/tlog_reader.hh"
#include "pongsim/node.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"
#include "shared/program/stop_signal.hh"

namespace pongsim::log {

namespace {

using Clock = std::chrono::steady_clock;

struct PlaybackOptions {
  std::string file;
  std::string pattern = ".*";
  std::string remap;
  std::chrono::milliseconds wait{1000};
  bool isFast = false;
};

/// @return Whether it reached its end before it was stopped.
bool sleepUntil(Clock::time_point time) {
  constexpr std::chrono::milliseconds kLook{50};
  while (!cli::isStopped() && Clock::now() < time) std::this_thread::sleep_until(std::min(time, Clock::now() + kLook));
  return !cli::isStopped();
}

/// @return A topic's name and its new name.
std::pair<std::string, std::string> remapOf(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t sign = text.find(":=");
  if (sign == std::string::npos || sign == 0 || sign + 2 == text.size())
    throw cli::UsageError("'" + text + "' is not a renaming", "write --remap /from:=/to");
  return {text.substr(0, sign), text.substr(sign + 2)};
}

TopicExpression expressionOf(const std::string& pattern) {
  try {
    return TopicExpression(pattern);
  } catch (const std::invalid_argument& error) {
    throw cli::UsageError("'" + pattern + "' is not a regular expression: " + error.what());
  }
}

using Publishers = std::map<std::pair<std::string, std::string>, Publisher, std::less<>>;

/// Creates a publisher for each selected topic.
Publishers advertise(Node node, const TlogReader& reader, const PlaybackOptions& options) {
  const auto [from, to] = remapOf(options.remap);
  const TopicExpression wanted = expressionOf(options.pattern);
  Publishers publishers;
  for (const Topic& topic : reader.topics()) {
    if (!wanted.matches(topic.name)) continue;
    const std::string& name = topic.name == from ? to : topic.name;
    publishers.emplace(std::pair(topic.name, topic.type), node.advertiseBytes(name, topic.type));
  }
  return publishers;
}

int play(const PlaybackOptions& options) {
  const TlogReader reader(options.file);
  if (const auto torn = reader.torn()) cli::say("warning: " + *torn);
  Transport transport;
  Publishers publishers = advertise(transport.node(), reader, options);
  if (publishers.empty()) throw Failure("'" + options.file + "' has no topic that '" + options.pattern + "' matches");
  std::vector<std::string> topics;
  for (const auto& [topic, publisher] : publishers) topics.push_back(topic.first);
  if (!sleepUntil(Clock::now() + options.wait)) return cli::kDone;
  const std::optional<TimeRange> range = reader.timeRange();
  const Clock::time_point start = Clock::now();
  reader.forEach({.topics = topics}, [&](const Record& record) {
    if (!options.isFast && !sleepUntil(start + std::chrono::nanoseconds(record.timeNs - range->first))) return false;
    const auto publisher = publishers.find(std::pair(std::string(record.topic), std::string(record.type)));
    if (publisher != publishers.end()) publisher->second.publishBytes(std::as_bytes(std::span(record.payload)));
    return !cli::isStopped();
  });
  for (const auto& [topic, publisher] : publishers) publisher.waitForDelivery(std::chrono::seconds(5));
  return cli::kDone;
}

}  // namespace

void addPlaybackAction(CLI::App& program, cli::Work& work) {
  const auto options = std::make_shared<PlaybackOptions>();
  CLI::App* action =
      program.add_subcommand("playback", "Publish the messages of a recording with their original timing");
  const auto add = [action](const char* names, const char* value, std::string& target, const char* help) {
    action->add_option(names, target, help)->type_name(value);
  };
  add("--file", "FILE", options->file, "A .tlog file");
  add("--pattern", "REGEX", options->pattern, "Topics whose whole names match (.*)");
  add("--remap", "FROM:=TO", options->remap, "Publish the messages of one topic on another");
  action
      ->add_option_function<std::string>(
          "--wait",
          [options](const std::string& text) {
            int ms = -1;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), ms);
            if (error != std::errc() || end != text.data() + text.size() || ms < 0)
              throw cli::UsageError("option '--wait' takes a number of milliseconds, not '" + text + "'");
            options->wait = std::chrono::milliseconds(ms);
          },
          "Wait MS milliseconds for subscribers (1000)")
      ->type_name("MS");
  action->add_flag("-f,--fast", options->isFast, "Publish without the pauses between messages")
      ->disable_flag_override();
  action->footer(
      "Examples:\n"
      "  pongsim log playback --file rec/state.tlog\n"
      "  pongsim log playback --file rec.tlog --pattern '/model/.*' --remap /model/a/cmd_vel:=/cmd_vel -f");
  action->callback([options, &work] {
    if (options->file.empty()) throw cli::UsageError("no file given", "pongsim log playback --file FILE.tlog");
    remapOf(options->remap);
    expressionOf(options->pattern);
    work = [options] {
      cli::takeStopSignals();
      return play(*options);
    };
  });
}

}  // namespace pongsim::log
