#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/topic/spread.hh"
#include "cli/topic/topic_command.hh"
#include "msgs/encoding/bytes.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// Time covered by one line of output.
constexpr std::chrono::seconds kWindow{1};

/// Statistics from `begin` to the last arrival.
class Window {
 public:
  explicit Window(Clock::time_point begin) : begin_(begin), last_(begin) {}

  void add(Clock::time_point arrival, std::size_t bytes) {
    spacings_.push_back(Seconds(arrival - last_).count());
    sizes_.push_back(static_cast<double>(bytes));
    last_ = arrival;
  }
  bool isEmpty() const { return sizes_.empty(); }
  Clock::time_point begin() const { return begin_; }
  Clock::time_point last() const { return last_; }

  std::string line(RateKind kind, bool asJson) const {
    const double seconds = std::max(Seconds(last_ - begin_).count(), 1e-9);
    if (asJson) return json(kind, seconds).dump() + "\n";
    char text[160];
    if (kind == RateKind::kMessages) {
      const Spread spread = spreadOf(spacings_);
      std::snprintf(text, sizeof text,
                    "%.2f Hz, spacing mean %.2f ms, min %.2f ms, max %.2f ms, deviation %.2f ms, %zu messages\n",
                    static_cast<double>(sizes_.size()) / seconds, spread.mean * 1e3, spread.least * 1e3,
                    spread.most * 1e3, spread.deviation * 1e3, sizes_.size());
    } else {
      const Spread spread = spreadOf(sizes_);
      std::snprintf(text, sizeof text, "%.3f kB/s, message mean %.1f B, min %.0f B, max %.0f B, %zu messages\n",
                    spread.mean * static_cast<double>(sizes_.size()) / seconds / 1e3, spread.mean, spread.least,
                    spread.most, sizes_.size());
    }
    return text;
  }

 private:
  nlohmann::ordered_json json(RateKind kind, double seconds) const {
    const double rate = static_cast<double>(sizes_.size()) / seconds;
    if (kind == RateKind::kBytes) {
      const Spread spread = spreadOf(sizes_);
      return {{"bytesPerSecond", spread.mean * rate},
              {"mean", spread.mean},
              {"min", spread.least},
              {"max", spread.most},
              {"messages", sizes_.size()}};
    }
    const Spread spread = spreadOf(spacings_);
    return {{"hz", rate},         {"mean", spread.mean},           {"min", spread.least},
            {"max", spread.most}, {"deviation", spread.deviation}, {"messages", sizes_.size()}};
  }

  Clock::time_point begin_, last_;
  std::vector<double> spacings_, sizes_;
};

class RateTask final : public TopicTask {
 public:
  RateTask(RateKind kind, bool asJson) : kind_(kind), asJson_(asJson) {}

  std::optional<int> take(const Message& message) override {
    const auto now = Clock::now();
    // the first message only opens the window: the time before it is not known
    if (!window_) {
      window_ = Window(now);
      return std::nullopt;
    }
    window_->add(now, msgs::byteSize(message));
    return now - window_->begin() < kWindow ? std::nullopt : printed();
  }

  std::optional<int> tick() override {
    if (!window_ || Clock::now() - std::max(saidNothing_, window_->last()) < 2 * kWindow) return std::nullopt;
    if (!window_->isEmpty()) return printed();
    saidNothing_ = Clock::now();
    say("no messages");
    return std::nullopt;
  }

  int end(bool) override {
    if (!window_) return fail("no messages");
    if (window_->isEmpty()) return hasPrinted_ ? kDone : fail("only one message: no rate");
    return printed().value_or(kDone);
  }

 private:
  std::optional<int> printed() {
    const std::string line = window_->line(kind_, asJson_);
    window_ = Window(window_->last());
    hasPrinted_ = true;
    if (print(line)) return std::nullopt;
    return outputIsClosed() ? kDone : kFailed;
  }

  const RateKind kind_;
  const bool asJson_;
  std::optional<Window> window_;
  Clock::time_point saidNothing_;
  bool hasPrinted_ = false;
};

}  // namespace

int measureTopic(const ReadOptions& options, RateKind kind, bool asJson) {
  TopicReader reader(options);
  RateTask task(kind, asJson);
  return reader.run(task);
}

}  // namespace pongsim::cli
