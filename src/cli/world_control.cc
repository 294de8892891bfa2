#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "base/nearest_word.hh"
#include "cli/console.hh"
#include "cli/stop_signal.hh"
#include "cli/topic_command.hh"
#include "cli/world_command.hh"
#include "msgs/control_messages.hh"
#include "msgs/status_messages.hh"
#include "pongsim/node.hh"

namespace pongsim::cli {

namespace {

using Clock = std::chrono::steady_clock;

/// How long a wait may last before the rest of the world is looked at.
constexpr std::chrono::milliseconds kLongestDispatch{20};

constexpr std::string_view kBefore = "/world/", kAfter = "/control";

/// @return The names of the worlds that can be controlled, as they stand in topics.
std::vector<std::string> worldsOf(const std::vector<ServiceInfo>& services) {
  std::vector<std::string> worlds;
  for (const ServiceInfo& service : services) {
    const std::string_view name = service.name;
    if (name.size() <= kBefore.size() + kAfter.size() || !name.starts_with(kBefore) || !name.ends_with(kAfter))
      continue;
    const std::string_view world = name.substr(kBefore.size(), name.size() - kBefore.size() - kAfter.size());
    if (world.find('/') == std::string_view::npos) worlds.emplace_back(world);
  }
  return worlds;
}

class WorldControl {
 public:
  explicit WorldControl(const WorldOptions& options) : options_(options) {}
  int run();

 private:
  bool findWorld();
  bool ask(const msgs::WorldControl& control);
  bool step();
  bool reset();
  bool showStatistics();
  template <class Done>
  bool waitForStatus(Done done);
  void fail(const std::string& message, const std::string& hint = {}) { exitCode_ = cli::fail(message, hint); }

  const WorldOptions& options_;
  // before the transport, whose threads inherit the signals' mask
  StopSignal signal_;
  Transport transport_;
  std::string world_;
  msgs::Status status_;
  int exitCode_ = kDone;
};

int WorldControl::run() {
  signal_.onStop([this] { transport_.wake(); });
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
    }
  }
  signal_.onStop({});
  return exitCode_;
}

/// @return Whether there is the world asked for, or one alone; says why where not.
bool WorldControl::findWorld() {
  const std::string wanted = cleanTopic(options_.world);
  const Clock::time_point deadline = Clock::now() + options_.timeout;
  std::vector<std::string> worlds;
  while (true) {
    worlds = worldsOf(transport_.discoverServices(kDiscoveryTime));
    const bool found = wanted.empty() ? !worlds.empty() : std::ranges::count(worlds, wanted) > 0;
    if (found || signal_.stopped() || Clock::now() >= deadline) break;
    transport_.dispatchFor(kLongestDispatch);
  }
  if (worlds.empty()) {
    fail("no world runs", "start one with pongsim run WORLD");
  } else if (!wanted.empty() && std::ranges::count(worlds, wanted) == 0) {
    fail("no world '" + options_.world + "' runs",
         base::didYouMean(wanted, std::vector<std::string_view>(worlds.begin(), worlds.end())));
  } else if (wanted.empty() && worlds.size() > 1) {
    std::string names;
    for (const std::string& world : worlds) names += (names.empty() ? "" : ", ") + world;
    fail("several worlds run: " + names, "choose with -w WORLD");
  } else {
    world_ = wanted.empty() ? worlds.front() : wanted;
  }
  return !world_.empty();
}

/// @return Whether the world did it; says why where not.
bool WorldControl::ask(const msgs::WorldControl& control) {
  const MessagePointer request = msgs::worldControlMessage(control);
  const MessagePointer reply = newMessage("ignition.msgs.Boolean");
  const std::string service = std::string(kBefore) + world_ + std::string(kAfter);
  const CallResult result = transport_.node().call(service, *request, *reply, options_.timeout);
  if (!result) {
    fail(result.error);
  } else if (!msgs::boolean(*reply)) {
    // not of ours, which say why
    fail("world '" + world_ + "' refused");
  }
  return exitCode_ == kDone;
}

/// Hears where the run stands until `done` says so after a message, or the user ends it.
/// @return False, after saying so, where nothing was heard for the time-out.
template <class Done>
bool WorldControl::waitForStatus(Done done) {
  bool over = false;
  Clock::time_point lastHeard = Clock::now();
  const Subscription subscription = transport_.node().subscribe(
      std::string(kBefore) + world_ + "/stats", "ignition.msgs.WorldStatistics", [&](const Message& message) {
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
    fail("nothing heard of world '" + world_ + "' any more");
    return false;
  }
  return true;
}

/// Pauses, steps, and returns when the steps are made.
bool WorldControl::step() {
  if (!ask({.pause = true}) || !waitForStatus([this] { return status_.paused; })) return false;
  const std::uint64_t end = status_.iterations + options_.steps;
  return ask({.pause = true, .steps = options_.steps}) && waitForStatus([&] { return status_.iterations >= end; });
}

/// As it was told last, running or paused, it is afterwards.
bool WorldControl::reset() {
  return waitForStatus([] { return true; }) && ask({.pause = status_.paused, .reset = msgs::Reset::kAll});
}

bool WorldControl::showStatistics() {
  std::uint64_t shown = 0;
  return waitForStatus([&] {
    char line[160];
    std::snprintf(line, sizeof line, "simulated %.3f s, real %.3f s, factor %.3f, %llu iterations, %s\n",
                  toSeconds(status_.simulated), toSeconds(status_.real), status_.realTimeFactor,
                  static_cast<unsigned long long>(status_.iterations), status_.paused ? "paused" : "running");
    if (!print(line)) {
      exitCode_ = outputIsClosed() ? kDone : kFailed;
      return true;
    }
    return ++shown == options_.lines;
  });
}

}  // namespace

int controlWorld(const WorldOptions& options) { return WorldControl(options).run(); }

}  // namespace pongsim::cli
