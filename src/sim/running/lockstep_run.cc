#include "pongsim/lockstep_run.hh"

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/nearest_word.hh"
#include "sim/inputs/inside.hh"
#include "sim/running/lockstep.hh"

namespace pongsim {

namespace {

/// Takes ":N" off the end of `text`, if it ends so.
std::optional<std::string_view> takeDigits(std::string_view& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || colon == 0) return std::nullopt;
  const std::string_view digits = text.substr(colon + 1);
  if (digits.empty() || !std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; })) return std::nullopt;
  text = text.substr(0, colon);
  return digits;
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

Outcome<LockstepOptions::Topic> lockstepTopic(std::string_view text) {
  std::string_view name = text;
  const std::optional<std::string_view> last = takeDigits(name);
  const std::optional<std::string_view> before = last ? takeDigits(name) : std::nullopt;
  if (const auto error = topicNameError(name)) return {{}, "'" + std::string(name) + "' " + *error};
  LockstepOptions::Topic topic{std::string(name)};
  std::string_view wrong;
  const auto read = [&wrong](std::string_view digits, std::uint64_t& number) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || number == 0) wrong = digits;
  };
  if (last) read(before.value_or(*last), topic.every);
  if (before) read(*last, topic.count);
  if (!wrong.empty()) {
    return {{}, "'" + std::string(text) + "' has '" + std::string(wrong) + "' where a whole number from 1 belongs"};
  }
  if (topic.count > sim::Lockstep::kMostAhead) {
    return {{},
            "at most " + std::to_string(sim::Lockstep::kMostAhead) + " messages can be taken in at once, not " +
                std::to_string(topic.count)};
  }
  return {topic, {}};
}

std::vector<std::string> unknownLockstepTopics(const LockstepOptions& options, const Node& node) {
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

struct LockstepRun::Parts {
  Simulation& simulation;
  sim::Lockstep lockstep;
};

LockstepRun::LockstepRun(Simulation& simulation, LockstepOptions options)
    : parts_(new Parts{simulation, sim::Lockstep(simulation, std::move(options))}) {
  // until the first step, requests are handled whenever they come
  parts_->lockstep.pause();
}

LockstepRun::~LockstepRun() = default;

Outcome<bool> LockstepRun::step(const std::function<bool()>& goesOn) {
  Simulation& simulation = parts_->simulation;
  Outcome<bool> taken = parts_->lockstep.takeIn(
      {.goesOn = goesOn, .callSystems = [&] { sim::Inside::advance(simulation, Time::zero()); }});
  if (taken && *taken.value) sim::Inside::advance(simulation, simulation.stepSize());
  return taken;
}

}  // namespace pongsim
