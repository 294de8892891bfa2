#include "sim/running/run_history.hh"

#include <algorithm>
#include <iterator>
#include <string>

#include "msgs/control/control_messages.hh"
#include "pongsim/simulation.hh"

namespace pongsim::sim {

namespace {

constexpr const char* kRangeType = "ignition.msgs.LogPlaybackStatistics";
constexpr std::chrono::milliseconds kRangePeriod{100};

}  // namespace

RunHistory::RunHistory(Simulation& simulation, bool isKept) : simulation_(simulation), range_(newMessage(kRangeType)) {
  if (!isKept || !simulation.hasPhysics()) return;
  publisher_ = simulation.transport().node().advertise(
      cleanTopic("/world/" + std::string(simulation.world().name()) + "/playback/stats"), kRangeType,
      {.ownOnly = true});
}

void RunHistory::stepped() {
  if (!publisher_.hasSubscribers()) {
    forget();
    return;
  }
  const Time now = simulation_.time();
  while (!states_.empty() && states_.back().time > now) states_.pop_back();
  if (states_.empty() || now >= states_.back().time + kInterval) keep();
}

void RunHistory::keep() {
  states_.push_back({simulation_.time(), simulation_.saveState()});
  std::size_t bytes = 0;
  for (const State& state : states_) bytes += state.bytes.size();
  while (states_.size() > kMostStates || (bytes > kMostBytes && states_.size() > 1)) {
    bytes -= states_.front().bytes.size();
    states_.pop_front();
  }
}

void RunHistory::publishRange(std::chrono::steady_clock::time_point now) {
  if (now < next_ || !publisher_.hasSubscribers()) return;
  next_ = now + kRangePeriod;
  const Time present = simulation_.time();
  const Time first = states_.empty() ? present : std::min(present, states_.front().time);
  msgs::setLogPlaybackStatistics(first, states_.empty() ? present : std::max(present, states_.back().time), *range_);
  publisher_.publish(*range_);
}

Outcome<void> RunHistory::goTo(Time time) {
  const auto after = std::ranges::upper_bound(states_, time, {}, &State::time);
  if (after == states_.begin()) {
    return {"no state of that time is kept: the last minute is, while somebody listens to /world/" +
            std::string(simulation_.world().name()) + "/playback/stats and the run's inputs are not recorded"};
  }
  Outcome<void> restored = simulation_.restoreState(std::prev(after)->bytes);
  if (!restored) states_.erase(states_.begin(), after);
  return restored;
}

}  // namespace pongsim::sim
