#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/bulk.hh"
#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::sensor_msgs {

struct BatteryState {
  static constexpr const char* kName = "sensor_msgs/msg/BatteryState";
  static constexpr std::uint8_t kPowerSupplyStatusUnknown = 0;
  static constexpr std::uint8_t kPowerSupplyStatusCharging = 1;
  static constexpr std::uint8_t kPowerSupplyStatusDischarging = 2;
  static constexpr std::uint8_t kPowerSupplyStatusNotCharging = 3;
  static constexpr std::uint8_t kPowerSupplyStatusFull = 4;
  static constexpr std::uint8_t kPowerSupplyHealthUnknown = 0;
  static constexpr std::uint8_t kPowerSupplyHealthGood = 1;
  static constexpr std::uint8_t kPowerSupplyHealthOverheat = 2;
  static constexpr std::uint8_t kPowerSupplyHealthDead = 3;
  static constexpr std::uint8_t kPowerSupplyHealthOvervoltage = 4;
  static constexpr std::uint8_t kPowerSupplyHealthUnspecFailure = 5;
  static constexpr std::uint8_t kPowerSupplyHealthCold = 6;
  static constexpr std::uint8_t kPowerSupplyHealthWatchdogTimerExpire = 7;
  static constexpr std::uint8_t kPowerSupplyHealthSafetyTimerExpire = 8;
  static constexpr std::uint8_t kPowerSupplyTechnologyUnknown = 0;
  static constexpr std::uint8_t kPowerSupplyTechnologyNimh = 1;
  static constexpr std::uint8_t kPowerSupplyTechnologyLion = 2;
  static constexpr std::uint8_t kPowerSupplyTechnologyLipo = 3;
  static constexpr std::uint8_t kPowerSupplyTechnologyLife = 4;
  static constexpr std::uint8_t kPowerSupplyTechnologyNicd = 5;
  static constexpr std::uint8_t kPowerSupplyTechnologyLimn = 6;
  std_msgs::Header header;
  float voltage = 0;
  float temperature = 0;
  float current = 0;
  float charge = 0;
  float capacity = 0;
  float design_capacity = 0;
  float percentage = 0;
  std::uint8_t power_supply_status = 0;
  std::uint8_t power_supply_health = 0;
  std::uint8_t power_supply_technology = 0;
  bool present = false;
  std::vector<float> cell_voltage;
  std::vector<float> cell_temperature;
  std::string location;
  std::string serial_number;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("voltage", self.voltage);
    field("temperature", self.temperature);
    field("current", self.current);
    field("charge", self.charge);
    field("capacity", self.capacity);
    field("design_capacity", self.design_capacity);
    field("percentage", self.percentage);
    field("power_supply_status", self.power_supply_status);
    field("power_supply_health", self.power_supply_health);
    field("power_supply_technology", self.power_supply_technology);
    field("present", self.present);
    field("cell_voltage", self.cell_voltage);
    field("cell_temperature", self.cell_temperature);
    field("location", self.location);
    field("serial_number", self.serial_number);
  }
  bool operator==(const BatteryState&) const = default;
};

struct RegionOfInterest {
  static constexpr const char* kName = "sensor_msgs/msg/RegionOfInterest";
  std::uint32_t x_offset = 0;
  std::uint32_t y_offset = 0;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  bool do_rectify = false;
  static void visit(auto& self, auto&& field) {
    field("x_offset", self.x_offset);
    field("y_offset", self.y_offset);
    field("height", self.height);
    field("width", self.width);
    field("do_rectify", self.do_rectify);
  }
  bool operator==(const RegionOfInterest&) const = default;
};

