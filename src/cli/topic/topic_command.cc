#include "cli/topic/topic_command.hh"

#include <CLI/App.hpp>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command.hh"
#include "cli/options/message_option.hh"
#include "cli/options/network_option.hh"
#include "cli/options/number_option.hh"
#include "cli/options/secure_option.hh"
#include "cli/topic/topic_name.hh"
#include "pongsim/log.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// The parsed command line.
struct TopicCommandLine {
  std::string action;
  bool list = false, info = false, echo = false, hz = false, bw = false, delay = false, json = false, csv = false,
       plot = false, verbose = false, asGz = false;
  std::optional<std::string> topic, type, text, file, count, duration, timeout, rate;
  std::vector<std::string> fields;
};

/// @throws UsageError if an option is given that the action does not support.
void refuseOthers(const TopicCommandLine& given, std::string_view action) {
  const struct {
    const char* option;
    bool isGiven;
    std::string_view actions;
  } rules[] = {{"-v", given.verbose, "-l"},
               {"-t", given.topic.has_value(), "-i, -e, -p, --hz, --bw, --delay or wait"},
               {"-m", given.type.has_value(), "-e, -p, --hz, --bw, --delay or wait"},
               {"-n", given.count.has_value(), "-e, -p, --hz, --bw or --delay"},
               {"-d", given.duration.has_value(), "-e, --hz, --bw or --delay"},
               {"--rate", given.rate.has_value(), "-p"},
               {"--field", !given.fields.empty(), "-e or wait"},
               {"--json", given.json, "-l, -i, -e, --hz, --bw or --delay"},
               {"--csv", given.csv, "-e"},
               {"--plot", given.plot, "-e"},
               {"--timeout", given.timeout.has_value(), "-p or wait"}};
  for (const auto& rule : rules) {
    if (!rule.isGiven || rule.actions.find(action) != std::string_view::npos) continue;
    throw UsageError("option '" + std::string(rule.option) + "' can't be used with '" + std::string(action) + "'",
                     "use it with " + std::string(rule.actions));
  }
}

std::chrono::nanoseconds seconds(std::string_view option, const std::string& text) {
  // a year is practically for ever, and within the clock's range
  constexpr double kLongest = 365.0 * 86400;
  const double value = std::min(numberFromZero(option, text, "a number of seconds"), kLongest);
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(value));
}

ReadOptions readOptions(const TopicCommandLine& given) {
  ReadOptions options;
  options.topic = topicOption(*given.topic);
  if (given.count && given.duration) throw UsageError("options '-n' and '-d' can't be used together");
  if (given.type) options.type = messageTypeOption(*given.type);
  if (given.count) options.count = wholeNumber("-n", *given.count, 1);
  if (given.duration) options.duration = seconds("-d", *given.duration);
  return options;
}

Work echoWork(const TopicCommandLine& given) {
  EchoOptions options;
  options.read = readOptions(given);
  if (given.json && (given.csv || !given.fields.empty())) {
    throw UsageError(std::string("options '--json' and '") + (given.csv ? "--csv" : "--field") +
                     "' can't be used together");
  }
  if (given.plot) {
    if (given.json || given.csv || !given.fields.empty()) {
      throw UsageError(std::string("options '--plot' and '") +
                       (given.json  ? "--json"
                        : given.csv ? "--csv"
                                    : "--field") +
                       "' can't be used together");
    }
    return [read = options.read] { return plotTopic(read); };
  }
  options.format = given.json ? EchoFormat::kJson : given.csv ? EchoFormat::kCsv : EchoFormat::kText;
  options.fields = given.fields;
  return [options] { return echoTopic(options); };
}

/// @return The content of a file, or of stdin if the name is `-`.
std::string textOf(const std::string& file) {
  std::ifstream stream(file == "-" ? "/dev/stdin" : file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) throw UsageError("'" + file + "' can't be read");
  return text;
}

Work publishWork(const TopicCommandLine& given) {
  if (!given.type) throw UsageError("'-p' needs the message's type", "pongsim topic -t TOPIC -m TYPE -p TEXT");
  if (given.text && given.file) throw UsageError("options '-p' and '--file' can't be used together");
  PublishOptions options;
  options.topic = topicOption(*given.topic);
  options.type = messageTypeOption(*given.type);
  options.message = given.file ? messageOption(options.type, textOf(*given.file), *given.file)
                               : messageOption(options.type, *given.text);
  if (given.timeout) options.timeout = seconds("--timeout", *given.timeout);
  if (given.count && !given.rate) throw UsageError("'-n' with '-p' needs a rate", "--rate HZ");
  if (given.count) options.count = wholeNumber("-n", *given.count, 1);
  if (given.rate) {
    constexpr double kSlowest = 1e-6, kQuickest = 1e6;
    const double rate = numberFromZero("--rate", *given.rate, "a number of messages a second");
    if (rate < kSlowest || rate > kQuickest) throw UsageError("option '--rate' takes a number from 1e-6 to 1e6");
    options.period = std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(1 / rate));
  }
  return [options] { return publish(options); };
}

Work waitWork(const TopicCommandLine& given) {
  if (given.fields.size() > 1) throw UsageError("'wait' takes one condition");
  std::optional<FieldCondition> condition;
  if (!given.fields.empty()) condition = FieldCondition::parse(given.fields.front());
  ReadOptions options = readOptions(given);
  if (given.timeout) options.duration = seconds("--timeout", *given.timeout);
  return [options, condition] { return waitForMessage(options, condition); };
}

