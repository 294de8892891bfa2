#include "cli/service/service_command.hh"

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "cli/command.hh"
#include "cli/options/message_option.hh"
#include "cli/options/network_option.hh"
#include "cli/options/number_option.hh"
#include "cli/options/secure_option.hh"
#include "cli/service/service_name.hh"
#include "pongsim/log.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// The parsed command line.
struct ServiceCommandLine {
  bool list = false, info = false, json = false, asGz = false;
  std::optional<std::string> service, requestType, replyType, timeout, text;
};

Work callWork(const ServiceCommandLine& given) {
  CallOptions options;
  options.service = serviceOption(*given.service);
  options.text = *given.text;
  options.asJson = given.json;
  if (given.requestType) options.requestType = messageTypeOption(*given.requestType);
  if (given.replyType) options.replyType = messageTypeOption(*given.replyType);
  if (given.timeout)
    options.timeout = std::chrono::milliseconds(wholeNumber("--timeout", *given.timeout, 0, kLongestMs));
  // a mistake in the request is one in the command line
  if (given.requestType) messageOption(options.requestType, options.text);
  return [options] { return callService(options); };
}

Work workFor(const ServiceCommandLine& given) {
  const int actions = int{given.list} + int{given.info} + int{given.text.has_value()};
  if (actions != 1) {
    throw UsageError(actions == 0 ? "no action given" : "only one action at a time",
                     "one of --list, --info and --req; pongsim service --help has details");
  }
  const std::string_view action = given.list ? "-l" : given.info ? "-i" : "-r";
  for (const auto& [option, isGiven] :
       {std::pair("--reqtype", given.requestType.has_value()), std::pair("--reptype", given.replyType.has_value()),
        std::pair("--timeout", given.timeout.has_value())}) {
    if (isGiven && !given.text) {
      throw UsageError("option '" + std::string(option) + "' can't be used with '" + std::string(action) + "'",
                       "use it with -r");
    }
  }
  if (given.list && given.service) throw UsageError("option '-s' can't be used with '-l'", "use it with -i or -r");
  if (given.list) return [&given] { return listServices(given.json, given.asGz); };
  if (!given.service) throw UsageError("'" + std::string(action) + "' needs a service", "-s SERVICE");
  if (given.text) return callWork(given);
  return [service = serviceOption(*given.service), &given] { return showService(service, given.json, given.asGz); };
}

}  // namespace

void addServiceCommand(CLI::App& program, Work& work) {
  const auto given = std::make_shared<ServiceCommandLine>();
  CLI::App* command = program.add_subcommand("service", "List services, describe or call one");
  const auto add = [command](const char* names, const char* value, const char* description,
                             std::optional<std::string>& target) {
    const auto keep = [&target](const std::string& text) { target = text; };
    command->add_option_function<std::string>(names, keep, description)->type_name(value);
  };
  command->add_flag("-l,--list", given->list, "Print the available services, sorted")->disable_flag_override();
  command->add_flag("-i,--info", given->info, "Print the providers of a service, and its types")
      ->disable_flag_override();
  command->add_flag("--json", given->json, "Print JSON: the list as an array, the providers as an object, the reply")
      ->disable_flag_override();
  command
      ->add_option_function<std::string>(
          "-r,--req", [given](const std::string& text) { given->text = text; },
          "Call the service with this request, in protobuf's text format, and print the reply; without TEXT\n"
          "the request has only default values")
      ->type_name("[TEXT]")
      ->expected(0, 1);
  add("-s,--service", "SERVICE", "The service", given->service);
  add("--reqtype", "TYPE", "The request's type (the one that the service states)", given->requestType);
  add("--reptype", "TYPE", "The reply's type (the one that the service states)", given->replyType);
  add("--timeout", "MS", "Give up after MS milliseconds (1000 without such a service, 5000 for its reply)",
      given->timeout);
  command->add_flag("--as-gz", given->asGz)->disable_flag_override()->group("");
  addNetworkOption(*command);
  addSecureOption(*command);
  command->footer(
      "Examples:\n"
      "  pongsim service -l --json\n"
      "  pongsim service -i -s /world/pong_world/control\n"
      "  pongsim service -s /world/pong_world/control --req 'pause: true'\n"
      "  pongsim service -s /world/pong_world/control --reqtype ignition.msgs.WorldControl \\\n"
      "    --reptype ignition.msgs.Boolean --timeout 2000 --req 'pause: true, multi_step: 10'");
  command->callback([given, &work] {
    work = workFor(*given);
    setLogLevel(LogLevel::kError);
  });
}

}  // namespace pongsim::cli
