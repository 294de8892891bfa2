#include "cli/files/diagnostic_report.hh"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "base/report/log_sink.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// A line with more bytes counts as long, and gets a mark every so many characters.
constexpr std::size_t kLongLine = 4096;
constexpr std::size_t kMarkEvery = 256;

std::vector<std::size_t> marksOf(std::string_view line) {
  std::vector<std::size_t> marks;
  std::size_t letters = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool beginsLetter = (static_cast<unsigned char>(line[i]) & 0xC0U) != 0x80;
    if (beginsLetter && letters++ % kMarkEvery == 0) marks.push_back(i);
  }
  if (marks.empty()) marks.push_back(0);
  return marks;
}

// Keeps members in the order in which they are added.
using Json = nlohmann::ordered_json;

Json placeOf(const SourcePosition& position) {
  Json place = Json::object();
  if (position.file) place["file"] = *position.file;
  if (position.line > 0) place["line"] = position.line;
  if (position.line > 0 && position.column > 0) place["column"] = position.column;
  return place;
}

}  // namespace

SourceExcerpt SourceLines::at(const SourcePosition& position) {
  if (!position.file || position.line <= 0) return {};
  File& file = fileNamed(*position.file);
  const auto number = static_cast<std::size_t>(position.line);
  if (number >= file.lines.size()) return {};
  const std::size_t begin = file.lines[number - 1];
  std::string_view line = std::string_view(file.text).substr(begin, file.lines[number] - 1 - begin);
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.size() <= kLongLine) return {.text = line};

  // around the column, without scanning the line again for each position in it
  std::vector<std::size_t>& marks = file.marks[number];
  if (marks.empty()) marks = marksOf(line);
  const auto column = static_cast<std::size_t>(std::max(position.column, 1));
  const std::size_t first = std::min((column - 1) / kMarkEvery, marks.size() - 1);
  // with enough characters before and after it to fill the excerpt
  const std::size_t from = first - std::min<std::size_t>(first, 1);
  const bool isCutOff = first + 2 < marks.size();
  const std::size_t end = isCutOff ? marks[first + 2] : line.size();
  return {.text = line.substr(marks[from], end - marks[from]),
          .firstColumn = static_cast<int>(from * kMarkEvery + 1),
          .isCutOff = isCutOff};
}

SourceLines::File& SourceLines::fileNamed(const std::string& name) {
  const auto [entry, isNew] = files_.try_emplace(name);
  File& file = entry->second;
  std::error_code ignored;
  // a pipe can be read only once
  if (!isNew || !std::filesystem::is_regular_file(name, ignored)) return file;
  std::ifstream stream(name, std::ios::binary);
  file.text.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  if (file.text.starts_with(kByteOrderMark)) file.text.erase(0, kByteOrderMark.size());
  file.lines.push_back(0);
  for (std::size_t i = 0; i < file.text.size(); ++i) {
    if (file.text[i] == '\n') file.lines.push_back(i + 1);
  }
  file.lines.push_back(file.text.size() + 1);
  return file;
}

void say(const Diagnostics& diagnostics, Severity least, Severity leastWithLine) {
  SourceLines lines;
  const bool colored = hasColors(STDERR_FILENO);
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const LogLevel level = diagnostic.severity == Severity::kError ? LogLevel::kError : LogLevel::kWarning;
    tellSinks({level, "world", format(diagnostic)});
    if (diagnostic.severity < least) continue;
    const SourceExcerpt source = diagnostic.severity < leastWithLine ? SourceExcerpt() : lines.at(diagnostic.position);
    std::fprintf(stderr, "%s\n", format(diagnostic, source, colored).c_str());
  }
}

Diagnostics asErrors(const Diagnostics& diagnostics) {
  Diagnostics errors;
  for (Diagnostic diagnostic : diagnostics.all()) {
    diagnostic.severity = Severity::kError;
    errors.add(std::move(diagnostic));
  }
  return errors;
}

std::string jsonOf(const std::vector<Diagnostic>& diagnostics) {
  Json all = Json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    Json object = placeOf(diagnostic.position);
    object["severity"] = diagnostic.severity == Severity::kError ? "error" : "warning";
    object["message"] = diagnostic.message;
    if (!diagnostic.hint.empty()) object["hint"] = diagnostic.hint;
    for (const SourcePosition& place : diagnostic.includedFrom) object["includedFrom"].push_back(placeOf(place));
    all.push_back(std::move(object));
  }
  // JSON is UTF-8: invalid bytes become U+FFFD
  return all.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pongsim::cli
