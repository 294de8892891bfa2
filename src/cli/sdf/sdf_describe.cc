#include "cli/sdf/sdf_describe.hh"

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

namespace pongsim::cli {

namespace {

using sdf::Schema;
using sdf::SchemaRow;

constexpr std::size_t kWidth = 100;
constexpr std::string_view kGap = "  ";

/// @return The text in lines of `kWidth` characters, each indented.
std::string wrapped(std::string_view text, std::size_t indent) {
  std::string result(indent, ' ');
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column > indent && column + 1 + end > kWidth) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    }
    if (column > indent) result += ' ';
    column += end + (column > indent ? 1 : 0);
    result += text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result + "\n";
}

/// @return The first sentence, cut to the room available in a line.
std::string inShort(std::string_view description, std::size_t room) {
  const std::string_view sentence = description.substr(0, description.find(". "));
  if (sentence.size() <= room) return std::string(sentence);
  const std::size_t end = sentence.substr(0, room - 3).rfind(' ');
  return std::string(sentence.substr(0, end)) + "...";
}

std::string howOften(char presence, bool isAttribute) {
  if (isAttribute) return presence == '1' ? "required" : "optional";
  if (presence == '1') return "once";
  if (presence == '*') return "any number";
  if (presence == '+') return "once or more";
  return "at most once";
}

std::string versions(const SchemaRow& row) {
  const std::string first = "SDF 1." + std::to_string(row.since);
  if (row.removedIn == 0) return "since " + first;
  if (row.removedIn == row.since + 1) return first + " only";
  return first + " to 1." + std::to_string(row.removedIn - 1);
}

std::string defaultOf(const SchemaRow& row) {
  if (row.type.empty()) return "";
  const std::string text(row.fallback.value.empty() ? "\"\"" : row.fallback.value);
  if (row.fallback.changedIn == 0) return text;
  return text + " (" + std::string(row.fallback.later) + " since SDF 1." + std::to_string(row.fallback.changedIn) + ")";
}

std::string_view useOf(sdf::Use use) {
  switch (use) {
    case sdf::Use::kRead:
      return "read";
    case sdf::Use::kKept:
      return "kept as it is";
    case sdf::Use::kPassed:
      return "known, but unused";
  }
  return "";
}

using Line = std::vector<std::string>;

/// @param lines All with the same number of columns; columns are aligned, and the last one is cut to the remaining
/// room.
std::string aligned(const std::vector<Line>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const Line& line : lines) {
    std::string row(kGap);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      row += line[i] + std::string(widths[i] - line[i].size(), ' ') + std::string(kGap);
    }
    row += inShort(line.back(), std::max<std::size_t>(kWidth, row.size() + 20) - row.size());
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

std::string listOf(std::span<const Schema::Part> parts, bool areAttributes) {
  std::vector<Line> lines;
  for (const Schema::Part& part : parts) {
    const SchemaRow& row = part.row;
    const std::string name = part.name == "*" ? "(anything)" : (areAttributes ? "@" : "") + std::string(part.name);
    const std::string gone = row.removedIn == 0 ? "" : "(" + versions(row) + ") ";
    lines.push_back({name, std::string(row.type), defaultOf(row), howOften(row.presence.value, areAttributes),
                     gone + std::string(row.description)});
  }
  return lines.empty() ? "" : std::string(areAttributes ? "\nattributes:\n" : "\nelements:\n") + aligned(lines);
}

}  // namespace

std::string describe(const sdf::NamedPart& named) {
  const Schema::Part& part = *named.part;
  const SchemaRow& row = part.row;
  std::string text = named.isAttribute ? "@" + std::string(part.name) : "<" + std::string(part.name) + ">";
  std::string places;
  for (const std::string_view holder : named.holders) {
    places += (places.empty() ? " in " : ", ") + sdf::userPath(holder);
  }
  text += places + "\n";
  if (!row.description.empty()) text += wrapped(row.description, kGap.size());

  text += "\n";
  std::vector<Line> facts;
  if (!row.type.empty()) facts.push_back({"type", std::string(row.type)});
  if (!row.type.empty()) facts.push_back({"default", defaultOf(row)});
  // for an element with several parents this differs between them
  if (named.holders.size() == 1) facts.push_back({"how often", howOften(row.presence.value, named.isAttribute)});
  facts.push_back({"versions", versions(row)});
  facts.push_back({"in pongsim", std::string(useOf(row.use))});
  text += aligned(facts);

  if (part.type == nullptr) return text;
  return text + listOf(part.type->attributes, true) + listOf(part.type->children, false);
}

}  // namespace pongsim::cli
