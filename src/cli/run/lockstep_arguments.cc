#include "cli/run/lockstep_arguments.hh"

#include <CLI/App.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <vector>

#include "base/nearest_word.hh"
#include "cli/options/number_option.hh"
#include "pongsim/node.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

constexpr const char* kOption = "--lockstep";

std::string checkedTopic(const char* option, std::string_view name) {
  if (const auto error = topicNameError(name)) {
    throw UsageError("option '" + std::string(option) + "' names a topic, and '" + std::string(name) + "' " + *error);
  }
  return std::string(name);
}

/// Takes ":N" off the end of `text`, if it ends so.
std::optional<std::uint64_t> takeNumber(std::string_view& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || colon == 0) return std::nullopt;
  const std::string_view digits = text.substr(colon + 1);
  if (digits.empty() || !std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; })) return std::nullopt;
  text = text.substr(0, colon);
  return wholeNumber(kOption, digits, 1);
}

/// Adds a sentence if no topic of the world has that name in that role.
void addUnknown(const std::string& topic, const std::vector<OwnTopic>& own, int OwnTopic::*users,
                const std::string& what, std::vector<std::string>& sentences) {
  const std::string name = topic.starts_with('/') ? topic : "/" + topic;
  std::vector<std::string_view> names;
  for (const OwnTopic& each : own) {
    // the lockstep's own subscriptions are to any type
    if (each.*users > 0 && each.type != "*") names.push_back(each.name);
  }
  if (std::ranges::find(names, name) != names.end()) return;
  const std::string hint = base::didYouMean(name, names);
  sentences.push_back("no system of the world " + what + " '" + name + "'" + (hint.empty() ? "" : ": " + hint));
}

}  // namespace

sim::LockstepOptions::Topic lockstepTopic(std::string_view text) {
  std::string_view name = text;
  const std::optional<std::uint64_t> last = takeNumber(name);
  const std::optional<std::uint64_t> before = last ? takeNumber(name) : std::nullopt;
  sim::LockstepOptions::Topic topic;
  topic.name = checkedTopic(kOption, name);
  topic.every = before ? *before : last.value_or(1);
  topic.count = before ? *last : 1;
  if (topic.count > sim::Lockstep::kMostAhead) {
    throw UsageError("option '--lockstep' takes at most " + std::to_string(sim::Lockstep::kMostAhead) +
                     " messages at once, not " + std::to_string(topic.count));
  }
  return topic;
}

void LockstepArguments::addTo(CLI::App& run) {
  constexpr const char* kGroup = "Lockstep";
  run.add_option_function<std::vector<std::string>>(
         kOption,
         [this](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) options_.topics.push_back(lockstepTopic(text));
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

std::optional<sim::LockstepOptions> LockstepArguments::check() const {
  if (!options_.topics.empty()) return options_;
  if (!dependent_.empty()) {
    throw UsageError("option '" + dependent_ + "' needs '--lockstep'", "pongsim run WORLD --lockstep /cmd_vel");
  }
  return std::nullopt;
}

std::vector<std::string> unknownTopics(const sim::LockstepOptions& options, const Node& node) {
  const std::vector<OwnTopic> own = node.ownTopics();
  std::vector<std::string> sentences;
  for (const auto& topic : options.topics) {
    addUnknown(topic.name, own, &OwnTopic::subscriptions, "subscribes to", sentences);
  }
  for (const std::string& name : options.heard) {
    addUnknown(name, own, &OwnTopic::publishers, "publishes on", sentences);
  }
  return sentences;
}

}  // namespace pongsim::cli