struct CameraInfo {
  static constexpr const char* kName = "sensor_msgs/msg/CameraInfo";
  std_msgs::Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string distortion_model;
  std::vector<double> d;
  std::array<double, 9> k{};
  std::array<double, 9> r{};
  std::array<double, 12> p{};
  std::uint32_t binning_x = 0;
  std::uint32_t binning_y = 0;
  RegionOfInterest roi;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("height", self.height);
    field("width", self.width);
    field("distortion_model", self.distortion_model);
    field("d", self.d);
    field("k", self.k);
    field("r", self.r);
    field("p", self.p);
    field("binning_x", self.binning_x);
    field("binning_y", self.binning_y);
    field("roi", self.roi);
  }
  bool operator==(const CameraInfo&) const = default;
};

struct FluidPressure {
  static constexpr const char* kName = "sensor_msgs/msg/FluidPressure";
  std_msgs::Header header;
  double fluid_pressure = 0;
  double variance = 0;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("fluid_pressure", self.fluid_pressure);
    field("variance", self.variance);
  }
  bool operator==(const FluidPressure&) const = default;
};

/// @param Bytes `BulkBytes` if the bytes are written to the wire directly from where they are.
template <class Bytes>
struct BasicImage {
  static constexpr const char* kName = "sensor_msgs/msg/Image";
  std_msgs::Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string encoding;
  std::uint8_t is_bigendian = 0;
  std::uint32_t step = 0;
  Bytes data;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("height", self.height);
    field("width", self.width);
    field("encoding", self.encoding);
    field("is_bigendian", self.is_bigendian);
    field("step", self.step);
    field("data", self.data);
  }
  bool operator==(const BasicImage&) const = default;
};
using Image = BasicImage<std::vector<std::uint8_t>>;

struct Imu {
  static constexpr const char* kName = "sensor_msgs/msg/Imu";
  std_msgs::Header header;
  geometry_msgs::Quaternion orientation;
  std::array<double, 9> orientation_covariance{};
  geometry_msgs::Vector3 angular_velocity;
  std::array<double, 9> angular_velocity_covariance{};
  geometry_msgs::Vector3 linear_acceleration;
  std::array<double, 9> linear_acceleration_covariance{};
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("orientation", self.orientation);
    field("orientation_covariance", self.orientation_covariance);
    field("angular_velocity", self.angular_velocity);
    field("angular_velocity_covariance", self.angular_velocity_covariance);
    field("linear_acceleration", self.linear_acceleration);
    field("linear_acceleration_covariance", self.linear_acceleration_covariance);
  }
  bool operator==(const Imu&) const = default;
};

struct JointState {
  static constexpr const char* kName = "sensor_msgs/msg/JointState";
  std_msgs::Header header;
  std::vector<std::string> name;
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> effort;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("name", self.name);
    field("position", self.position);
    field("velocity", self.velocity);
    field("effort", self.effort);
  }
  bool operator==(const JointState&) const = default;
};

struct Joy {
  static constexpr const char* kName = "sensor_msgs/msg/Joy";
  std_msgs::Header header;
  std::vector<float> axes;
  std::vector<std::int32_t> buttons;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("axes", self.axes);
    field("buttons", self.buttons);
  }
  bool operator==(const Joy&) const = default;
};

struct LaserScan {
  static constexpr const char* kName = "sensor_msgs/msg/LaserScan";
  std_msgs::Header header;
  float angle_min = 0;
  float angle_max = 0;
  float angle_increment = 0;
  float time_increment = 0;
  float scan_time = 0;
  float range_min = 0;
  float range_max = 0;
  std::vector<float> ranges;
  std::vector<float> intensities;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("angle_min", self.angle_min);
    field("angle_max", self.angle_max);
    field("angle_increment", self.angle_increment);
    field("time_increment", self.time_increment);
    field("scan_time", self.scan_time);
    field("range_min", self.range_min);
    field("range_max", self.range_max);
    field("ranges", self.ranges);
    field("intensities", self.intensities);
  }
  bool operator==(const LaserScan&) const = default;
};

