#include "pongsim/diagnostic.hh"

#include <utility>

namespace pongsim {

std::string format(const Diagnostic& diagnostic) {
  std::string text;
  const SourcePosition& position = diagnostic.position;
  if (position.file) {
    text += *position.file + ":";
    if (position.line > 0) text += std::to_string(position.line) + ":";
    if (position.line > 0 && position.column > 0) text += std::to_string(position.column) + ":";
    text += " ";
  }
  text += diagnostic.severity == Severity::kError ? "error: " : "warning: ";
  text += diagnostic.message;
  if (!diagnostic.hint.empty()) text += "\n  hint: " + diagnostic.hint;
  return text;
}

void Diagnostics::error(SourcePosition position, std::string message, std::string hint) {
  all_.push_back({Severity::kError, std::move(position), std::move(message), std::move(hint)});
  ++errorCount_;
}

void Diagnostics::warning(SourcePosition position, std::string message, std::string hint) {
  all_.push_back({Severity::kWarning, std::move(position), std::move(message), std::move(hint)});
}

Error::Error(Diagnostic diagnostic) : std::runtime_error(format(diagnostic)), diagnostic_(std::move(diagnostic)) {}

}  // namespace pongsim
