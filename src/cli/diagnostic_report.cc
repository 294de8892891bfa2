#include "cli/diagnostic_report.hh"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

namespace pongsim::cli {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// With its members in the order in which they are added.
using Json = nlohmann::ordered_json;

Json placeOf(const SourcePosition& position) {
  Json place = Json::object();
  if (position.file) place["file"] = *position.file;
  if (position.line > 0) place["line"] = position.line;
  if (position.line > 0 && position.column > 0) place["column"] = position.column;
  return place;
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
  // JSON is UTF-8: what is not becomes U+FFFD
  return all.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pongsim::cli
