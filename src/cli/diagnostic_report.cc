#include "cli/diagnostic_report.hh"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace pongsim::cli {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// @return The number of bytes of the letter that `text` begins with; 0 where that is not UTF-8.
std::size_t letterLength(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  std::size_t length = 1;
  if (byte(0) >= 0xC2) length = byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
  if ((byte(0) >= 0x80 && length == 1) || byte(0) > 0xF4 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  }
  // too long a form, half of a UTF-16 pair, beyond the last letter
  const bool isOdd = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xED && byte(1) >= 0xA0) ||
                     (byte(0) == 0xF0 && byte(1) < 0x90) || (byte(0) == 0xF4 && byte(1) >= 0x90);
  return isOdd ? 0 : length;
}

/// @return The text in quotes. What is not UTF-8 becomes U+FFFD, for JSON is.
std::string jsonText(std::string_view text) {
  std::string json = "\"";
  while (!text.empty()) {
    const std::size_t length = letterLength(text);
    const char letter = text.front();
    if (length == 0) {
      json += "\\ufffd";
    } else if (letter == '"' || letter == '\\') {
      json += {'\\', letter};
    } else if (length == 1 && static_cast<unsigned char>(letter) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(letter));
      json += code;
    } else {
      json += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return json + "\"";
}

/// @return The members of a place, with a comma behind each.
std::string membersOf(const SourcePosition& position) {
  std::string json;
  if (position.file) json += "\"file\":" + jsonText(*position.file) + ",";
  if (position.line > 0) json += "\"line\":" + std::to_string(position.line) + ",";
  if (position.line > 0 && position.column > 0) json += "\"column\":" + std::to_string(position.column) + ",";
  return json;
}

std::string objectOf(const SourcePosition& position) {
  std::string members = membersOf(position);
  if (!members.empty()) members.pop_back();
  return "{" + members + "}";
}

}  // namespace

std::string_view SourceLines::at(const SourcePosition& position) {
  if (!position.file || position.line <= 0) return {};
  const File& file = fileNamed(*position.file);
  const auto number = static_cast<std::size_t>(position.line);
  if (number > file.lines.size()) return {};
  std::string_view line = std::string_view(file.text).substr(file.lines[number - 1]);
  line = line.substr(0, line.find('\n'));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

const SourceLines::File& SourceLines::fileNamed(const std::string& name) {
  const auto [entry, isNew] = files_.try_emplace(name);
  File& file = entry->second;
  std::error_code ignored;
  // a pipe has been read already
  if (!isNew || !std::filesystem::is_regular_file(name, ignored)) return file;
  std::ifstream stream(name, std::ios::binary);
  file.text.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  if (file.text.starts_with(kByteOrderMark)) file.text.erase(0, kByteOrderMark.size());
  file.lines.push_back(0);
  for (std::size_t i = 0; i < file.text.size(); ++i) {
    if (file.text[i] == '\n') file.lines.push_back(i + 1);
  }
  return file;
}

void say(const Diagnostics& diagnostics, Severity least, Severity leastWithLine) {
  SourceLines lines;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity < least) continue;
    const std::string_view line = diagnostic.severity < leastWithLine ? "" : lines.at(diagnostic.position);
    std::fprintf(stderr, "%s\n", format(diagnostic, line).c_str());
  }
}

std::string jsonOf(const std::vector<Diagnostic>& diagnostics) {
  std::string json = "[";
  for (const Diagnostic& diagnostic : diagnostics) {
    if (json.size() > 1) json += ",";
    json += "{" + membersOf(diagnostic.position) + "\"severity\":";
    json += diagnostic.severity == Severity::kError ? "\"error\"" : "\"warning\"";
    json += ",\"message\":" + jsonText(diagnostic.message);
    if (!diagnostic.hint.empty()) json += ",\"hint\":" + jsonText(diagnostic.hint);
    if (!diagnostic.includedFrom.empty()) {
      json += ",\"includedFrom\":[";
      for (const SourcePosition& place : diagnostic.includedFrom) json += objectOf(place) + ",";
      json.back() = ']';
    }
    json += "}";
  }
  return json + "]\n";
}

}  // namespace pongsim::cli