struct MagneticField {
  static constexpr const char* kName = "sensor_msgs/msg/MagneticField";
  std_msgs::Header header;
  geometry_msgs::Vector3 magnetic_field;
  std::array<double, 9> magnetic_field_covariance{};
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("magnetic_field", self.magnetic_field);
    field("magnetic_field_covariance", self.magnetic_field_covariance);
  }
  bool operator==(const MagneticField&) const = default;
};

struct NavSatStatus {
  static constexpr const char* kName = "sensor_msgs/msg/NavSatStatus";
  static constexpr std::int8_t kStatusNoFix = -1;
  static constexpr std::int8_t kStatusFix = 0;
  static constexpr std::int8_t kStatusSbasFix = 1;
  static constexpr std::int8_t kStatusGbasFix = 2;
  static constexpr std::uint16_t kServiceGps = 1;
  static constexpr std::uint16_t kServiceGlonass = 2;
  static constexpr std::uint16_t kServiceCompass = 4;
  static constexpr std::uint16_t kServiceGalileo = 8;
  std::int8_t status = 0;
  std::uint16_t service = 0;
  static void visit(auto& self, auto&& field) {
    field("status", self.status);
    field("service", self.service);
  }
  bool operator==(const NavSatStatus&) const = default;
};

struct NavSatFix {
  static constexpr const char* kName = "sensor_msgs/msg/NavSatFix";
  static constexpr std::uint8_t kCovarianceTypeUnknown = 0;
  static constexpr std::uint8_t kCovarianceTypeApproximated = 1;
  static constexpr std::uint8_t kCovarianceTypeDiagonalKnown = 2;
  static constexpr std::uint8_t kCovarianceTypeKnown = 3;
  std_msgs::Header header;
  NavSatStatus status;
  double latitude = 0;
  double longitude = 0;
  double altitude = 0;
  std::array<double, 9> position_covariance{};
  std::uint8_t position_covariance_type = 0;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("status", self.status);
    field("latitude", self.latitude);
    field("longitude", self.longitude);
    field("altitude", self.altitude);
    field("position_covariance", self.position_covariance);
    field("position_covariance_type", self.position_covariance_type);
  }
  bool operator==(const NavSatFix&) const = default;
};

struct PointField {
  static constexpr const char* kName = "sensor_msgs/msg/PointField";
  static constexpr std::uint8_t kInt8 = 1;
  static constexpr std::uint8_t kUint8 = 2;
  static constexpr std::uint8_t kInt16 = 3;
  static constexpr std::uint8_t kUint16 = 4;
  static constexpr std::uint8_t kInt32 = 5;
  static constexpr std::uint8_t kUint32 = 6;
  static constexpr std::uint8_t kFloat32 = 7;
  static constexpr std::uint8_t kFloat64 = 8;
  std::string name;
  std::uint32_t offset = 0;
  std::uint8_t datatype = 0;
  std::uint32_t count = 0;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("offset", self.offset);
    field("datatype", self.datatype);
    field("count", self.count);
  }
  bool operator==(const PointField&) const = default;
};

/// @param Bytes `BulkBytes` if the bytes are written to the wire directly from where they are.
template <class Bytes>
struct BasicPointCloud2 {
  static constexpr const char* kName = "sensor_msgs/msg/PointCloud2";
  std_msgs::Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::vector<PointField> fields;
  bool is_bigendian = false;
  std::uint32_t point_step = 0;
  std::uint32_t row_step = 0;
  Bytes data;
  bool is_dense = false;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("height", self.height);
    field("width", self.width);
    field("fields", self.fields);
    field("is_bigendian", self.is_bigendian);
    field("point_step", self.point_step);
    field("row_step", self.row_step);
    field("data", self.data);
    field("is_dense", self.is_dense);
  }
  bool operator==(const BasicPointCloud2&) const = default;
};
using PointCloud2 = BasicPointCloud2<std::vector<std::uint8_t>>;

}  // namespace pongsim::ros2::sensor_msgs
