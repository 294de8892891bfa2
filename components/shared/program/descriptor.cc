#include "shared/program/descriptor.hh"

#include <CLI/App.hpp>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace pongsim::cli {

namespace {

using Json = nlohmann::ordered_json;

/// @return The options with two hyphens, except for `--help` and hidden ones.
Json optionsOf(const CLI::App& action) {
  Json options = Json::array();
  for (const CLI::Option* option : action.get_options()) {
    if (option == action.get_help_ptr() || option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) {
      Json& added = options.emplace_back();
      added["option"] = "--" + name;
      if (const std::string value = option->get_type_name(); !value.empty()) added["value"] = value;
      added["help"] = option->get_description();
    }
  }
  return options;
}

}  // namespace

std::string descriptorWithActions(const std::string& file, const CLI::App& program) {
  std::ifstream stream(file);
  Json descriptor = Json::parse(stream);
  Json& actions = descriptor["command"]["actions"] = Json::array();
  for (const CLI::App* action : program.get_subcommands({})) {
    if (action->get_group().empty()) continue;
    std::string help = action->get_description();
    // it is broken into lines for a terminal
    std::ranges::replace(help, '\n', ' ');
    actions.push_back({{"name", action->get_name()}, {"help", help}, {"options", optionsOf(*action)}});
  }
  return descriptor.dump(2) + "\n";
}

}  // namespace pongsim::cli
