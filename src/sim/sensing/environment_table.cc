#include "sim/sensing/environment_table.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "base/parse_number.hh"
#include "base/text.hh"

namespace pongsim::sim {

namespace {

constexpr std::string_view kSpace = " \t\r";

/// @return Without surrounding white space and double quotes.
std::string_view bare(std::string_view cell) {
  cell = base::trimmed(cell, kSpace);
  const bool isQuoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return isQuoted ? cell.substr(1, cell.size() - 2) : cell;
}

/// Takes the first line off a text.
/// @return Without its line break.
std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

void split(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(bare(line.substr(0, comma)));
    if (comma == std::string_view::npos) return;
    line.remove_prefix(comma + 1);
  }
}

/// Reads the lines below the header.
class Lines {
 public:
  /// @param named The columns with time and place.
  Lines(const std::vector<std::string_view>& header, const std::array<std::size_t, 4>& named, EnvironmentTable& table)
      : header_(header), named_(named), table_(table) {}

  /// @return Why the line can't be read; empty if it could be.
  std::string add(const std::vector<std::string_view>& cells) {
    if (cells.size() != header_.size()) {
      return "has " + std::to_string(cells.size()) + " cells, where the first line has " +
             std::to_string(header_.size());
    }
    EnvironmentTable::Row row;
    row.index = table_.rows.size();
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::optional<double> number = base::parseDouble(cells[i]);
      if (!number || !std::isfinite(*number)) {
        return "has '" + std::string(cells[i].substr(0, 40)) + "' in the column '" + std::string(header_[i]) +
               "', which is not a finite number";
      }
      const auto column = std::ranges::find(named_, i);
      if (column != named_.end()) {
        numbers[static_cast<std::size_t>(column - named_.begin())] = *number;
      } else {
        table_.values.push_back(*number);
      }
    }
    row.time = numbers[0];
    row.place = {numbers[1], numbers[2], numbers[3]};
    table_.rows.push_back(row);
    return {};
  }

 private:
  const std::vector<std::string_view>& header_;
  const std::array<std::size_t, 4>& named_;
  EnvironmentTable& table_;
};

}  // namespace

Outcome<void> EnvironmentTable::read(std::string_view csv, const EnvironmentSettings& settings) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (csv.starts_with(kByteOrderMark)) csv.remove_prefix(kByteOrderMark.size());
  std::vector<std::string_view> header;
  split(takeLine(csv), header);
  if (header == std::vector<std::string_view>{""}) return {"its first line has no names of columns"};
  const std::array<std::string_view, 4> names{settings.timeColumn, settings.placeColumns[0], settings.placeColumns[1],
                                              settings.placeColumns[2]};
  std::array<std::size_t, 4> named{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = std::ranges::find(header, names[i]);
    if (found == header.end()) {
      return {"it has no column '" + std::string(names[i]) + "', but " + base::listed(header)};
    }
    named[i] = static_cast<std::size_t>(found - header.begin());
    if (std::find(named.begin(), named.begin() + static_cast<std::ptrdiff_t>(i), named[i]) !=
        named.begin() + static_cast<std::ptrdiff_t>(i)) {
      return {"the column '" + std::string(names[i]) + "' can't be used twice"};
    }
  }
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (std::ranges::find(named, i) == named.end()) quantities.emplace_back(header[i]);
  }
  Lines lines(header, named, *this);
  std::vector<std::string_view> cells;
  for (std::size_t number = 2; !csv.empty(); ++number) {
    split(takeLine(csv), cells);
    if (cells.size() == 1 && cells.front().empty()) continue;
    if (const std::string why = lines.add(cells); !why.empty()) return {"line " + std::to_string(number) + " " + why};
  }
  if (rows.empty()) return {"it has no values"};
  return {};
}

}  // namespace pongsim::sim
