#include "cli/extension/optional_values.hh"

#include <CLI/App.hpp>
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace pongsim::cli {

namespace {

bool beginsNumber(const std::string& word) { return !word.empty() && word.front() >= '0' && word.front() <= '9'; }

/// @return `pongsim run`, if the words are for that command; else null.
const CLI::App* runCommandOf(const CLI::App& program, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front() != "run") return nullptr;
  const std::vector<const CLI::App*> commands = program.get_subcommands({});
  const auto run = std::ranges::find(commands, "run", &CLI::App::get_name);
  return run == commands.end() ? nullptr : *run;
}

bool mayLeaveOutItsValue(const CLI::App& command, const std::string& word) {
  if (!word.starts_with("--")) return false;
  const CLI::Option* const option = command.get_option_no_throw(word);
  // a flag takes no value at all
  return option != nullptr && option->get_expected_max() > 0 && option->get_expected_min() == 0;
}

}  // namespace

std::vector<std::string> withOptionalValuesLast(std::vector<std::string> arguments, const CLI::App& program) {
  const CLI::App* const command = runCommandOf(program, arguments);
  if (command == nullptr) return arguments;
  std::vector<std::string> first;
  std::vector<std::string> last;
  // nothing after it is an option
  const auto end = std::ranges::find(arguments, "--");
  const auto count = static_cast<std::size_t>(end - arguments.begin());
  for (std::size_t i = 0; i < count; ++i) {
    const bool hasValue = i + 1 < arguments.size() && beginsNumber(arguments[i + 1]);
    (mayLeaveOutItsValue(*command, arguments[i]) && !hasValue ? last : first).push_back(arguments[i]);
  }
  std::ranges::move(last, std::back_inserter(first));
  std::move(end, arguments.end(), std::back_inserter(first));
  return first;
}

}  // namespace pongsim::cli
