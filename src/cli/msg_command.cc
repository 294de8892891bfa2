#include <CLI/App.hpp>
#include <memory>
#include <optional>
#include <string>

#include "cli/command.hh"
#include "cli/console.hh"
#include "cli/message_option.hh"
#include "msgs/definition.hh"
#include "pongsim/message.hh"

namespace pongsim::cli {

namespace {

/// The command line as it was given.
struct Given {
  bool list = false;
  std::optional<std::string> type;
};

int listTypes() {
  std::string text;
  for (const std::string& type : messageTypes()) text += type + "\n";
  return print(text) ? kDone : kFailed;
}

Work workFor(const Given& given) {
  if (given.list == given.type.has_value()) {
    throw UsageError(given.list ? "one thing at a time" : "nothing to do given", "one of --list and --info TYPE");
  }
  if (given.list) return listTypes;
  const std::string type = messageTypeOption(*given.type);
  return [type] { return print("// " + type + "\n" + msgs::definition(type).value_or("")) ? kDone : kFailed; };
}

}  // namespace

void addMsgCommand(CLI::App& program, Work& work) {
  const auto given = std::make_shared<Given>();
  CLI::App* command = program.add_subcommand("msg", "List message types, print how one is made up");
  command->set_help_flag("-h,--help", "Print this and end");
  command->add_flag("-l,--list", given->list, "Print the message types, sorted")->disable_flag_override();
  command
      ->add_option_function<std::string>(
          "-i,--info", [given](const std::string& text) { given->type = text; },
          "Print the type's definition: ignition.msgs.Twist, gz.msgs.Twist or Twist")
      ->type_name("TYPE");
  command->footer(
      "Examples:\n"
      "  pongsim msg -l\n"
      "  pongsim msg -i ignition.msgs.Twist");
  command->callback([given, &work] { work = workFor(*given); });
}

}  // namespace pongsim::cli
