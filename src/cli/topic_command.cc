#include "cli/topic_command.hh"

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "cli/command.hh"
#include "cli/console.hh"
#include "cli/message_option.hh"
#include "cli/number_option.hh"
#include "cli/topic_name.hh"
#include "pongsim/log.hh"

namespace pongsim::cli {

namespace {

/// The command line as it was given.
struct Given {
  bool list = false, info = false, echo = false, json = false;
  std::optional<std::string> topic, type, text, count, duration, timeout;
};

/// @throws UsageError where an option is given that means nothing to the action.
void refuseOthers(const Given& given, std::string_view action) {
  const struct {
    const char* option;
    bool isGiven;
    std::string_view actions;
  } rules[] = {{"-t", given.topic.has_value(), "-i -e -p"}, {"-m", given.type.has_value(), "-e -p"},
               {"-n", given.count.has_value(), "-e"},       {"-d", given.duration.has_value(), "-e"},
               {"--json-output", given.json, "-e"},         {"--timeout", given.timeout.has_value(), "-p"}};
  for (const auto& rule : rules) {
    if (!rule.isGiven || rule.actions.find(action) != std::string_view::npos) continue;
    throw UsageError("option '" + std::string(rule.option) + "' means nothing with '" + std::string(action) + "'",
                     "it goes with " + std::string(rule.actions));
  }
}

std::chrono::nanoseconds seconds(std::string_view option, const std::string& text) {
  // a year is as good as for ever, and fits the clock
  constexpr double kLongest = 365.0 * 86400;
  const double value = std::min(numberFromZero(option, text, "a number of seconds"), kLongest);
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(value));
}

Work echoWork(const Given& given) {
  EchoOptions options;
  options.topic = topicOption(*given.topic);
  options.json = given.json;
  if (given.count && given.duration) throw UsageError("options '-n' and '-d' exclude each other");
  if (given.type) options.type = messageTypeOption(*given.type);
  if (given.count) options.count = wholeNumber("-n", *given.count, 1);
  if (given.duration) options.duration = seconds("-d", *given.duration);
  return [options] { return echoTopic(options); };
}

Work publishWork(const Given& given) {
  if (!given.type) throw UsageError("'-p' needs the message's type", "pongsim topic -t TOPIC -m TYPE -p TEXT");
  PublishOptions options;
  options.topic = topicOption(*given.topic);
  options.type = messageTypeOption(*given.type);
  options.message = messageOption(options.type, *given.text);
  if (given.timeout) options.timeout = seconds("--timeout", *given.timeout);
  return [options] { return publishOnce(options); };
}

Work workFor(const Given& given) {
  const int actions = int{given.list} + int{given.info} + int{given.echo} + int{given.text.has_value()};
  if (actions != 1) {
    throw UsageError(actions == 0 ? "nothing to do given" : "one thing at a time",
                     "one of --list, --info, --echo and --pub; pongsim topic --help tells more");
  }
  const std::string_view action = given.list ? "-l" : given.info ? "-i" : given.echo ? "-e" : "-p";
  refuseOthers(given, action);
  if (given.list) return listTopics;
  if (!given.topic) throw UsageError("'" + std::string(action) + "' needs a topic", "-t TOPIC");
  if (given.echo) return echoWork(given);
  if (given.text) return publishWork(given);
  return [topic = topicOption(*given.topic)] { return showTopic(topic); };
}

}  // namespace

void addTopicCommand(CLI::App& program, Work& work) {
  const auto given = std::make_shared<Given>();
  CLI::App* command = program.add_subcommand("topic", "List topics, print what they carry, publish a message");
  command->set_help_flag("-h,--help", "Print this and end");
  const auto add = [command](const char* names, const char* value, const char* description,
                             std::optional<std::string>& target) {
    const auto keep = [&target](const std::string& text) { target = text; };
    command->add_option_function<std::string>(names, keep, description)->type_name(value);
  };
  const auto addFlag = [command](const char* names, bool& target, const char* description) {
    command->add_flag(names, target, description)->disable_flag_override();
  };
  addFlag("-l,--list", given->list, "Print the topics that somebody publishes, sorted");
  addFlag("-i,--info", given->info, "Print who publishes a topic and who subscribes to it");
  addFlag("-e,--echo", given->echo, "Print a topic's messages as they come");
  add("-p,--pub", "TEXT", "Publish one message, given in protobuf's text format, as soon as somebody listens",
      given->text);
  add("-t,--topic", "TOPIC", "The topic", given->topic);
  add("-m,--msgtype", "TYPE", "The messages' type: ignition.msgs.Twist, gz.msgs.Twist or Twist", given->type);
  add("-n,--num", "N", "Echo N messages, then end", given->count);
  add("-d,--duration", "S", "Echo for S seconds, then end", given->duration);
  addFlag("--json-output", given->json, "Echo as JSON, a line each message");
  add("--timeout", "S", "Publish: give up after S seconds (1) without a subscriber", given->timeout);
  command->footer(
      "Examples:\n"
      "  pongsim topic -l\n"
      "  pongsim topic -e -t /model/pong_bot/odometry -n 1\n"
      "  pongsim topic -t /cmd_vel -m ignition.msgs.Twist -p 'linear: {x: 0.5}, angular: {z: 0.05}'\n"
      "  pongsim topic -t /keyboard/keypress -m ignition.msgs.Int32 -p 'data: 16777235'");
  command->callback([given, &work] {
    work = workFor(*given);
    // what the transport would warn of, types that do not fit, is what these commands fail with
    setLogLevel(LogLevel::kError);
  });
}

}  // namespace pongsim::cli
