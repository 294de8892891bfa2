#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/topic/spread.hh"
#include "cli/topic/topic_command.hh"
#include "msgs/fields/stamp.hh"
#include "pongsim/node.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

using Clock = std::chrono::steady_clock;

/// Each wait for the clock at the end; at most ten times.
constexpr std::chrono::milliseconds kForTheClock{20};
/// Time covered by one line of output.
constexpr std::chrono::seconds kDelayWindow{1};
/// Number of past steps whose wall time is remembered.
constexpr std::size_t kMostReadings = 20'000;
/// Number of messages that can wait for the clock of their step.
constexpr std::size_t kMostArrivals = 10'000;

/// Measures the wall time from the step in a message's stamp to its arrival. The run's `/clock` tells when that step
/// was.
class DelayTask final : public TopicTask {
 public:
  DelayTask(Transport& transport, bool asJson)
      : transport_(transport),
        asJson_(asJson),
        clock_(transport.node().subscribe("/clock", "ignition.msgs.Clock",
                                          [this](const Message& message) { takeClock(msgs::clockReading(message)); })) {
  }

  std::optional<int> begin(const std::string& type) override {
    if (msgs::hasStamp(type)) return std::nullopt;
    return fail(type + " has no time stamp in a header", "use --hz to measure the rate");
  }

  std::optional<int> take(const Message& message) override {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    ++messages_;
    const std::optional<Time> stamp = msgs::stampOf(message);
    if (!stamp) return std::nullopt;
    arrivals_.push_back({*stamp, std::chrono::duration_cast<Time>(now)});
    if (arrivals_.size() > kMostArrivals) arrivals_.pop_front();
    return std::nullopt;
  }

  std::optional<int> tick() override {
    measure();
    if (delays_.empty() || Clock::now() - windowStart_ < kDelayWindow) return std::nullopt;
    return printed();
  }

  int end(bool) override {
    measure();
    // the clock of the last step arrives after its messages
    for (int i = 0; i < 10 && delays_.empty() && !arrivals_.empty(); ++i) {
      transport_.dispatchFor(kForTheClock);
      measure();
    }
    if (!delays_.empty()) return printed().value_or(kDone);
    if (hasPrinted_) return kDone;
    if (messages_ == 0) return fail("no messages");
    return fail(readings_.empty() ? "no messages on /clock, which the time stamps refer to"
                                  : "no message is stamped with the time of a step of /clock");
  }

 private:
  struct Arrival {
    Time stamp;
    Time system;
  };

  void takeClock(const msgs::ClockReading& reading) {
    // after a reset, time starts again
    if (!readings_.empty() && reading.simulated < readings_.back().simulated) readings_.clear();
    // a paused run repeats the same time
    if (!readings_.empty() && reading.simulated == readings_.back().simulated) return;
    readings_.push_back(reading);
    if (readings_.size() > kMostReadings) readings_.pop_front();
  }

  /// For messages whose step is known by now.
  void measure() {
    while (!arrivals_.empty() && !readings_.empty() && arrivals_.front().stamp <= readings_.back().simulated) {
      const Arrival arrival = arrivals_.front();
      arrivals_.pop_front();
      const auto reading = std::ranges::lower_bound(readings_, arrival.stamp, {}, &msgs::ClockReading::simulated);
      if (reading->simulated != arrival.stamp) continue;
      if (delays_.empty()) windowStart_ = Clock::now();
      delays_.push_back(std::chrono::duration<double>(arrival.system - reading->system).count());
    }
  }

  std::optional<int> printed() {
    const Spread spread = spreadOf(delays_);
    std::string line;
    if (asJson_) {
      const nlohmann::ordered_json json = {{"mean", spread.mean},
                                           {"min", spread.least},
                                           {"max", spread.most},
                                           {"deviation", spread.deviation},
                                           {"messages", delays_.size()}};
      line = json.dump() + "\n";
    } else {
      char text[160];
      std::snprintf(text, sizeof text,
                    "delay mean %.3f ms, min %.3f ms, max %.3f ms, deviation %.3f ms, %zu messages\n",
                    spread.mean * 1e3, spread.least * 1e3, spread.most * 1e3, spread.deviation * 1e3, delays_.size());
      line = text;
    }
    delays_.clear();
    hasPrinted_ = true;
    if (print(line)) return std::nullopt;
    return outputIsClosed() ? kDone : kFailed;
  }

  Transport& transport_;
  const bool asJson_;
  std::deque<msgs::ClockReading> readings_;
  std::deque<Arrival> arrivals_;
  std::vector<double> delays_;
  Clock::time_point windowStart_;
  std::uint64_t messages_ = 0;
  bool hasPrinted_ = false;
  const Subscription clock_;
};

}  // namespace

int measureDelay(const ReadOptions& options, bool asJson) {
  TopicReader reader(options);
  DelayTask task(reader.transport(), asJson);
  return reader.run(task);
}

}  // namespace pongsim::cli
