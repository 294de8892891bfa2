#include "sdf/readers/sensors/lidar_reader.hh"

#include <limits>
#include <string_view>

#include "sdf/readers/sensors/noise_reader.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

LidarSettings::Scan readScan(const Element& element, LidarSettings::Scan scan, const std::string& label,
                             Context& context) {
  scan.samples = static_cast<std::uint32_t>(
      readInteger(element, "samples", scan.samples, 1, std::numeric_limits<std::uint32_t>::max(), context));
  scan.resolution = readPositive(element, "resolution", scan.resolution, context);
  scan.minAngle = readNumber(element, "min_angle", scan.minAngle, context);
  scan.maxAngle = readNumber(element, "max_angle", scan.maxAngle, context);
  if (scan.minAngle > scan.maxAngle) {
    context.diagnostics.error(element.position,
                              "the " + element.name + " scan of " + label + " has a <min_angle> above its <max_angle>");
  }
  return scan;
}

void readRange(const Element& element, LidarSettings& lidar, const std::string& label, Context& context) {
  lidar.minRange = readNotNegative(element, "min", lidar.minRange, context);
  lidar.maxRange = readLimit(element, "max", lidar.maxRange, context);
  lidar.rangeResolution = readNotNegative(element, "resolution", lidar.rangeResolution, context);
  if (lidar.minRange > lidar.maxRange) {
    context.diagnostics.error(element.position, label + " sees nothing: <min> of its range is above <max>");
  }
}

}  // namespace

LidarSettings readLidar(const Element* element, const std::string& label, Context& context) {
  LidarSettings lidar;
  if (element == nullptr) return lidar;
  if (const Element* scan = element->child("scan")) {
    if (const Element* horizontal = scan->child("horizontal")) {
      lidar.horizontal = readScan(*horizontal, lidar.horizontal, label, context);
    }
    if (const Element* vertical = scan->child("vertical")) {
      lidar.vertical = readScan(*vertical, lidar.vertical, label, context);
    }
  }
  if (const Element* range = element->child("range")) readRange(*range, lidar, label, context);
  lidar.visibilityMask = readUnsigned(*element, "visibility_mask", lidar.visibilityMask, context);
  lidar.noise = readNoiseIn(element, NoiseSettings::Type::kGaussian, context);
  return lidar;
}

}  // namespace pongsim::sdf
