#include "base/report/log_sink.hh"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <shared_mutex>
#include <utility>
#include <vector>

namespace pongsim {

struct LogSink::State {
  LogLevel level;
  Heard heard;
};

namespace {

/// What `tellSinks` needs of a sink, whose own state is private.
struct RegisteredSink {
  const void* owner;
  LogLevel level;
  const LogSink::Heard* heard;
};

/// All registered sinks; global, because loggers serve the whole process.
struct Sinks {
  std::shared_mutex mutex;
  std::vector<RegisteredSink> registered;
  /// The most verbose level of all sinks, so that a message nobody listens to costs only a check.
  std::atomic<LogLevel> level = LogLevel::kNone;

  void findLevel() {
    LogLevel most = LogLevel::kNone;
    for (const RegisteredSink& sink : registered) most = std::max(most, sink.level);
    level = most;
  }
};

/// Never destroyed, because threads may log while the process exits.
Sinks& sinks() {
  static auto* all = new Sinks;
  return *all;
}

}  // namespace

LogSink::LogSink(LogLevel level, Heard heard) : state_(std::make_unique<State>(State{level, std::move(heard)})) {
  Sinks& all = sinks();
  const std::unique_lock lock(all.mutex);
  all.registered.push_back({this, level, &state_->heard});
  all.findLevel();
}

LogSink::~LogSink() {
  Sinks& all = sinks();
  const std::unique_lock lock(all.mutex);
  std::erase_if(all.registered, [this](const RegisteredSink& sink) { return sink.owner == this; });
  all.findLevel();
}

void tellSinks(const LogRecord& record) {
  static thread_local bool isTelling = false;
  Sinks& all = sinks();
  if (record.level > all.level.load(std::memory_order_relaxed) || isTelling) return;
  isTelling = true;
  const std::shared_lock lock(all.mutex);
  for (const RegisteredSink& sink : all.registered) {
    if (record.level > sink.level) continue;
    try {
      (*sink.heard)(record);
    } catch (...) {
      // a failing listener must not make the logging code fail, and logging the failure would reach the listener again
    }
  }
  isTelling = false;
}

}  // namespace pongsim
