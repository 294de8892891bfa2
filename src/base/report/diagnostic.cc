#include "pongsim/diagnostic.hh"

#include <algorithm>
#include <utility>

namespace pongsim {

namespace {

// Of a longer line, this many characters are shown, half of them before the marker.
constexpr std::size_t kWidest = 120;
constexpr std::size_t kBeforeMark = 60;

/// @return "world.sdf:41:9:"; empty if there is no file.
std::string format(const SourcePosition& position) {
  if (!position.file) return {};
  std::string text = *position.file + ":";
  if (position.line > 0) text += std::to_string(position.line) + ":";
  if (position.line > 0 && position.column > 0) text += std::to_string(position.column) + ":";
  return text;
}

// Terminal escapes for bold, bold red, bold magenta, bold green, and reset.
constexpr std::string_view kBold = "\x1b[1m";
constexpr std::string_view kRed = "\x1b[1;31m";
constexpr std::string_view kMagenta = "\x1b[1;35m";
constexpr std::string_view kGreen = "\x1b[1;32m";
constexpr std::string_view kPlain = "\x1b[0m";

std::string colored(std::string text, std::string_view color, bool hasColors) {
  return !hasColors || text.empty() ? text : std::string(color).append(text).append(kPlain);
}

std::string firstLine(const Diagnostic& diagnostic, bool hasColors) {
  const std::string position = format(diagnostic.position);
  const bool isError = diagnostic.severity == Severity::kError;
  return colored(position, kBold, hasColors) + (position.empty() ? "" : " ") +
         colored(isError ? "error:" : "warning:", isError ? kRed : kMagenta, hasColors) + ' ' +
         colored(diagnostic.message, kBold, hasColors);
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

/// @return `text` without characters that would move a terminal's cursor.
std::string printable(std::string_view text) {
  std::string shown(text);
  for (char& byte : shown) {
    if (static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F) byte = ' ';
  }
  return shown;
}

/// @return The line, with the marker below its character number `wanted`, counted from 1; nothing if there is no such
/// character.
std::string marked(const SourceExcerpt& source, int wanted, bool hasColors) {
  const std::string_view line = source.text;
  if (wanted < source.firstColumn) return {};
  const auto column = static_cast<std::size_t>(wanted - source.firstColumn) + 1;
  std::vector<std::size_t> letters;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!continuesLetter(line[i])) letters.push_back(i);
  }
  if (column > letters.size()) return {};
  // a section of a long line is shown as if it were the whole line
  const std::size_t first =
      static_cast<std::size_t>(wanted) > kWidest ? std::max(column, kBeforeMark + 1) - 1 - kBeforeMark : 0;
  const std::size_t last = std::min(letters.size(), first + kWidest);
  letters.push_back(line.size());
  const std::string before = first > 0 || source.firstColumn > 1 ? "..." : "";
  const std::string behind = last + 1 < letters.size() || source.isCutOff ? "..." : "";
  return "\n    " + before + printable(line.substr(letters[first], letters[last] - letters[first])) + behind +
         "\n    " + std::string(before.size() + column - 1 - first, ' ') + colored("^", kGreen, hasColors);
}

}  // namespace

std::string format(const Diagnostic& diagnostic) { return firstLine(diagnostic, false) + otherLines(diagnostic); }

std::string format(const Diagnostic& diagnostic, const SourceExcerpt& source, bool hasColors) {
  return firstLine(diagnostic, hasColors) + marked(source, diagnostic.position.column, hasColors) +
         otherLines(diagnostic);
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
