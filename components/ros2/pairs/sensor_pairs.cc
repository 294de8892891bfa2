// sensor_msgs except images, clouds and joints; gps_msgs
#include <ignition/msgs/battery_state.pb.h>
#include <ignition/msgs/fluid_pressure.pb.h>
#include <ignition/msgs/imu.pb.h>
#include <ignition/msgs/joy.pb.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/magnetometer.pb.h>
#include <ignition/msgs/navsat.pb.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "pongsim/math.hh"
#include "ros2/pairs/convert.hh"
#include "ros2/pairs/pairs.hh"
#include "ros2/types/gps_msgs.hh"
#include "ros2/types/sensor_msgs.hh"

namespace pongsim::ros2 {

namespace {

struct LaserScanPair {
  using Ros = sensor_msgs::LaserScan;
  using Ignition = ignition::msgs::LaserScan;
  static void convert(const Ignition& from, Ros& to, const Frames& frames);
  static void convert(const Ros& from, Ignition& to, const Frames& frames);
};

void LaserScanPair::convert(const Ignition& from, Ros& to, const Frames& frames) {
  ros2::convert(from.header(), to.header, frames);
  frames.toRos(from.frame(), to.header.frame_id);
  to.angle_min = static_cast<float>(from.angle_min());
  to.angle_max = static_cast<float>(from.angle_max());
  to.angle_increment = static_cast<float>(from.angle_step());
  to.range_min = static_cast<float>(from.range_min());
  to.range_max = static_cast<float>(from.range_max());
  // of several rows the middle one, as in ros_gz
  const std::uint64_t count = from.count(), begin = from.vertical_count() / 2 * count;
  const auto copyRow = [&](const auto& all, std::vector<float>& row) {
    row.clear();
    // a message may claim any number of them
    const std::uint64_t end = std::min(begin + count, static_cast<std::uint64_t>(all.size()));
    for (std::uint64_t i = begin; i < end; ++i) row.push_back(static_cast<float>(all.Get(static_cast<int>(i))));
  };
  copyRow(from.ranges(), to.ranges);
  copyRow(from.intensities(), to.intensities);
}

void LaserScanPair::convert(const Ros& from, Ignition& to, const Frames& frames) {
  ros2::convert(from.header, *to.mutable_header(), frames);
  to.set_frame(std::string(frames.fromRos(from.header.frame_id)));
  to.set_angle_min(static_cast<double>(from.angle_min));
  to.set_angle_max(static_cast<double>(from.angle_max));
  to.set_angle_step(static_cast<double>(from.angle_increment));
  to.set_range_min(static_cast<double>(from.range_min));
  to.set_range_max(static_cast<double>(from.range_max));
  to.set_count(static_cast<std::uint32_t>(from.ranges.size()));
  to.mutable_ranges()->Assign(from.ranges.begin(), from.ranges.end());
  to.mutable_intensities()->Assign(from.intensities.begin(), from.intensities.end());
}

/// @return The covariance matrix, row by row, of values that are independent of each other.
std::array<double, 9> diagonal(const std::array<double, 3>& variances) {
  return {variances[0], 0, 0, 0, variances[1], 0, 0, 0, variances[2]};
}

/// As in Fortress, the noise of horizontal positions is in degrees.
/// @return East, north, up [m^2].
std::array<double, 9> positionCovariance(double latitude, const Variances& variances) {
  // on the sphere of the equator's radius, 0.7 % from the ellipsoid at most
  constexpr double kRadius = 6378137, kDegree = std::numbers::pi / 180;
  const double north = kRadius * kDegree;
  const double east = north * math::cos(latitude * kDegree);
  const auto& [eastDegrees, northDegrees, up] = variances.reading;
  return diagonal({east * east * eastDegrees, north * north * northDegrees, up});
}

struct ImuPair {
  using Ros = sensor_msgs::Imu;
  using Ignition = ignition::msgs::IMU;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    ros2::convert(from.orientation(), to.orientation);
    ros2::convert(from.angular_velocity(), to.angular_velocity);
    ros2::convert(from.linear_acceleration(), to.linear_acceleration);
    // REP 145: an IMU without an orientation says so
    to.orientation_covariance = {from.has_orientation() ? 0.0 : -1.0};
    to.angular_velocity_covariance = diagonal(frames.variances.reading);
    to.linear_acceleration_covariance = diagonal(frames.variances.acceleration);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_entity_name(std::string(frames.fromRos(from.header.frame_id)));
    ros2::convert(from.orientation, *to.mutable_orientation());
    ros2::convert(from.angular_velocity, *to.mutable_angular_velocity());
    ros2::convert(from.linear_acceleration, *to.mutable_linear_acceleration());
  }
};

struct MagneticFieldPair {
  using Ros = sensor_msgs::MagneticField;
  using Ignition = ignition::msgs::Magnetometer;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    ros2::convert(from.field_tesla(), to.magnetic_field);
    to.magnetic_field_covariance = diagonal(frames.variances.reading);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    ros2::convert(from.magnetic_field, *to.mutable_field_tesla());
  }
};