Work workFor(const TopicCommandLine& given) {
  if (!given.action.empty() && given.action != "wait") {
    throw UsageError("unexpected argument '" + given.action + "'", "only 'wait' is allowed there");
  }
  const std::pair<std::string_view, bool> actions[] = {
      {"-l", given.list},       {"-i", given.info},
      {"-e", given.echo},       {"-p", given.text.has_value() || given.file.has_value()},
      {"--hz", given.hz},       {"--bw", given.bw},
      {"--delay", given.delay}, {"wait", !given.action.empty()}};
  const auto isGiven = [](const auto& action) { return action.second; };
  const auto chosen = std::find_if(std::begin(actions), std::end(actions), isGiven);
  if (std::count_if(std::begin(actions), std::end(actions), isGiven) != 1) {
    throw UsageError(
        chosen == std::end(actions) ? "no action given" : "only one action at a time",
        "one of --list, --info, --echo, --pub, --hz, --bw, --delay and wait; pongsim topic --help has details");
  }
  const std::string_view action = chosen->first;
  refuseOthers(given, action);
  if (given.list) return [&given] { return listTopics(given.verbose, given.json, given.asGz); };
  if (!given.topic) throw UsageError("'" + std::string(action) + "' needs a topic", "-t TOPIC");
  if (given.echo) return echoWork(given);
  if (given.info) {
    return [topic = topicOption(*given.topic), &given] { return showTopic(topic, given.json, given.asGz); };
  }
  if (given.hz || given.bw) {
    const RateKind kind = given.hz ? RateKind::kMessages : RateKind::kBytes;
    return [options = readOptions(given), kind, json = given.json] { return measureTopic(options, kind, json); };
  }
  if (given.delay) {
    return [options = readOptions(given), json = given.json] { return measureDelay(options, json); };
  }
  return given.action == "wait" ? waitWork(given) : publishWork(given);
}

}  // namespace

void addTopicCommand(CLI::App& program, Work& work) {
  const auto given = std::make_shared<TopicCommandLine>();
  CLI::App* command = program.add_subcommand("topic", "List topics, echo and measure them, publish messages");
  const auto add = [command](const char* names, const char* value, const char* description,
                             std::optional<std::string>& target) {
    const auto keep = [&target](const std::string& text) { target = text; };
    command->add_option_function<std::string>(names, keep, description)->type_name(value);
  };
  const auto addFlag = [command](const char* names, bool& target, const char* description) {
    command->add_flag(names, target, description)->disable_flag_override();
  };
  command->add_option("ACTION", given->action, "wait: exit at the first message (that meets the condition of --field)")
      ->type_name("");
  addFlag("-l,--list", given->list, "Print the topics that have publishers, sorted");
  addFlag("-v,--verbose", given->verbose, "List: add types and counts, and topics that have only subscribers");
  addFlag("-i,--info", given->info, "Print the publishers and subscribers of a topic");
  addFlag("-e,--echo", given->echo, "Print a topic's messages as they arrive");
  add("-p,--pub", "TEXT", "Publish a message, in protobuf's text format, as soon as somebody subscribes", given->text);
  add("--file", "FILE", "Publish the message in this file; - is stdin", given->file);
  addFlag("--hz,-f,--frequency", given->hz, "Print the rate of messages once a second, by wall time");
  addFlag("--bw", given->bw, "Print the bandwidth once a second");
  addFlag("--delay", given->delay,
          "Print once a second the delay from a message's time stamp to its arrival; needs stamps in headers");
  add("-t,--topic", "TOPIC", "The topic", given->topic);
  add("-m,--msgtype", "TYPE", "The message type: ignition.msgs.Twist, gz.msgs.Twist or Twist", given->type);
  add("-n,--num,--count", "N", "Exit after N messages", given->count);
  add("-d,--duration", "S", "Exit after S seconds of wall time", given->duration);
  add("--rate", "HZ", "Publish repeatedly, HZ times per second of wall time", given->rate);
  command
      ->add_option("--field", given->fields,
                   "Echo: print only this value, such as pose.position.x or pose[0].name; repeatable\n"
                   "wait: a condition, such as 'pose.position.x >= 1'")
      ->type_name("PATH")
      ->allow_extra_args(false);
  addFlag("--json,--json-output", given->json,
          "Print JSON: echo one line per message; --hz, --bw and --delay one line per second;\n"
          "list an array with types and counts; info an object");
  addFlag("--csv", given->csv, "Echo as CSV: the selected fields, or all single values");
  addFlag("--plot", given->plot,
          "Echo lidar scans as drawings, seen from above, and images as blocks of colour;\n"
          "on a terminal each replaces the one before");
  add("--timeout", "S",
      "Publish: give up after S seconds (1) without a subscriber;\nwait: fail after S seconds (no limit)",
      given->timeout);
  command->add_flag("--as-gz", given->asGz)->disable_flag_override()->group("");
  addNetworkOption(*command);
  addSecureOption(*command);
  command->footer(
      "Examples:\n"
      "  pongsim topic -l\n"
      "  pongsim topic -l --json\n"
      "  pongsim topic -e -t /model/pong_bot/odometry -n 1\n"
      "  pongsim topic -e -t /model/pong_bot/odometry --field pose.position.x\n"
      "  pongsim topic -e -t /lidar --plot\n"
      "  pongsim topic -t /cmd_vel -m ignition.msgs.Twist -p 'linear: {x: 0.5}, angular: {z: 0.05}'\n"
      "  pongsim topic -t /keyboard/keypress -m ignition.msgs.Int32 -p 'data: 16777235'\n"
      "  pongsim topic wait -t /model/pong_bot/odometry --field 'pose.position.x >= 1' --timeout 30");
  command->callback([given, &work] {
    work = workFor(*given);
    // these commands themselves report mismatched types, which the transport would warn about
    setLogLevel(LogLevel::kError);
  });
}

}  // namespace pongsim::cli
