#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/stop_signal.hh"
#include "cli/topic/topic_command.hh"
#include "cli/world/world_command.hh"
#include "cli/world/world_finder.hh"
#include "cli/world/world_info.hh"
#include "cli/world/world_state.hh"
#include "msgs/control/control_messages.hh"
#include "msgs/control/status_messages.hh"
#include "pongsim/node.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

using Clock = std::chrono::steady_clock;

/// Maximum length of a wait before other things are checked.
constexpr std::chrono::milliseconds kLongestDispatch{20};

std::string statisticsText(const msgs::Status& status) {
  char line[160];
  std::snprintf(line, sizeof line, "simulated %.3f s, real %.3f s, factor %.3f, %llu iterations, %s\n",
                toSeconds(status.simulated), toSeconds(status.real), status.realTimeFactor,
                static_cast<unsigned long long>(status.iterations), status.paused ? "paused" : "running");
  return line;
}

std::string statisticsJson(const msgs::Status& status) {
  const nlohmann::ordered_json json = {{"simulated", toSeconds(status.simulated)},
                                       {"real", toSeconds(status.real)},
                                       {"factor", status.realTimeFactor},
                                       {"iterations", status.iterations},
                                       {"paused", status.paused}};
  return json.dump() + "\n";
}

class WorldControl {
 public:
  explicit WorldControl(const WorldOptions& options) : options_(options) {}
  int run();

 private:
  bool findWorld();
  std::string nameOf(const char* what) const;
  bool ask(const msgs::WorldControl& control);
  bool step();
  bool reset();
  bool showStatistics();
  void showInfo();
  template <class Done>
  bool waitForStatus(Done done);
  void fail(const std::string& message, const std::string& hint = {}) { exitCode_ = cli::fail(message, hint); }

  const WorldOptions& options_;
  // before the transport, whose threads inherit the signal mask
  StopSignal signal_;
  Transport transport_;
  std::string world_;
  msgs::Status status_;
  int exitCode_ = kDone;
};

int WorldControl::run() {
  const StopSignal::Callback wake(signal_, [this] { transport_.wake(); });
  if (findWorld()) {
    switch (options_.action) {
      case WorldAction::kPause:
        ask({.pause = true});
        break;
      case WorldAction::kPlay:
        ask({.pause = false});
        break;
      case WorldAction::kStep:
        step();
        break;
      case WorldAction::kReset:
        reset();
        break;
      case WorldAction::kStats:
        showStatistics();
        break;
      case WorldAction::kInfo:
        showInfo();
        break;
    }
  }
  return exitCode_;
}

bool WorldControl::findWorld() {
  const std::optional<std::string> found = cli::findWorld(transport_, signal_, options_.world, options_.timeout);
  if (found) world_ = *found;
  if (!found) exitCode_ = kFailed;
  return found.has_value();
}

/// @return The name of one of the world's topics or services.
std::string WorldControl::nameOf(const char* what) const { return "/world/" + world_ + "/" + what; }

/// @return Whether the world did it; reports the reason if not.
bool WorldControl::ask(const msgs::WorldControl& control) {
  const MessagePointer request = msgs::worldControlMessage(control);
  const MessagePointer reply = newMessage("ignition.msgs.Boolean");
  const CallResult result = transport_.node().call(nameOf("control"), *request, *reply, options_.timeout);
  if (!result) {
    fail(result.error);
  } else if (!msgs::boolean(*reply)) {
    // other simulators don't say why; ours do
    fail("world '" + world_ + "' refused");
  }
  return exitCode_ == kDone;
}

/// Listens to the run's status until `done` returns true after a message, or the user stops it.
/// @return False, after reporting it, if nothing was heard for the timeout.
template <class Done>
bool WorldControl::waitForStatus(Done done) {
  bool over = false;
  Clock::time_point lastHeard = Clock::now();
  const Subscription subscription =
      transport_.node().subscribe(nameOf("stats"), "ignition.msgs.WorldStatistics", [&](const Message& message) {
        if (over) return;
        status_ = msgs::statusOf(message);
        lastHeard = Clock::now();
        over = done();
      });
  while (!over && !signal_.stopped() && !outputIsClosed()) {
    transport_.dispatchFor(kLongestDispatch);
    if (over || Clock::now() - lastHeard < std::max<Clock::duration>(options_.timeout, kArrivalTime)) {
      continue;
    }
    fail("no more messages from world '" + world_ + "'");
    return false;
  }
  return true;
}

/// Pauses, steps, and returns when the steps are done.
bool WorldControl::step() {
  if (!ask({.pause = true}) || !waitForStatus([this] { return status_.paused; })) return false;
  const std::uint64_t end = status_.iterations + options_.steps;
  return ask({.pause = true, .steps = options_.steps}) && waitForStatus([&] { return status_.iterations >= end; });
}

/// Afterwards it is running or paused as last reported.
bool WorldControl::reset() {
  return waitForStatus([] { return true; }) &&
         ask({.pause = status_.paused, .reset = msgs::Reset::kAll, .seed = options_.seed.value_or(0)});
}

bool WorldControl::showStatistics() {
  std::uint64_t shown = 0;
  return waitForStatus([&] {
    if (!print(options_.json ? statisticsJson(status_) : statisticsText(status_))) {
      exitCode_ = outputIsClosed() ? kDone : kFailed;
      return true;
    }
    return ++shown == options_.lines;
  });
}

void WorldControl::showInfo() {
  const MessagePointer state = askForState(transport_, world_, options_.timeout);
  if (state == nullptr || !print(worldInfo(*state, options_.json))) exitCode_ = kFailed;
}

}  // namespace

int controlWorld(const WorldOptions& options) { return WorldControl(options).run(); }

}  // namespace pongsim::cli
