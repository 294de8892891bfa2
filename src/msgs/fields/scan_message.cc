#include "msgs/fields/scan_message.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "msgs/fields/field_reader.hh"
#include "msgs/fields/stamp.hh"

namespace pongsim::msgs {

ScanRow levelRowOf(const Message& scan) {
  const FieldReader reader(scan);
  ScanRow row;
  row.time = stampOf(scan).value_or(Time(0));
  row.firstAngle = reader.number("angle_min");
  row.angleStep = reader.number("angle_step");
  const std::vector<double> ranges = reader.numbers("ranges");
  const auto said = static_cast<std::size_t>(reader.whole("count"));
  const std::size_t count = said > 0 ? std::min(said, ranges.size()) : ranges.size();
  if (count == 0) return row;

  // the rows that are really present
  const auto rows =
      std::clamp<std::size_t>(static_cast<std::size_t>(reader.whole("vertical_count")), 1, ranges.size() / count);
  const double lowest = reader.number("vertical_angle_min"), step = reader.number("vertical_angle_step");
  const auto elevationOf = [lowest, step](std::size_t index) {
    return index == 0 ? lowest : lowest + static_cast<double>(index) * step;
  };
  std::size_t level = 0;
  for (std::size_t index = 1; index < rows; ++index) {
    if (std::abs(elevationOf(index)) < std::abs(elevationOf(level))) level = index;
  }
  row.elevation = elevationOf(level);
  const auto first = ranges.begin() + static_cast<std::ptrdiff_t>(level * count);
  row.ranges.assign(first, first + static_cast<std::ptrdiff_t>(count));
  return row;
}

}  // namespace pongsim::msgs