struct FluidPressurePair {
  using Ros = sensor_msgs::FluidPressure;
  using Ignition = ignition::msgs::FluidPressure;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.fluid_pressure = from.pressure();
    // that in the message is Fortress's: the root of the standard deviation
    to.variance = frames.variances == Variances{} ? from.variance() : frames.variances.reading[0];
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_pressure(from.fluid_pressure);
    to.set_variance(from.variance);
  }
};

struct NavSatFixPair {
  using Ros = sensor_msgs::NavSatFix;
  using Ignition = ignition::msgs::NavSat;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    if (!from.frame_id().empty()) frames.toRos(from.frame_id(), to.header.frame_id);
    to.status.status = sensor_msgs::NavSatStatus::kStatusFix;
    to.latitude = from.latitude_deg();
    to.longitude = from.longitude_deg();
    to.altitude = from.altitude();
    to.position_covariance = positionCovariance(from.latitude_deg(), frames.variances);
    to.position_covariance_type = frames.variances == Variances{}
                                      ? sensor_msgs::NavSatFix::kCovarianceTypeUnknown
                                      : sensor_msgs::NavSatFix::kCovarianceTypeDiagonalKnown;
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    to.Clear();
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_frame_id(std::string(frames.fromRos(from.header.frame_id)));
    to.set_latitude_deg(from.latitude);
    to.set_longitude_deg(from.longitude);
    to.set_altitude(from.altitude);
  }
};

/// Ground speed and its direction, anticlockwise from east as in ros_gz [rad].
struct GpsFixPair {
  using Ros = gps_msgs::GPSFix;
  using Ignition = ignition::msgs::NavSat;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    if (!from.frame_id().empty()) frames.toRos(from.frame_id(), to.header.frame_id);
    to.status.status = gps_msgs::GPSStatus::kStatusGbasFix;
    to.latitude = from.latitude_deg();
    to.longitude = from.longitude_deg();
    to.altitude = from.altitude();
    to.speed = math::hypot(from.velocity_east(), from.velocity_north());
    to.track = math::atan2(from.velocity_north(), from.velocity_east());
    to.climb = from.velocity_up();
    to.position_covariance = positionCovariance(from.latitude_deg(), frames.variances);
    to.position_covariance_type = frames.variances == Variances{} ? gps_msgs::GPSFix::kCovarianceTypeUnknown
                                                                  : gps_msgs::GPSFix::kCovarianceTypeDiagonalKnown;
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_frame_id(std::string(frames.fromRos(from.header.frame_id)));
    to.set_latitude_deg(from.latitude);
    to.set_longitude_deg(from.longitude);
    to.set_altitude(from.altitude);
    to.set_velocity_east(math::cos(from.track) * from.speed);
    to.set_velocity_north(math::sin(from.track) * from.speed);
    to.set_velocity_up(from.climb);
  }
};

/// Both types number the states of the supply in the same way.
struct BatteryStatePair {
  using Ros = sensor_msgs::BatteryState;
  using Ignition = ignition::msgs::BatteryState;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.voltage = static_cast<float>(from.voltage());
    to.temperature = std::numeric_limits<float>::quiet_NaN();
    to.current = static_cast<float>(from.current());
    to.charge = static_cast<float>(from.charge());
    to.capacity = static_cast<float>(from.capacity());
    to.design_capacity = std::numeric_limits<float>::quiet_NaN();
    to.percentage = static_cast<float>(from.percentage());
    to.power_supply_status = static_cast<std::uint8_t>(from.power_supply_status());
    to.power_supply_health = sensor_msgs::BatteryState::kPowerSupplyHealthUnknown;
    to.power_supply_technology = sensor_msgs::BatteryState::kPowerSupplyTechnologyUnknown;
    to.present = true;
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_voltage(static_cast<double>(from.voltage));
    to.set_current(static_cast<double>(from.current));
    to.set_charge(static_cast<double>(from.charge));
    to.set_capacity(static_cast<double>(from.capacity));
    to.set_percentage(static_cast<double>(from.percentage));
    const int status = from.power_supply_status;
    to.set_power_supply_status(Ignition::PowerSupplyStatus_IsValid(status)
                                   ? static_cast<Ignition::PowerSupplyStatus>(status)
                                   : Ignition::UNKNOWN);
  }
};

struct JoyPair {
  using Ros = sensor_msgs::Joy;
  using Ignition = ignition::msgs::Joy;
  static constexpr bool kMustBeFinite = true;
  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    copyNumbers(from.axes(), to.axes);
    copyNumbers(from.buttons(), to.buttons);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    to.Clear();
    ros2::convert(from.header, *to.mutable_header(), frames);
    addNumbers(from.axes, to.mutable_axes());
    addNumbers(from.buttons, to.mutable_buttons());
  }
};

}  // namespace

std::vector<Pair> sensorPairs() {
  return {pairOf<LaserScanPair>(Choice::kDefault),     pairOf<ImuPair>(Choice::kDefault),
          pairOf<MagneticFieldPair>(Choice::kDefault), pairOf<FluidPressurePair>(Choice::kDefault),
          pairOf<NavSatFixPair>(Choice::kDefault),     pairOf<GpsFixPair>(Choice::kOnRequest),
          pairOf<BatteryStatePair>(Choice::kDefault),  pairOf<JoyPair>(Choice::kDefault)};
}

}  // namespace pongsim::ros2
