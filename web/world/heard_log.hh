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

/// Warnings and errors of the process, for clients: as they come, and the last ones for who comes later. For any
/// thread.
class HeardLog {
 public:
  /// So many are kept.
  static constexpr std::size_t kKept = 100;
  /// Longer texts are cut [bytes].
  static constexpr std::size_t kLongest = 4096;

  struct Entry {
    std::chrono::system_clock::time_point time;
    LogLevel level = LogLevel::kWarning;
    std::string speaker;
    std::string message;
  };
  /// Called on the thread that speaks; must be quick, and must not end watches.
  using Heard = std::function<void(const Entry&)>;

  /// @param heard Told those that are kept at once.
  /// @return Watched until it is destroyed. Must not outlive this.
  std::shared_ptr<void> watch(Heard heard);

 private:
  void hear(const LogRecord& record);

  std::mutex mutex_;
  std::deque<Entry> kept_;
  std::vector<std::shared_ptr<const Heard>> watches_;
  // begins last
  LogSink sink_{LogLevel::kWarning, [this](const LogRecord& record) { hear(record); }};
};

}  // namespace pongsim::web
