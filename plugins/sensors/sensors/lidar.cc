#include "lidar.hh"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "point_cloud.hh"
#include "pongsim/math.hh"
#include "pongsim/messages/fields.hh"

namespace pongsim {

namespace {

using ignition::msgs::LaserScan;
using ignition::msgs::PointCloudPacked;

// gives a scan message of 16 MB
constexpr std::uint32_t kMostBeams = 1'000'000;

constexpr std::uint32_t kIntensityOffset = 16, kRingOffset = 24;
/// As in Fortress.
constexpr PointField kPointFields[] = {{"x", 0, PointCloudPacked::Field::FLOAT32},
                                       {"y", 4, PointCloudPacked::Field::FLOAT32},
                                       {"z", 8, PointCloudPacked::Field::FLOAT32},
                                       {"intensity", kIntensityOffset, PointCloudPacked::Field::FLOAT32},
                                       {"ring", kRingOffset, PointCloudPacked::Field::UINT16}};

/// @return The number of beams in a row or a column; one more than the limit if there are too many.
std::uint32_t beamCount(const LidarSettings::Scan& scan) {
  const double count = std::floor(scan.samples * scan.resolution);
  return static_cast<std::uint32_t>(std::clamp(count, 1.0, kMostBeams + 1.0));
}

/// @return Angle between two beams [rad].
double angleStep(const LidarSettings::Scan& scan, std::uint32_t count) {
  return count > 1 ? (scan.maxAngle - scan.minAngle) / (count - 1) : 0;
}

/// @throws Error if there are too many beams.
std::pair<std::uint32_t, std::uint32_t> checkedCounts(const Sensor& sensor, const LidarSettings& settings) {
  const std::uint32_t columns = beamCount(settings.horizontal), rows = beamCount(settings.vertical);
  if (std::uint64_t{columns} * rows > kMostBeams) {
    throw Error({Severity::kError, sensor.sdf().position,
                 "lidar '" + sensor.scopedName() + "' has more than " + std::to_string(kMostBeams) + " beams",
                 "the number of beams is samples times resolution, horizontally times vertically"});
  }
  return {columns, rows};
}

void fillInFixed(const LidarSettings& settings, std::uint32_t columns, std::uint32_t rows, LaserScan& scan) {
  scan.set_angle_min(settings.horizontal.minAngle);
  scan.set_angle_max(settings.horizontal.maxAngle);
  scan.set_angle_step(angleStep(settings.horizontal, columns));
  scan.set_count(columns);
  scan.set_vertical_angle_min(settings.vertical.minAngle);
  scan.set_vertical_angle_max(settings.vertical.maxAngle);
  scan.set_vertical_angle_step(angleStep(settings.vertical, rows));
  scan.set_vertical_count(rows);
  scan.set_range_min(settings.minRange);
  scan.set_range_max(settings.maxRange);
  scan.mutable_ranges()->Resize(static_cast<int>(columns * rows), 0);
  scan.mutable_intensities()->Resize(static_cast<int>(columns * rows), 0);
}

}  // namespace

LidarSensor::LidarSensor(const SensorContext& context, LidarSurroundings& surroundings)
    : SensorOf(context),
      sensor_(context.sensor),
      settings_(*sensor_.settings<LidarSettings>()),
      surroundings_(surroundings),
      noise_(context.noises.add(settings_.noise, "range")) {
  const auto [columns, rows] = checkedCounts(sensor_, settings_);
  message().set_frame(sensor_.frameName());
  fillInFixed(settings_, columns, rows, message());
  beginCloud(kPointFields, columns, rows, cloud_);
  echoes_.resize(std::size_t{columns} * rows);
  directions_.reserve(echoes_.size());
  const double stepX = angleStep(settings_.horizontal, columns), stepZ = angleStep(settings_.vertical, rows);
  for (std::uint32_t row = 0; row < rows; ++row) {
    const double up = settings_.vertical.minAngle + row * stepZ;
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double left = settings_.horizontal.minAngle + column * stepX;
      directions_.emplace_back(math::cos(up) * math::cos(left), math::cos(up) * math::sin(left), math::sin(up));
    }
  }
  points_ = context.advertise(SensorReadings::kPoints);
}

void LidarSensor::measure() {
  LaserScan& scan = message();
  surroundings_.now().cast(sensor_, directions_, settings_.minRange, settings_.maxRange, settings_.visibilityMask,
                           echoes_);
  surroundings_.now().scatter(sensor_, directions_, settings_.minRange, settings_.maxRange, echoes_);
  setPose(sensor_.pose(), *scan.mutable_world_pose());
  double* ranges = scan.mutable_ranges()->mutable_data();
  double* intensities = scan.mutable_intensities()->mutable_data();
  for (const Echo& echo : echoes_) {
    double range = echo.range;
    if (noise_.isOn() && std::isfinite(range)) {
      range = std::clamp(noise_.apply(range), settings_.minRange, settings_.maxRange);
    }
    *ranges++ = range;
    *intensities++ = echo.intensity;
  }
}

void LidarSensor::publishElsewhere() {
  if (!points_.hasSubscribers()) return;
  *cloud_.mutable_header() = message().header();
  cloud_.set_is_dense(std::ranges::all_of(message().ranges(), [](double range) { return std::isfinite(range); }));
  points_.publish(
      cloud_, {.size = directions_.size() * kPointSize, .write = [this](std::span<std::byte> to) { writePoints(to); }});
}

void LidarSensor::writePoints(std::span<std::byte> to) const {
  const LaserScan& scan = message();
  std::byte* point = to.data();
  for (std::size_t i = 0; i < directions_.size(); ++i, point += kPointSize) {
    const double range = scan.ranges(static_cast<int>(i));
    // as in Fortress, infinite or NaN where the range is infinite
    const Eigen::Vector3f place = (range * directions_[i]).cast<float>();
    const auto intensity = static_cast<float>(scan.intensities(static_cast<int>(i)));
    const auto ring = static_cast<std::uint16_t>(i / cloud_.width());
    std::memset(point, 0, kPointSize);
    std::memcpy(point, place.data(), sizeof(float) * 3);
    std::memcpy(point + kIntensityOffset, &intensity, sizeof(intensity));
    std::memcpy(point + kRingOffset, &ring, sizeof(ring));
  }
}

}  // namespace pongsim
