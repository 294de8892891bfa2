// Descriptions of SDF 1.9 and earlier taken from sdformat 12, Copyright 2012 Open Source Robotics Foundation, Apache
// License 2.0.
#include "sdf/schema/schema_table.hh"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "base/parse_number.hh"

namespace pongsim::sdf {

namespace {

// Each file is one string literal: a line with the names of the columns, then a row a line.
constexpr std::string_view kTables[] = {
#include "sdf/schema/tables/world.txt"
    ,
#include "sdf/schema/tables/model.txt"
    ,
#include "sdf/schema/tables/shape.txt"
    ,
#include "sdf/schema/tables/sensor.txt"
    ,
#include "sdf/schema/tables/camera.txt"
};

/// Removes the text up to the separator, and the separator.
/// @return That text without the spaces around it.
std::string_view takeUntil(char separator, std::string_view& text) {
  const std::size_t end = std::min(text.find(separator), text.size());
  std::string_view field = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  field.remove_prefix(std::min(field.find_first_not_of(' '), field.size()));
  return field.substr(0, field.find_last_not_of(' ') + 1);
}

/// @param field "OLD" or "OLD (VERSION: NEW)"
SchemaRow::Versioned<std::string_view> versionedText(std::string_view field) {
  const std::size_t begin = field.rfind(" (");
  const std::size_t colon = field.find(": ", begin == field.npos ? field.size() : begin);
  if (colon == field.npos || !field.ends_with(')')) return {.value = field};
  const auto version = base::parseInteger(field.substr(begin + 2, colon - begin - 2));
  if (!version) return {.value = field};
  const std::string_view later = field.substr(colon + 2, field.size() - colon - 3);
  return {field.substr(0, begin), static_cast<int>(*version), later};
}

SchemaRow rowIn(std::string_view line) {
  constexpr std::array<std::string_view, 3> kUses = {"read", "kept", "passed"};
  std::array<std::string_view, 7> fields;
  std::string_view rest = line;
  for (std::string_view& field : fields) field = takeUntil('|', rest);
  const auto [path, type, fallback, count, since, removedIn, use] = fields;
  const auto sinceVersion = base::parseInteger(since);
  const auto removal = base::parseInteger(removedIn.empty() ? "0" : removedIn);
  const auto usePlace = std::ranges::find(kUses, use);
  const SchemaRow::Versioned<std::string_view> counts = versionedText(count);
  if (counts.value.size() != 1 || (counts.changedIn != 0 && counts.later.size() != 1) || !sinceVersion || !removal ||
      usePlace == kUses.end()) {
    throw std::logic_error("bad row in the table of SDF: " + std::string(line));
  }
  return {path,
          type,
          versionedText(fallback),
          {counts.value.front(), counts.changedIn, counts.changedIn != 0 ? counts.later.front() : '0'},
          static_cast<int>(*sinceVersion),
          static_cast<int>(*removal),
          static_cast<Use>(usePlace - kUses.begin()),
          takeUntil('\n', rest)};
}

}  // namespace

const std::vector<SchemaRow>& schemaTable() {
  static const std::vector<SchemaRow> rows = [] {
    std::vector<SchemaRow> all;
    for (std::string_view table : kTables) {
      takeUntil('\n', table);  // the end of the line that opens the literal
      takeUntil('\n', table);  // the names of the columns
      while (!table.empty()) all.push_back(rowIn(takeUntil('\n', table)));
    }
    return all;
  }();
  return rows;
}

}  // namespace pongsim::sdf
