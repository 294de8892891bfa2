#include "cli/run/lockstep_arguments.hh"

#include <CLI/App.hpp>
#include <algorithm>
#include <chrono>
#include <vector>

#include "cli/options/number_option.hh"
#include "pongsim/node.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

std::string checkedTopic(const char* option, std::string_view name) {
  if (const auto error = topicNameError(name)) {
    throw UsageError("option '" + std::string(option) + "' names a topic, and '" + std::string(name) + "' " + *error);
  }
  return std::string(name);
}

}  // namespace

void LockstepArguments::addTo(CLI::App& run) {
  constexpr const char* kGroup = "Lockstep";
  run.add_option_function<std::vector<std::string>>(
         "--lockstep",
         [this](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
             Outcome<LockstepOptions::Topic> topic = lockstepTopic(text);
             if (!topic) throw UsageError("option '--lockstep': " + topic.error);
             options_.topics.push_back(*std::move(topic.value));
           }
         },
         "After each EVERY steps (1), wait for COUNT messages (1) of a controller on TOPIC;\n"
         "the option can be repeated")
      ->type_name("TOPIC[:EVERY[:COUNT]]")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group(kGroup);
  run.add_option_function<std::vector<std::string>>(
         "--lockstep-start",
         [this](const std::vector<std::string>& names) {
           dependent_ = "--lockstep-start";
           for (const std::string& name : names) options_.heard.push_back(checkedTopic("--lockstep-start", name));
         },
         "Before the first step, wait until somebody subscribes to TOPIC (to any topic);\nthe option can be repeated")
      ->type_name("TOPIC")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group(kGroup);
  run.add_option_function<std::string>(
         "--lockstep-timeout",
         [this](const std::string& text) {
           dependent_ = "--lockstep-timeout";
           const double seconds = numberFromZero(dependent_, text, "a number of seconds");
           // a year is practically for ever, and within the clock's range
           options_.timeout = std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::duration<double>(std::min(seconds, static_cast<double>(kLongestMs) * 1e-3)));
         },
         "Longest wait in seconds of wall time (for ever)")
      ->type_name("S")
      ->group(kGroup);
  run.add_option_function<std::string>(
         "--lockstep-late",
         [this](const std::string& text) {
           dependent_ = "--lockstep-late";
           if (text != "end" && text != "continue") {
             throw UsageError("option '--lockstep-late' takes end or continue, not '" + text + "'");
           }
           options_.goesOnWhenLate = text == "continue";
         },
         "After that, end with code 1, or continue without the message: end, continue (end)")
      ->type_name("WHAT")
      ->group(kGroup);
}

std::optional<LockstepOptions> LockstepArguments::check() const {
  if (!options_.topics.empty()) return options_;
  if (!dependent_.empty()) {
    throw UsageError("option '" + dependent_ + "' needs '--lockstep'", "pongsim run WORLD --lockstep /cmd_vel");
  }
  return std::nullopt;
}

}  // namespace pongsim::cli
