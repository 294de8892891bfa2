#include "base/log_sinks.hh"

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

/// What a sink has, for this file, which may not name its private type.
struct Entry {
  const void* owner;
  LogLevel level;
  const LogSink::Heard* heard;
};

/// Loggers speak for the whole process, so it has one list of who hears them.
struct Sinks {
  std::shared_mutex mutex;
  std::vector<Entry> entries;
  /// Of all, so that what nobody hears costs a look.
  std::atomic<LogLevel> level = LogLevel::kNone;

  void findLevel() {
    LogLevel most = LogLevel::kNone;
    for (const Entry& entry : entries) most = std::max(most, entry.level);
    level = most;
  }
};

/// Never destroyed, for threads may speak while the process ends.
Sinks& sinks() {
  static auto* all = new Sinks;
  return *all;
}

}  // namespace

LogSink::LogSink(LogLevel level, Heard heard) : state_(std::make_unique<State>(State{level, std::move(heard)})) {
  Sinks& all = sinks();
  const std::unique_lock lock(all.mutex);
  all.entries.push_back({this, level, &state_->heard});
  all.findLevel();
}

LogSink::~LogSink() {
  Sinks& all = sinks();
  const std::unique_lock lock(all.mutex);
  std::erase_if(all.entries, [this](const Entry& entry) { return entry.owner == this; });
  all.findLevel();
}

void tellSinks(const LogRecord& record) {
  static thread_local bool isTelling = false;
  Sinks& all = sinks();
  if (record.level > all.level.load(std::memory_order_relaxed) || isTelling) return;
  isTelling = true;
  const std::shared_lock lock(all.mutex);
  for (const Entry& entry : all.entries) {
    if (record.level > entry.level) continue;
    try {
      (*entry.heard)(record);
    } catch (...) {
      // who speaks is not to fail for who listens, and to speak of it would be heard again
    }
  }
  isTelling = false;
}

}  // namespace pongsim
