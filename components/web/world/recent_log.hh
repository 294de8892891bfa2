#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "pongsim/log.hh"
#include "pongsim/program/log_sink.hh"

namespace pongsim::web {

/// Warnings and errors of the process for clients: live, and the last ones for clients that connect later. For any
/// thread.
class RecentLog {
 public:
  /// Number of lines kept.
  static constexpr std::size_t kKept = 100;
  /// Longer texts are cut [bytes].
  static constexpr std::size_t kLongest = 4096;

  struct Line {
    std::chrono::system_clock::time_point time;
    LogLevel level = LogLevel::kWarning;
    std::string speaker;
    std::string message;
  };
  /// Called on the logging thread; must be fast, and must not end watches.
  using Callback = std::function<void(const Line&)>;

  /// @param callback Called with the kept lines immediately.
  /// @return The watch, which lasts until this is destroyed. Must not outlive the log.
  std::shared_ptr<void> watch(Callback callback);

 private:
  void add(const LogRecord& record);

  std::mutex mutex_;
  std::deque<Line> kept_;
  std::vector<std::shared_ptr<const Callback>> watches_;
  // last, because it starts calling `add`
  LogSink sink_{LogLevel::kWarning, [this](const LogRecord& record) { add(record); }};
};

}  // namespace pongsim::web
