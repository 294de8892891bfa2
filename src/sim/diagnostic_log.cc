#include "sim/diagnostic_log.hh"

#include <cstddef>
#include <string>
#include <string_view>

namespace pongsim::sim {

namespace {

/// @return The diagnostic's text without its severity, which the log prints itself.
std::string withoutSeverity(const Diagnostic& diagnostic) {
  std::string text = format(diagnostic);
  const std::string_view severity = diagnostic.severity == Severity::kError ? "error: " : "warning: ";
  if (const std::size_t at = text.find(severity); at != text.npos) text.erase(at, severity.size());
  return text;
}

/// Limit per request, so that a single one can't fill a log.
constexpr std::size_t kMostLines = 20;

std::string tell(const Diagnostics& diagnostics, const Logger& log, bool tellsErrors) {
  std::string first;
  std::size_t told = 0, more = 0;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const bool isWarning = diagnostic.severity == Severity::kWarning;
    if (!isWarning && first.empty()) {
      const std::string text = withoutSeverity(diagnostic);
      first = text.substr(0, text.find('\n'));
    }
    if (!isWarning && !tellsErrors) continue;
    if (++told > kMostLines) {
      ++more;
    } else if (isWarning) {
      log.warning(withoutSeverity(diagnostic));
    } else {
      log.error(withoutSeverity(diagnostic));
    }
  }
  if (more > 0) log.warning("and " + std::to_string(more) + " more errors and warnings");
  return first;
}

}  // namespace

std::string logDiagnostics(const Diagnostics& diagnostics, const Logger& log) { return tell(diagnostics, log, true); }

std::string logWarnings(const Diagnostics& diagnostics, const Logger& log) { return tell(diagnostics, log, false); }

}  // namespace pongsim::sim
