#include "web/rosbridge/definition.hh"

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <utility>

namespace pongsim::web::rosbridge {

namespace {

constexpr std::pair<std::string_view, Kind> kWords[] = {
    {"bool", Kind::kBool},       {"byte", Kind::kUint8},   {"char", Kind::kUint8},    {"int8", Kind::kInt8},
    {"uint8", Kind::kUint8},     {"int16", Kind::kInt16},  {"uint16", Kind::kUint16}, {"int32", Kind::kInt32},
    {"uint32", Kind::kUint32},   {"int64", Kind::kInt64},  {"uint64", Kind::kUint64}, {"float32", Kind::kFloat32},
    {"float64", Kind::kFloat64}, {"string", Kind::kString}};
constexpr std::string_view kType = "MSG: ";

/// A field whose type may be defined further below.
struct Line {
  std::string type;
  RosField field;
};

std::optional<Line> fieldIn(std::string_view text) {
  const std::size_t blank = text.find(' ');
  if (blank == std::string_view::npos) return std::nullopt;
  Line line{std::string(text.substr(0, blank)), {}};
  line.field.name = text.substr(blank + 1);
  if (line.type.ends_with(']')) {
    const std::size_t open = line.type.rfind('[');
    if (open == std::string::npos) return std::nullopt;
    const std::string count = line.type.substr(open + 1, line.type.size() - open - 2);
    line.type.resize(open);
    line.field.count = count.empty() || count.starts_with("<=") ? Count::kList : Count::kArray;
    if (line.field.count == Count::kArray &&
        std::from_chars(count.data(), count.data() + count.size(), line.field.size).ec != std::errc()) {
      return std::nullopt;
    }
  }
  // "string<=5"
  if (const std::size_t bound = line.type.find("<="); bound != std::string::npos) line.type.resize(bound);
  return line;
}

/// @return Whether the type contains itself, so that its values would have no end.
bool isEndless(const RosDefinition& definition, std::size_t type, std::size_t depth) {
  if (depth > definition.types.size()) return true;
  for (const RosField& field : definition.types[type]) {
    if (field.kind == Kind::kMessage && isEndless(definition, field.type, depth + 1)) return true;
  }
  return false;
}

}  // namespace

std::optional<RosDefinition> readDefinition(std::string_view text) {
  // the first type has no name
  std::vector<std::vector<Line>> types(1);
  std::map<std::string, std::size_t, std::less<>> names;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.empty() || line.starts_with("==")) continue;
    if (line.starts_with(kType)) {
      names.emplace(line.substr(kType.size()), types.size());
      types.emplace_back();
      continue;
    }
    std::optional<Line> field = fieldIn(line);
    if (!field) return std::nullopt;
    types.back().push_back(std::move(*field));
  }
  RosDefinition definition;
  for (std::vector<Line>& lines : types) {
    std::vector<RosField>& fields = definition.types.emplace_back();
    for (Line& line : lines) {
      const auto* const word = std::ranges::find(kWords, line.type, &std::pair<std::string_view, Kind>::first);
      line.field.kind = word == std::end(kWords) ? Kind::kMessage : word->second;
      if (line.field.kind == Kind::kMessage) {
        const auto found = names.find(line.type);
        if (found == names.end()) return std::nullopt;
        line.field.type = found->second;
      }
      fields.push_back(std::move(line.field));
    }
  }
  if (isEndless(definition, 0, 0)) return std::nullopt;
  return definition;
}

}  // namespace pongsim::web::rosbridge
