#include "sim/running/runner.hh"

#include <sys/prctl.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "msgs/control/status_messages.hh"
#include "sim/running/real_time_factor.hh"
#include "sim/running/run_control.hh"
#include "sim/running/run_history.hh"
#include "sim/running/run_services.hh"
#include "sim/running/status_publisher.hh"

namespace pongsim::sim {

namespace {

using Clock = std::chrono::steady_clock;

// Longest sleep between two checks of `stopping_`.
constexpr std::chrono::milliseconds kLongestWait{50};
// Largest delay behind the schedule that is made up for; a longer one moves the schedule.
constexpr std::chrono::milliseconds kLargestDebt{20};
// Interval at which a paused run handles messages and topics, even if no message arrives.
constexpr std::chrono::milliseconds kPausedPeriod{10};

/// @return Wall time per step; zero: as fast as possible.
Clock::duration stepPeriod(const Simulation& simulation, const RunOptions& options) {
  double seconds = 0;
  if (options.updateRate) {
    seconds = *options.updateRate > 0 ? 1 / *options.updateRate : 0;
  } else if (simulation.realTimeFactor() > 0) {
    seconds = toSeconds(simulation.stepSize()) / simulation.realTimeFactor();
  }
  // limited to a day, because longer times may not fit the clock's type
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::min(seconds, 86400.0)));
}

/// Sleeps until `time`, or until a signal arrives.
void sleepUntil(Clock::time_point time) {
  const auto sinceEpoch = time.time_since_epoch();
  const auto seconds = std::chrono::floor<std::chrono::seconds>(sinceEpoch);
  timespec until{};
  until.tv_sec = seconds.count();
  until.tv_nsec = std::chrono::nanoseconds(sinceEpoch - seconds).count();
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
}

}  // namespace

struct Runner::Parts {
  Parts(Simulation& s, const RunOptions& o, ResourceServices::FolderAdded folderAdded)
      : simulation(s),
        iterations(o.iterations.value_or(std::numeric_limits<std::uint64_t>::max())),
        options(o),
        status(std::in_place, s.transport(), std::string(s.world().name()), static_cast<bool>(folderAdded)),
        control(o.paused),
        history(std::in_place, s, !o.observe),
        services(std::in_place, s, control, *history, std::move(folderAdded)) {
    if (options.observe) observer = options.observe(s);
    if (o.lockstep) lockstep.emplace(s, *o.lockstep);
  }

  void publishStatus(Clock::time_point now) {
    status->publish({.simulated = simulation.time(),
                     .real = real,
                     .system = std::chrono::system_clock::now().time_since_epoch(),
                     .iterations = simulation.iterations(),
                     .realTimeFactor = factor.value(),
                     .paused = control.paused()},
                    now);
    history->publishRange(now);
  }

  Simulation& simulation;
  const std::uint64_t iterations;
  const RunOptions options;
  std::optional<StatusPublisher> status;
  RunControl control;
  std::optional<RunHistory> history;
  std::optional<RunServices> services;
  std::unique_ptr<RunObserver> observer;
  std::optional<Lockstep> lockstep;
  RealTimeFactor factor;
  std::chrono::nanoseconds real{0};
  std::uint64_t made = 0;
};

Runner::Runner(Simulation& simulation, const RunOptions& options, ResourceServices::FolderAdded folderAdded)
    : parts_(std::make_unique<Parts>(simulation, options, std::move(folderAdded))) {}

Runner::~Runner() = default;

void Runner::leave() {
  parts_->observer.reset();
  parts_->lockstep.reset();
  parts_->services.reset();
  parts_->history.reset();
  parts_->status.reset();
}

void Runner::post(std::function<void(Simulation&)> task) {
  const std::lock_guard lock(tasksMutex_);
  tasks_.push_back(std::move(task));
  hasTasks_ = true;
}

void Runner::doTasks() {
  if (!hasTasks_.load(std::memory_order_relaxed)) return;
  std::vector<std::function<void(Simulation&)>> tasks;
  {
    const std::lock_guard lock(tasksMutex_);
    tasks.swap(tasks_);
    hasTasks_ = false;
  }
  for (const auto& task : tasks) task(parts_->simulation);
}

void Runner::addFolder(const std::filesystem::path& folder) {
  post([this, folder](Simulation& simulation) {
    simulation.addResourceFolder(folder);
    if (parts_->observer) parts_->observer->folderAdded(folder);
  });
}

void Runner::dispatched() {
  if (parts_->observer) parts_->observer->dispatched();
}

void Runner::served() {
  if (parts_->observer) parts_->observer->served();
}

/// One step; zero: nothing moves.
void Runner::advance(Time dt) {
  parts_->simulation.advance(dt);
  if (parts_->observer) parts_->observer->advanced(dt == Time::zero());
}

void Runner::run() {
  // the default timer slack of 50 us is a twentieth of the usual step of 1 ms
  prctl(PR_SET_TIMERSLACK, 1UL);
  while (!isOver()) {
    if (parts_->control.paused()) {
      waitPaused();
    } else {
      runSteps();
    }
  }
}

bool Runner::isOver() const { return stopping_.load() || parts_->made >= parts_->iterations; }

/// One pass of the loop while paused. The systems are called before the wait, because some wait for a pause to begin.
void Runner::waitPaused() {
  Parts& parts = *parts_;
  if (parts.lockstep) parts.lockstep->pause();
  doTasks();
  advance(Time::zero());
  parts.publishStatus(Clock::now());
  parts.simulation.transport().dispatchFor(kPausedPeriod);
  dispatched();
}

/// Takes in what came before a step.
/// @return Whether the run goes on.
bool Runner::takeIn() {
  Parts& parts = *parts_;
  if (!parts.lockstep) {
    doTasks();
    parts.simulation.transport().dispatch();
    dispatched();
    return true;
  }
  const Outcome<bool> taken = parts.lockstep->takeIn({.goesOn =
                                                          [&] {
                                                            doTasks();
                                                            return !parts.control.paused() && !isOver();
                                                          },
                                                      .callSystems = [&] { advance(Time::zero()); },
                                                      .dispatched = [&] { dispatched(); },
                                                      .served = [&] { served(); }});
  if (taken) return *taken.value;
  outcome_.error = taken.error;
  stop();
  return false;
}

void Runner::runSteps() {
  Parts& parts = *parts_;
  parts.factor.restart();
  Clock::time_point now = Clock::now();
  const Clock::time_point start = now - parts.real;
  Clock::time_point due = now;
  while (!isOver()) {
    if (!takeIn()) return;
    // a request handled there takes effect before its response is sent: no step follows the response to a pause
    if (parts.control.paused() || isOver()) return;
    advance(parts.simulation.stepSize());
    ++parts.made;
    if (parts.options.stepped && !parts.options.stepped(parts.simulation)) stop();
    parts.control.stepped(parts.simulation.time());
    parts.history->stepped();
    now = Clock::now();
    parts.real = now - start;
    parts.factor.sample(now, parts.simulation.time());
    parts.publishStatus(now);

    const Clock::duration period = stepPeriod(parts.simulation, parts.options);
    if (period == Clock::duration::zero()) continue;
    due = std::max(due + period, now - kLargestDebt);
    while (now < due && !stopping_.load()) {
      sleepUntil(std::min(due, now + kLongestWait));
      now = Clock::now();
    }
  }
}

}  // namespace pongsim::sim
