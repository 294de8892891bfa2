#pragma once

#include <string>
#include <string_view>

#include "pongsim/export.hh"

namespace pongsim {

/// Log levels, numbered as in Fortress's `-v`.
enum class LogLevel { kNone = 0, kError = 1, kWarning = 2, kInfo = 3, kDebug = 4 };

/// Sets the log level of the process on stderr; initially `kWarning`.
PONGSIM_API void setLogLevel(LogLevel level);
PONGSIM_API LogLevel logLevel();

/// Logs to stderr for one part of the program, whose name is in each line.
class PONGSIM_API Logger {
 public:
  explicit Logger(std::string speaker);

  void error(std::string_view message) const;
  void warning(std::string_view message) const;
  void info(std::string_view message) const;
  void debug(std::string_view message) const;

 private:
  std::string speaker_;
};

}  // namespace pongsim
