#include "sim/diagnostic_log.hh"

#include <string_view>

namespace pongsim::sim {

namespace {

/// As a log prints it, which says itself how bad it is.
std::string withoutSeverity(const Diagnostic& diagnostic) {
  std::string text = format(diagnostic);
  const std::string_view severity = diagnostic.severity == Severity::kError ? "error: " : "warning: ";
  if (const std::size_t at = text.find(severity); at != text.npos) text.erase(at, severity.size());
  return text;
}

std::string tell(const Diagnostics& diagnostics, const Logger& log, bool tellsErrors) {
  std::string first;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const std::string text = withoutSeverity(diagnostic);
    if (diagnostic.severity == Severity::kWarning) {
      log.warning(text);
      continue;
    }
    if (tellsErrors) log.error(text);
    if (first.empty()) first = text.substr(0, text.find('\n'));
  }
  return first;
}

}  // namespace

std::string logDiagnostics(const Diagnostics& diagnostics, const Logger& log) { return tell(diagnostics, log, true); }

std::string logWarnings(const Diagnostics& diagnostics, const Logger& log) { return tell(diagnostics, log, false); }

}  // namespace pongsim::sim
