#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "pongsim/export.hh"
#include "pongsim/log.hh"

namespace pongsim {

/// One message of a `Logger`. The texts live during the call only.
struct LogRecord {
  LogLevel level = LogLevel::kNone;
  /// The part of the program that speaks, as its line on stderr names it.
  std::string_view speaker;
  std::string_view message;
};

/// Hears what all loggers of the process say, for as long as it lives, whatever `setLogLevel` lets through to stderr:
/// for who carries it elsewhere.
class PONGSIM_API LogSink {
 public:
  using Heard = std::function<void(const LogRecord&)>;

  /// @param level How much is heard: `kWarning` for warnings and errors.
  /// @param heard Called at once, on the thread that speaks, by several threads at a time. It must not wait for long,
  /// nor make or end sinks. What is said from within it no sink hears, nor what it throws anybody.
  LogSink(LogLevel level, Heard heard);
  /// `heard` is not called from then on.
  ~LogSink();
  LogSink(const LogSink&) = delete;
  LogSink& operator=(const LogSink&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pongsim
