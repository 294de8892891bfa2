#include "sim/running/lockstep.hh"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

namespace pongsim::sim {

namespace {

// Longest wait without a look at what else the run has to do, such as to end.
constexpr std::chrono::milliseconds kSlice{10};
// Who is there is found some milliseconds before it has found the world's subscriptions, and what it sent until then
// would be lost. DDS tells nobody when that is done.
constexpr std::chrono::milliseconds kSettling{200};
// After this time a wait is reported, once.
constexpr std::chrono::seconds kLongWait{10};

std::vector<std::string> namesOf(const LockstepOptions& options) {
  std::vector<std::string> names;
  std::ranges::transform(options.topics, std::back_inserter(names), &LockstepOptions::Topic::name);
  return names;
}

std::string secondsOf(std::chrono::nanoseconds time) {
  std::ostringstream text;
  text << std::chrono::duration<double>(time).count() << " s";
  return text.str();
}

void addTo(std::string& text, const std::string& part) { text += (text.empty() ? "" : "; ") + part; }

}  // namespace

Lockstep::Lockstep(Simulation& simulation, LockstepOptions options)
    : simulation_(simulation),
      options_(std::move(options)),
      gate_(simulation.transport(), namesOf(options_)),
      wanted_(options_.topics.size()),
      late_(options_.topics.size()) {}

bool Lockstep::isDue(std::uint64_t step) const {
  if (passed_ == step) return false;
  return step == 0 ||
         std::ranges::any_of(options_.topics, [step](const auto& topic) { return step % topic.every == 0; });
}

/// Before the first step there are no messages to wait for: controllers answer to what the world has sent.
void Lockstep::want(std::uint64_t step) {
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    const LockstepOptions::Topic& topic = options_.topics[i];
    wanted_[i] = step > 0 && step % topic.every == 0 ? topic.count : 0;
  }
}

/// Takes late messages that have come, so that they do not count for the step that begins to wait.
void Lockstep::settleLate() {
  for (std::size_t i = 0; i < late_.size(); ++i) {
    if (wanted_[i] > 0) wanted_[i] += std::min<std::uint64_t>(std::exchange(late_[i], 0), gate_.waiting(i));
  }
}

bool Lockstep::isReady(Wait& wait) const {
  if (wait.step > 0) return gate_.isComplete(wanted_);
  if (!lacking(0).empty()) {
    wait.isThereSince.reset();
    return false;
  }
  const Clock::time_point now = Clock::now();
  if (!wait.isThereSince) wait.isThereSince = now;
  return areAllSending() || now - *wait.isThereSince >= kSettling;
}

Outcome<bool> Lockstep::takeIn(const Run& run) {
  std::optional<Wait> wait;
  while (run.goesOn()) {
    const std::uint64_t step = simulation_.iterations();
    if (!isDue(step)) {
      gate_.setPaused(false);
      simulation_.transport().dispatch();
      run.dispatched();
      return {true, {}};
    }
    // also after a reset
    if (!wait || wait->step != step) {
      wait = Wait{step};
      want(step);
      settleLate();
    }
    if (isReady(*wait)) return pass(step, run);
    const Outcome<bool> isOver = checkTime(*wait);
    if (!isOver) return isOver;
    if (*isOver.value) return pass(step, run);
    waitOnce(*wait, run);
  }
  return {false, {}};
}

void Lockstep::waitOnce(const Wait& wait, const Run& run) {
  std::chrono::nanoseconds slice = kSlice;
  if (options_.timeout)
    slice = std::min(slice, std::max(wait.begin + *options_.timeout - Clock::now(), Clock::duration(1)));
  if (wait.step == 0) {
    // as while paused: carriers find who is there within the systems' calls
    gate_.setPaused(true);
    simulation_.transport().dispatchFor(slice);
    run.dispatched();
    run.callSystems();
    return;
  }
  gate_.setPaused(false);
  // systems are called for requests that came by a carrier; not more often, since some publish by wall time
  const bool isWoken = gate_.wait(wanted_, slice);
  serve(run);
  if (isWoken) run.callSystems();
}

void Lockstep::serve(const Run& run) {
  if (gate_.serve(wanted_) > 0) run.served();
}

Outcome<bool> Lockstep::checkTime(Wait& wait) {
  const Clock::duration waited = Clock::now() - wait.begin;
  if (options_.timeout && waited >= *options_.timeout) {
    std::string what = lacking(wait.step);
    if (what.empty()) return {false, {}};
    what += " within " + secondsOf(*options_.timeout);
    if (!options_.goesOnWhenLate) return {std::nullopt, "lockstep: " + what};
    log_.warning(what + "; the run goes on, and does not repeat bit for bit");
    for (std::size_t i = 0; i < late_.size(); ++i) {
      late_[i] = wanted_[i] - std::min<std::uint64_t>(wanted_[i], gate_.waiting(i));
    }
    return {true, {}};
  }
  if (waited >= kLongWait && !std::exchange(wait.isReported, true)) {
    log_.warning("waiting since " + secondsOf(kLongWait) + ": " + lacking(wait.step));
  }
  return {false, {}};
}

Outcome<bool> Lockstep::pass(std::uint64_t step, const Run& run) {
  gate_.setPaused(false);
  passed_ = step;
  if (step == 0) {
    simulation_.transport().dispatch();
    run.dispatched();
    return {true, {}};
  }
  serve(run);
  gate_.pass(wanted_);
  run.dispatched();
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    if (gate_.waiting(i) <= kMostAhead) continue;
    const LockstepOptions::Topic& topic = options_.topics[i];
    return {std::nullopt, "lockstep: more than " + std::to_string(kMostAhead) + " messages wait on '" + topic.name +
                              "' after step " + std::to_string(step) + ": more come than the " +
                              std::to_string(topic.count) + " that are taken in every " + std::to_string(topic.every) +
                              " steps"};
  }
  return {true, {}};
}

/// Whether messages wait on each topic: controllers that have sent one are ready, whatever they hear.
bool Lockstep::areAllSending() const {
  for (std::size_t i = 0; i < options_.topics.size(); ++i) {
    if (gate_.waiting(i) == 0) return false;
  }
  return true;
}

/// @return What a step waits for; empty if nothing is missing.
std::string Lockstep::lacking(std::uint64_t step) const {
  std::string text;
  for (std::size_t i = 0; i < options_.topics.size(); ++i) {
    const std::string& name = options_.topics[i].name;
    const std::string publishers = gate_.publishers(name);
    if (step == 0) {
      // who has sent something is there
      if (publishers.empty() && gate_.waiting(i) == 0) addTo(text, "nobody publishes on '" + name + "'");
    } else if (gate_.waiting(i) < wanted_[i]) {
      const std::string many = wanted_[i] == 1 ? "no message on '" : "not enough messages on '";
      addTo(text, many + name + "' for step " + std::to_string(step) + " from " +
                      (publishers.empty() ? "anybody: nobody publishes there" : publishers));
    }
  }
  if (step > 0) return text;
  for (const std::string& topic : options_.heard) {
    if (!gate_.isHeard(topic)) addTo(text, "nobody subscribes to '" + topic + "'");
  }
  if (options_.heard.empty() && !areAllSending() && !gate_.isHeard(""))
    addTo(text, "nobody subscribes to the world's topics");
  return text;
}

}  // namespace pongsim::sim
