#include <CLI/App.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "cli/command.hh"
#include "cli/fortress/gz_types.hh"
#include "cli/options/message_option.hh"
#include "cli/own_folder.hh"
#include "msgs/encoding/message_template.hh"
#include "msgs/types/definition.hh"
#include "pongsim/message.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// The parsed command line.
struct MsgCommandLine {
  bool list = false, json = false, asIgn = false, asGz = false;
  std::optional<std::string> infoType, templateType;
};

/// The type's name as written by `ign msg`.
std::string ignName(const std::string& type) {
  constexpr std::string_view kPrefix = "ignition.msgs.";
  return type.starts_with(kPrefix) ? "ign_msgs." + type.substr(kPrefix.size()) : type;
}

int listTypes(const MsgCommandLine& given) {
  const bool asJson = given.json;
  std::string text;
  if (asJson) text = nlohmann::ordered_json(messageTypes()).dump() + "\n";
  for (const std::string& type : messageTypes()) {
    if (!asJson) text += (given.asIgn ? ignName(type) : type) + "\n";
  }
  return print(withTypeNames(text, given.asGz)) ? kDone : kFailed;
}

Work workFor(const MsgCommandLine& given) {
  if (int{given.list} + int{given.infoType.has_value()} + int{given.templateType.has_value()} != 1) {
    throw UsageError(given.list || given.infoType ? "only one action at a time" : "no action given",
                     "one of --list, --info TYPE and --template TYPE");
  }
  if (given.list) return [&given] { return listTypes(given); };
  const std::string type = messageTypeOption(given.infoType ? *given.infoType : *given.templateType);
  const bool asGazebo = given.asIgn || given.asGz;
  const std::string head =
      asGazebo ? "Name: " + type + "\nFile: " + msgs::definitionFile(type).value_or("") + "\n\n" : "// " + type + "\n";
  // without comments, like `ign` and `gz`
  const auto comments = asGazebo ? std::filesystem::path() : ownFolder() / "message_comments";
  const std::string text =
      given.infoType ? head + msgs::definition(type, comments).value_or("") : msgs::messageTemplate(type).value_or("");
  const nlohmann::ordered_json json = {{"type", type}, {given.infoType ? "definition" : "template", text}};
  return [shown = withTypeNames(given.json ? json.dump() + "\n" : text, given.asGz)] {
    return print(shown) ? kDone : kFailed;
  };
}

}  // namespace

void addMsgCommand(CLI::App& program, Work& work) {
  const auto given = std::make_shared<MsgCommandLine>();
  CLI::App* command = program.add_subcommand("msg", "List message types, print the definition of one");
  command->add_flag("-l,--list", given->list, "Print the message types, sorted")->disable_flag_override();
  command->add_flag("--json", given->json, "Print JSON: the list as an array, or an object with the type and its text")
      ->disable_flag_override();
  const auto add = [command](const char* names, const char* description, std::optional<std::string>& target) {
    const auto keep = [&target](const std::string& text) { target = text; };
    command->add_option_function<std::string>(names, keep, description)->type_name("TYPE");
  };
  add("-i,--info", "Print the type's definition: ignition.msgs.Twist, gz.msgs.Twist or Twist", given->infoType);
  add("-t,--template", "Print a template of a message of the type", given->templateType);
  command->add_flag("--as-ign", given->asIgn)->disable_flag_override()->group("");
  command->add_flag("--as-gz", given->asGz)->disable_flag_override()->group("");
  command->footer(
      "Examples:\n"
      "  pongsim msg -l\n"
      "  pongsim msg -i ignition.msgs.Twist\n"
      "  pongsim msg -t ignition.msgs.Twist > twist.txt");
  command->callback([given, &work] { work = workFor(*given); });
}

}  // namespace pongsim::cli
