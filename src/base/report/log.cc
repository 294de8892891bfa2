#include "pongsim/log.hh"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <utility>

#include "base/report/log_sink.hh"

namespace pongsim {

namespace {

/// Global, because the process has one stderr.
spdlog::logger& standardError() {
  static spdlog::logger logger = [] {
    spdlog::logger made("pongsim", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
    made.set_pattern("%^%l%$: %v");
    made.set_level(spdlog::level::warn);
    return made;
  }();
  return logger;
}

constexpr spdlog::level::level_enum kLevels[] = {spdlog::level::off, spdlog::level::err, spdlog::level::warn,
                                                 spdlog::level::info, spdlog::level::debug};

void say(LogLevel level, const std::string& speaker, std::string_view message) {
  const spdlog::level::level_enum theirs = kLevels[static_cast<int>(level)];
  if (standardError().should_log(theirs)) standardError().log(theirs, (speaker + ": ").append(message));
  tellSinks({level, speaker, message});
}

}  // namespace

void setLogLevel(LogLevel level) { standardError().set_level(kLevels[static_cast<int>(level)]); }

LogLevel logLevel() {
  switch (standardError().level()) {
    case spdlog::level::off:
      return LogLevel::kNone;
    case spdlog::level::err:
      return LogLevel::kError;
    case spdlog::level::warn:
      return LogLevel::kWarning;
    case spdlog::level::info:
      return LogLevel::kInfo;
    default:
      return LogLevel::kDebug;
  }
}

Logger::Logger(std::string speaker) : speaker_(std::move(speaker)) {}

void Logger::error(std::string_view message) const { say(LogLevel::kError, speaker_, message); }
void Logger::warning(std::string_view message) const { say(LogLevel::kWarning, speaker_, message); }
void Logger::info(std::string_view message) const { say(LogLevel::kInfo, speaker_, message); }
void Logger::debug(std::string_view message) const { say(LogLevel::kDebug, speaker_, message); }

}  // namespace pongsim
