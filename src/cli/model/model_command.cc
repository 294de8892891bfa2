#include "cli/model/model_command.hh"

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <utility>

#include "cli/command.hh"
#include "cli/options/network_option.hh"
#include "cli/options/number_option.hh"
#include "cli/options/secure_option.hh"
#include "pongsim/log.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// The parsed command line.
struct ModelCommandLine {
  bool list = false, pose = false, json = false, follow = false, asIgn = false;
  std::optional<std::string> model, link, joint, sensor, count, world, timeout;
};

Work workFor(const ModelCommandLine& given) {
  if (given.list == given.model.has_value()) {
    throw UsageError(given.list ? "only one action at a time" : "no action given", "one of --list and --model NAME");
  }
  const std::pair<const char*, bool> parts[] = {{"-p", given.pose},
                                                {"-l", given.link.has_value()},
                                                {"-j", given.joint.has_value()},
                                                {"-s", given.sensor.has_value()}};
  for (const auto& [option, isGiven] : parts) {
    if (given.list && isGiven) {
      throw UsageError("option '" + std::string(option) + "' can't be used with '--list'", "use it with -m");
    }
  }
  if (given.count && !given.follow) throw UsageError("option '-n' needs '--follow'");
  if (given.model && given.model->empty()) throw UsageError("option '-m' needs a model's name");
  if (given.world && given.world->empty()) throw UsageError("option '-w' needs a world's name");
  ModelOptions options;
  options.model = given.model.value_or("");
  options.parts = {given.pose, given.link, given.joint, given.sensor};
  options.json = given.json;
  options.namesWorld = given.asIgn && !given.json;
  options.follows = given.follow;
  if (given.count) options.count = wholeNumber("-n", *given.count, 1);
  options.world = given.world.value_or("");
  if (given.timeout) {
    options.timeout = std::chrono::milliseconds(wholeNumber("--timeout", *given.timeout, 0, kLongestMs));
  }
  return [options] { return showModels(options); };
}

}  // namespace

void addModelCommand(CLI::App& program, Work& work) {
  const auto given = std::make_shared<ModelCommandLine>();
  CLI::App* command = program.add_subcommand("model", "List the models of a running world, describe one");
  const auto add = [command](const char* names, const char* value, const char* description,
                             std::optional<std::string>& target) {
    const auto keep = [&target](const std::string& text) { target = text; };
    return command->add_option_function<std::string>(names, keep, description)->type_name(value);
  };
  const auto addFlag = [command](const char* names, bool& target, const char* description) {
    command->add_flag(names, target, description)->disable_flag_override();
  };
  addFlag("--list", given->list, "Print the names of the models");
  add("-m,--model", "NAME", "Describe that model: everything, or what the next four options select", given->model);
  addFlag("-p,--pose", given->pose, "Its pose");
  add("-l,--link", "NAME", "Its links, or one: mass, inertia, pose, sensors", given->link)->expected(0, 1);
  add("-j,--joint", "NAME", "Its joints, or one: type, links, pose, axes", given->joint)->expected(0, 1);
  add("-s,--sensor", "NAME", "Its sensors with their links, or one: pose, settings", given->sensor)->expected(0, 1);
  addFlag("--follow", given->follow, "Print ten times a second, until Ctrl-C");
  add("-n,--num", "N", "With --follow: exit after printing N times", given->count);
  addFlag("--json", given->json, "Print JSON: an array of all models, or one object per line");
  add("-w,--world", "WORLD", "The world's name, if several run (the first one of its process)", given->world);
  add("--timeout", "MS", "Give up after MS milliseconds (1000) without a world or its response", given->timeout);
  command->add_flag("--as-ign", given->asIgn)->disable_flag_override()->group("");
  addNetworkOption(*command);
  addSecureOption(*command);
  command->footer(
      "Units are metres, radians and kilograms. Poses are relative to the parent, a joint's to its child link.\n"
      "Examples:\n"
      "  pongsim model --list\n"
      "  pongsim model -m pong_bot\n"
      "  pongsim model -m pong_bot --pose --follow\n"
      "  pongsim model -m pong_bot --link chassis --json");
  command->callback([given, &work] {
    work = workFor(*given);
    setLogLevel(LogLevel::kError);
  });
}

}  // namespace pongsim::cli
