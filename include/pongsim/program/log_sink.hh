#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "pongsim/export.hh"
#include "pongsim/log.hh"

namespace pongsim {

/// A message of a `Logger`. The texts are valid during the call only.
struct LogRecord {
  LogLevel level = LogLevel::kNone;
  /// The part of the program that logged it, as named on stderr.
  std::string_view speaker;
  std::string_view message;
};

/// Receives all log messages of the process while it exists, whatever `setLogLevel` prints on stderr, for example to
/// forward them.
class PONGSIM_API LogSink {
 public:
  using Heard = std::function<void(const LogRecord&)>;

  /// @param level Lowest importance: `kWarning` for warnings and errors.
  /// @param heard Called immediately on the logging thread, possibly by several threads at once. It must not block, nor
  /// create or destroy sinks. Messages logged within it reach no sink, and its exceptions are ignored.
  LogSink(LogLevel level, Heard heard);
  /// `heard` is not called afterwards.
  ~LogSink();
  LogSink(const LogSink&) = delete;
  LogSink& operator=(const LogSink&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pongsim
