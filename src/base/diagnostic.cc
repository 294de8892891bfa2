#include "pongsim/diagnostic.hh"

#include <algorithm>
#include <utility>

namespace pongsim {

namespace {

// Of a longer line a part of this many letters is shown, half of them before the mark.
constexpr std::size_t kWidest = 120;
constexpr std::size_t kBeforeMark = 60;

/// @return "world.sdf:41:9:", or nothing where there is no file.
std::string format(const SourcePosition& position) {
  if (!position.file) return {};
  std::string text = *position.file + ":";
  if (position.line > 0) text += std::to_string(position.line) + ":";
  if (position.line > 0 && position.column > 0) text += std::to_string(position.column) + ":";
  return text;
}

std::string firstLine(const Diagnostic& diagnostic) {
  const std::string position = format(diagnostic.position);
  return position + (position.empty() ? "" : " ") +
         (diagnostic.severity == Severity::kError ? "error: " : "warning: ") + diagnostic.message;
}

std::string otherLines(const Diagnostic& diagnostic) {
  std::string text;
  if (!diagnostic.hint.empty()) text += "\n  hint: " + diagnostic.hint;
  for (const SourcePosition& place : diagnostic.includedFrom) {
    std::string position = format(place);
    if (!position.empty()) position.pop_back();
    text += "\n  included from " + position;
  }
  return text;
}

bool continuesLetter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80; }

/// @return `text` with nothing in it that would move a terminal's cursor.
std::string printable(std::string_view text) {
  std::string shown(text);
  for (char& byte : shown) {
    if (static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F) byte = ' ';
  }
  return shown;
}

/// @return The line and the mark under its letter number `column`, counted from 1; nothing where it has fewer.
std::string marked(std::string_view line, std::size_t column) {
  std::vector<std::size_t> letters;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!continuesLetter(line[i])) letters.push_back(i);
  }
  if (column > letters.size()) return {};
  const std::size_t first = column > kWidest ? column - 1 - kBeforeMark : 0;
  const std::size_t last = std::min(letters.size(), first + kWidest);
  letters.push_back(line.size());
  const std::string before = first > 0 ? "..." : "";
  const std::string behind = last + 1 < letters.size() ? "..." : "";
  return "\n    " + before + printable(line.substr(letters[first], letters[last] - letters[first])) + behind +
         "\n    " + std::string(before.size() + column - 1 - first, ' ') + "^";
}

}  // namespace

std::string format(const Diagnostic& diagnostic) { return firstLine(diagnostic) + otherLines(diagnostic); }

std::string format(const Diagnostic& diagnostic, std::string_view sourceLine) {
  const int column = diagnostic.position.column;
  const std::string source = column > 0 ? marked(sourceLine, static_cast<std::size_t>(column)) : "";
  return firstLine(diagnostic) + source + otherLines(diagnostic);
}

void Diagnostics::error(SourcePosition position, std::string message, std::string hint) {
  add({Severity::kError, std::move(position), std::move(message), std::move(hint)});
}

void Diagnostics::warning(SourcePosition position, std::string message, std::string hint) {
  add({Severity::kWarning, std::move(position), std::move(message), std::move(hint)});
}

void Diagnostics::add(Diagnostic diagnostic) {
  if (diagnostic.severity == Severity::kError) ++errorCount_;
  all_.push_back(std::move(diagnostic));
}

Error::Error(Diagnostic diagnostic) : std::runtime_error(format(diagnostic)), diagnostic_(std::move(diagnostic)) {}

}  // namespace pongsim
